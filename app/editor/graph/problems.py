"""What is wrong with the automata that are shown, at the place where it is wrong."""

import re
from collections.abc import Iterable, Iterator

from ...core.automaton import Automaton
from ...core.check.automata import automaton_problems
from ...core.check.features import feature_problems
from ...core.check.problem import Problem
from ...core.check.scope import Scope, Subject
from ...core.check.transitions import transition_problems
from ...core.examples import Example

#: A state by id, or an edge by source and target.
Spot = tuple[str] | tuple[str, str]
PLACE = re.compile(r"(states|rules|prunes)\[(\d+)\]")
LEARNED = re.compile(r'learned(?:\.(\w+)|\["([^"]+)"\])')


def problems_of(scope: Scope, automaton: Automaton, examples: tuple[Example, ...]) -> tuple[Problem, ...]:
    """All that is wrong with one automaton by itself."""
    subject = Subject(scope, automaton)
    return (*automaton_problems(subject), *feature_problems(subject), *transition_problems(subject, examples))


def spots(automaton: Automaton, problems: Iterable[Problem]) -> dict[Spot, list[Problem]]:
    """Problems by where they show in the graph; those of other parts are left out."""
    found: dict[Spot, list[Problem]] = {}
    for problem in problems:
        for spot in _spot(automaton, problem.where):
            found.setdefault(spot, []).append(problem)
    return found


def _spot(automaton: Automaton, where: str) -> Iterator[Spot]:
    if learned := LEARNED.match(where):
        yield (learned[1] or learned[2],)
        return
    place = PLACE.match(where)
    if place is None:
        return
    index = int(place[2])
    if place[1] == "states" and index < len(automaton.states):
        yield (automaton.states[index].id,)
    elif place[1] == "rules" and index < len(automaton.rules):
        rule = automaton.rules[index]
        yield rule.source, rule.target
    elif place[1] == "prunes" and index < len(automaton.prunes):
        yield (automaton.prunes[index].source,)


def worst(problems: Iterable[Problem]) -> str:
    """The severity of the worst of them: "error" if there is one, otherwise "warning"."""
    return "error" if any(problem.severity == "error" for problem in problems) else "warning"
