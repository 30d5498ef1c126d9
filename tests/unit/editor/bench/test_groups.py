"""Every group of the studio's figures can be measured, in a small size; what they measure is what they say."""

from functools import partial
from math import isfinite
from pathlib import Path

import pytest

from app.cli.studio_figures import studio_measures
from app.core.storage import load
from app.editor.bench import automata, library
from app.editor.bench.groups import GROUPS, Order
from app.editor.bench.heartbeat import percentile
from app.engine.bench.table import MEASURES

FORAGING = Path(__file__).parents[4] / "projects" / "foraging"


@pytest.mark.parametrize("group", GROUPS)
@pytest.mark.qt_log_ignore("This plugin does not support")
def test_every_group_gives_the_figures_that_measures_take_from_it(group: str) -> None:
    figures = GROUPS[group](Order(FORAGING, shrink=40))
    takes = [one.take for one in studio_measures() if _group(one) == group]
    wanted = [take.keywords["figure"] for take in takes if isinstance(take, partial)]
    assert len(wanted) == len(takes)
    assert sorted(figures) == sorted(wanted)
    assert all(isfinite(value) and value >= 0.0 for value in figures.values())


def _group(one: object) -> str:
    keywords: dict[str, str] = getattr(getattr(one, "take", None), "keywords", {})
    return keywords.get("group", "")


def test_names_differ_from_those_of_the_engine() -> None:
    names = [one.name for one in (*MEASURES, *studio_measures())]
    assert len(set(names)) == len(names)


def test_a_large_automaton_has_so_many_states_and_transitions() -> None:
    project = automata.large(load(FORAGING), 40, 120)
    automaton = project.library("agent").get("large")
    assert (len(automaton.states), len(automaton.rules)) == (40, 120)
    assert len({(rule.source, rule.target) for rule in automaton.rules}) == 120


def test_a_large_project_has_so_many_behaviors_and_examples_and_nothing_is_stale() -> None:
    from app.learner.trainer import is_stale

    before = load(FORAGING)
    project = library.large(before, 5, 400)
    added = [name for name in project.library("agent").automata if name.startswith("b")]
    assert len(added) == 5
    assert sum(len(project.examples_of("agent", name)) for name in added) == 400
    assert not any(is_stale(project, "agent", name) for name in added)


def test_a_percentile_is_a_value_that_was_there() -> None:
    assert percentile([3.0, 1.0, 2.0], 0.5) == 2.0
    assert percentile([float(k) for k in range(100)], 0.99) == 98.0
    assert percentile([5.0], 1.0) == 5.0
