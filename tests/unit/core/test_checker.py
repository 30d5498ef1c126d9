"""A checker looks again at what has changed, and at whom that concerns."""

from app.core.check import Checker, Problem
from app.core.edits import rename_automaton, set_note, set_parameters
from app.core.project import Project
from tests.samples import AGENT, project, vocabulary


def unused(changed: Project, *automata: str) -> Project:
    """Automata with a parameter more, which nothing is bound to: a warning each."""
    for key in automata:
        parameters = changed.library(AGENT).get(key).parameters
        changed = set_parameters(changed, AGENT, key, (*parameters, "idle"))
    return changed


def told(problems: tuple[Problem, ...], key: str) -> list[Problem]:
    return [problem for problem in problems if problem.file.endswith(f"{key}.json")]


def test_automata_that_stayed_are_not_looked_at_again() -> None:
    checker, first = Checker(), unused(project(), "wander", "goto")
    before = checker.check(first, vocabulary())
    after = checker.check(set_note(first, AGENT, "goto", "another note"), vocabulary())
    assert after == before
    for old, new in zip(told(before, "wander"), told(after, "wander"), strict=True):
        assert old is new
    assert told(before, "wander")
    assert all(new is not old for old, new in zip(told(before, "goto"), told(after, "goto"), strict=True))


def test_those_that_hold_it_are() -> None:
    checker, first = Checker(), project()
    checker.check(first, vocabulary())
    open_slots = told(checker.check(unused(first, "goto"), vocabulary()), "fetch")
    assert any("'idle' of goto is open" in problem.message for problem in open_slots)
    renamed = rename_automaton(unused(first, "goto"), AGENT, "goto", "Approach")
    messages = [problem.message for problem in told(checker.check(renamed, vocabulary()), "fetch")]
    assert any("'idle' of Approach is open" in message for message in messages)
