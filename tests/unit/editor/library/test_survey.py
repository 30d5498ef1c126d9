"""What the library lists, and what it works out again."""

from pathlib import Path

import pytest

from app.core.edits import add_rule, rename_automaton, set_note
from app.core.library import Library
from app.core.project import Project
from app.core.storage import load
from app.editor.library.filtering import matches
from app.editor.library.fits import fit_of
from app.editor.library.survey import Group, Kind, Row, RowKey, Surveyor, from_the_top
from app.editor.searching import words_in
from app.engine.scenarios import open_scenario
from app.learner.freshness import Freshness

FORAGING = Path(__file__).parents[4] / "projects" / "foraging"


@pytest.fixture(scope="module")
def project() -> Project:
    return load(FORAGING)


def survey(project: Project, surveyor: Surveyor | None = None, arm: str = "one level") -> tuple[Group, ...]:
    types = project.types_with(open_scenario(project).vocabulary)
    return (surveyor or Surveyor()).survey(project, types, project.arm(arm))


def rows(groups: tuple[Group, ...]) -> dict[RowKey, Row]:
    return {row.key: row for group in groups for row in group.rows}


def test_types_of_the_arm_come_first_and_kinds_are_told_apart(project: Project) -> None:
    found = [(group.type, group.kind, group.current) for group in survey(project)]
    assert found[:4] == [
        ("agent", Kind.LEARNED, True),
        ("agent", Kind.BASIC, True),
        ("group", Kind.LEARNED, True),
        ("group", Kind.DERIVED, True),
    ]
    assert ("authored-agent", Kind.AUTHORED, False) in found


def test_those_that_hold_others_stand_above_them(project: Project) -> None:
    order = from_the_top(project.library("agent"))
    assert order.index("forage") < order.index("return-with-box") < order.index("goto")


def test_users_are_states_controllers_and_arms(project: Project) -> None:
    users = rows(survey(project))[RowKey("agent", "forage")].used_by
    words = [use.words for use in users]
    assert "state Forage of ControlForage (group)" in words
    assert "arm 'independent'" in words
    assert users[words.index("arm 'independent'")].key is None


def test_only_the_row_that_an_edit_concerns_is_another_value(project: Project) -> None:
    surveyor = Surveyor()
    before = rows(survey(project, surveyor))
    after = rows(survey(set_note(project, "agent", "goto", "new"), surveyor))
    assert {key for key in after if after[key] != before[key]} == {RowKey("agent", "goto")}


def test_a_rename_changes_the_users_that_name_it(project: Project) -> None:
    after = rows(survey(rename_automaton(project, "agent", "goto", "Aim")))
    assert "Aim" in [use.words for use in after[RowKey("agent", "return-with-box")].uses]


def test_an_automaton_with_rules_alone_is_authored_and_one_with_nothing_is_to_be_taught(
    project: Project,
) -> None:
    project, _ = add_rule(project, "agent", "goto", "start", "start")
    assert rows(survey(project))[RowKey("agent", "goto")].kind is Kind.LEARNED  # it has examples


def test_a_cycle_is_listed_all_the_same(project: Project) -> None:
    from dataclasses import replace

    from app.core.automaton import Nested, State

    library = project.library("agent")
    goto = library.get("goto")
    looped = replace(goto, states=(*goto.states, State("again", Nested("forage"))))
    assert len(from_the_top(Library({**library.automata, "goto": looped}))) == len(library.automata)


def test_the_filter_looks_where_it_is_told(project: Project) -> None:
    row = rows(survey(project))[RowKey("agent", "goto")]

    def words(_row: Row) -> tuple[tuple[str, ...], tuple[str, ...]]:
        return ("DistanceTo(X)",), ("Forward", "left")

    assert matches(row, words_in("goto"), words)
    assert matches(row, words_in("feature:distance state:left"), words)
    assert not matches(row, words_in("feature:left"), words)
    assert not matches(row, words_in("state:distance"), words)


def test_a_fit_says_how_many_examples_its_models_get_right(project: Project) -> None:
    fit = fit_of(project, open_scenario(project).vocabulary, ("agent", "goto"), Freshness())
    assert fit.share == 1.0
    assert not fit.stale
    assert fit.words.startswith("fits 100% of ")
