"""How soon a large automaton shows what was edited, and how long Graphviz takes to arrange it."""

from dataclasses import replace
from functools import partial
from itertools import pairwise
from random import Random
from time import perf_counter

from ...core.automaton import START, Automaton, Basic, Rule, State
from ...core.conditions import Condition, Equals
from ...core.edits import add_rule, move_states, remove_rule, rename_state
from ...core.features import FeatureUse, Sense
from ...core.library import Library
from ...core.project import Project
from ..graph.panel import GraphPanel
from ..selection import BehaviorKey
from .stage import Stage

TYPE, LARGE = "agent", "large"
STATES, EDGES = 40, 120
#: How often each kind of edit is made.
TIMES = 8
BEHAVIORS = ("Forward", "RotateLeft", "RotateRight")
SEES = Condition(Equals("sees", 1.0))


def large(project: Project, states: int = STATES, edges: int = EDGES) -> Project:
    """*project* with one more behavior, an automaton written by hand of so many states and transitions."""
    chance = Random(1)
    made = tuple(State(f"s{k}", Basic(BEHAVIORS[k % 3]), f"state {k}") for k in range(1, states))
    names = [START, *(state.id for state in made)]
    pairs = dict.fromkeys(pairwise(names))
    while len(pairs) < edges:
        source, target = chance.choice(names), chance.choice(names[1:])
        if source != target:
            pairs[source, target] = None
    automaton = Automaton(
        LARGE,
        "Large",
        states=(*Automaton("", "").states, *made),
        features=(FeatureUse("sees", Sense("ICanSeeABox")),),
        rules=tuple(Rule(f"r{k}", a, (SEES,), b) for k, (a, b) in enumerate(pairs)),
    )
    library = project.library(TYPE)
    automata = {**library.automata, LARGE: automaton}
    return replace(project, libraries={**project.libraries, TYPE: Library(automata)})


def of_large_automaton(stage: Stage, project: Project, times: int) -> tuple[float, float]:
    """Seconds until Graphviz has arranged it, and the longest until one of several edits can be seen."""
    stage.open(large(project))
    panel = stage.window.docks["graph"].widget()
    assert isinstance(panel, GraphPanel)
    began = perf_counter()
    stage.studio.selection.select_behavior(BehaviorKey(TYPE, LARGE))
    stage.wait(lambda: not panel.is_pending and panel.laying_out.is_idle, "arrange")
    arranged = perf_counter() - began
    stage.settle()
    document, where = stage.studio.document, (TYPE, LARGE)
    slowest = 0.0
    for number in range(1, 1 + times):
        state = f"s{number}"
        for edit in (
            partial(document.do, rename_state, *where, state, f"other {number}"),
            partial(document.do, move_states, *where, {state: (10.0 * number, 40.0)}),
            partial(document.do, remove_rule, *where, f"r{number}"),
            partial(document.do, add_rule, *where, state, START if number % 2 else "s30", (SEES,)),
        ):
            slowest = max(slowest, stage.seconds_of(edit))
    return arranged, slowest
