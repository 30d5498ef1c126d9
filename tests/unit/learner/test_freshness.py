"""Which automata are stale is worked out again only for those that would be learned from something else."""

from collections.abc import Sequence

import pytest

from app.core.automaton import Automaton
from app.core.edits import disable_examples, note_project, rename_automaton
from app.core.examples import Example
from app.learner import freshness as module
from app.learner.freshness import Freshness
from app.learner.trainer import apply, fingerprint, learn
from tests.samples import AGENT, project, vocabulary

KEY = (AGENT, "goto")


@pytest.fixture
def worked_out(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The automata whose fingerprints were worked out, in this order."""
    found: list[str] = []

    def noted(automaton: Automaton, examples: Sequence[Example]) -> str:
        found.append(automaton.id)
        return fingerprint(automaton, examples)

    monkeypatch.setattr(module, "fingerprint", noted)
    return found


def test_names_and_what_was_learned_change_nothing(worked_out: list[str]) -> None:
    freshness, first = Freshness(), project()
    assert freshness.is_stale(first, KEY)
    learned = apply(first, learn(first, vocabulary(), [KEY]))
    assert not freshness.is_stale(learned, KEY)
    assert not freshness.is_stale(note_project(rename_automaton(learned, *KEY, "Go"), "note"), KEY)
    assert worked_out == ["goto"]


def test_an_example_that_is_disabled_makes_it_stale(worked_out: list[str]) -> None:
    freshness, first = Freshness(), project()
    learned = apply(first, learn(first, vocabulary(), [KEY]))
    freshness.is_stale(learned, KEY)
    example = learned.examples_of(*KEY)[0].id
    assert freshness.is_stale(disable_examples(learned, *KEY, [example]), KEY)
    assert worked_out == ["goto", "goto"]


def test_one_without_examples_is_never_stale(worked_out: list[str]) -> None:
    assert not Freshness().is_stale(project(), (AGENT, "forage"))
    assert not worked_out
