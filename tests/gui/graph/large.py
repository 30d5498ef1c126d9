"""An automaton with many states and edges."""

from dataclasses import replace

from app.core.automaton import START, Automaton, Basic, Rule, State
from app.core.conditions import AtMost, Condition, Guard
from app.core.features import FeatureUse, TicksInState
from app.core.library import Library
from app.core.project import Project
from app.editor.selection import BehaviorKey

KEY = BehaviorKey("agent", "large")


def large(states: int = 40, edges: int = 120) -> Project:
    """A project with one authored automaton of so many states and edges."""
    names = [START, *(f"s{number}" for number in range(1, states))]
    pairs = dict.fromkeys((k % states, (7 * k + 1 + k // states) % states) for k in range(4 * edges))
    rules = tuple(
        Rule(str(number), names[source], _guard(number), names[target])
        for number, (source, target) in enumerate(list(pairs)[:edges], 1)
    )
    held = tuple(State(name, Basic("Forward"), f"State {name}") for name in names[1:])
    automaton = Automaton("large", "Large", features=(FeatureUse("ticks", TicksInState()),), rules=rules)
    automaton = replace(automaton, states=(*automaton.states, *held))
    return Project("Large", "foraging", libraries={"agent": Library({"large": automaton})})


def _guard(number: int) -> Guard:
    return (Condition(AtMost("ticks", float(number))),)
