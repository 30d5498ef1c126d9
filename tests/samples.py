"""A small foraging-like vocabulary and a project without problems, for tests that need something to work on.

Everything is made anew by each call; nothing here knows a world.
"""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from app.core.automaton import START, Automaton, Basic, Nested, Prune, RaiseFlag, Rule, Start, State
from app.core.conditions import AtMost, Condition, Equals, Guard, InArc, Test
from app.core.examples import Example, Moment
from app.core.features import (
    Bindings,
    FeatureUse,
    FlagUp,
    Ground,
    Operation,
    Parameter,
    Sense,
    Statistic,
    TicksInState,
)
from app.core.library import Library, NodeType
from app.core.project import Arm, Demonstration, LevelTable, Pick, Project
from app.core.tree import Branch, Leaf, Tree
from app.core.vocabulary import DONE, FINISHED, BasicBehavior, Feature, FeatureKind, Target, Vocabulary

AGENT, GROUP, SQUAD = "agent", "group", "squad"
TYPES = (NodeType(AGENT), NodeType(GROUP, 1, (AGENT,)), NodeType(SQUAD, 2, (GROUP,)))


def vocabulary() -> Vocabulary:
    """Behaviors of every sort (plain, one-shot, flag raiser, finishing) and features of every kind."""
    behaviors = (
        BasicBehavior("Forward"),
        BasicBehavior("RotateLeft"),
        BasicBehavior("RotateRight"),
        BasicBehavior("Face", ("target",)),
        BasicBehavior("GrabBox", one_shot=True),
        BasicBehavior("ReleaseBox", raises=DONE),
        BasicBehavior("ReleaseBoxAndFinish", raises=DONE, finishes=True),
        BasicBehavior("Done", raises=DONE),
    )
    features = (
        Feature("DistanceTo", FeatureKind.CONTINUOUS, ("target",), default=1000.0),
        Feature("DirectionTo", FeatureKind.TOROIDAL, ("target",)),
        Feature("SeesABox", FeatureKind.BOOLEAN),
        Feature("IsAttached", FeatureKind.BOOLEAN),
        Feature("Ground", FeatureKind.CATEGORICAL, categories=("grass", "sand", "rock")),
        Feature("SomeoneNeedsHelp", FeatureKind.BOOLEAN, whose="group"),
    )
    targets = (
        Target("nearest-box"),
        Target("deposit"),
        Target("closest-attached-agent", level=1),
        Target("biggest-attached-agent", level=2),
    )
    return Vocabulary(
        0, {b.name: b for b in behaviors}, {f.name: f for f in features}, {t.name: t for t in targets}
    )


def state(state_id: str, behavior: str, bindings: Bindings | None = None) -> State:
    """A state that holds a basic behavior and is called like its id."""
    return State(state_id, Basic(behavior, bindings or {}), state_id)


def nested(state_id: str, automaton: str, bindings: Bindings | None = None) -> State:
    """A state that holds an automaton and is called like its id."""
    return State(state_id, Nested(automaton, bindings or {}), state_id)


def flag(state_id: str, name: str = DONE) -> State:
    """A state that raises a flag and is called like its id."""
    return State(state_id, RaiseFlag(name), state_id)


def when(*tests: Test) -> Guard:
    """A guard that is met where all *tests* hold."""
    return tuple(Condition(test) for test in tests)


def automaton(automaton_id: str, *states: State, **fields: Any) -> Automaton:
    """An automaton called like its id; Start comes by itself, *fields* are those of `Automaton`."""
    start = State(START, Start(), "Start")
    return Automaton(automaton_id, automaton_id, states=(start, *states), **fields)


def wander() -> Automaton:
    """Authored by chance alone: walks on, and turns now and then."""
    return automaton(
        "wander",
        state("forward", "Forward"),
        state("left", "RotateLeft"),
        state("right", "RotateRight"),
        rules=(
            Rule("1", START, (), "forward"),
            Rule("2", "forward", (), "left", 0.05),
            Rule("3", "forward", (), "right", 0.05),
            Rule("4", "left", (), "forward", 0.1),
            Rule("5", "right", (), "forward", 0.1),
        ),
    )


def goto() -> Automaton:
    """Learned, with a parameter: turns to the target, walks, and is done when near."""
    labels = ("forward", "left", "done")
    tree = Tree(
        labels,
        Branch(
            AtMost("distance", 2.0),
            Leaf((0.0, 0.0, 2.0)),
            Branch(
                InArc("direction", -0.5, 0.5), Leaf((3.0, 0.0, 0.0)), Leaf((1.0, 3.0, 0.0)), (4.0, 3.0, 0.0)
            ),
            (4.0, 3.0, 2.0),
        ),
    )
    return automaton(
        "goto",
        state("forward", "Forward"),
        state("left", "RotateLeft"),
        flag("done"),
        parameters=("target",),
        features=(
            FeatureUse("distance", Sense("DistanceTo", {"target": Parameter("target")})),
            FeatureUse("direction", Sense("DirectionTo", {"target": Parameter("target")})),
        ),
        learned={START: tree, "forward": tree, "left": tree},
        learned_from="sample",
        prunes=(Prune("1", "left", when(AtMost("distance", 50.0)), frozenset({"forward"})),),
    )


def fetch() -> Automaton:
    """Grabs the box at hand, pulls it home and lets go."""
    return automaton(
        "fetch",
        state("grab", "GrabBox"),
        nested("home", "goto", {"target": Ground("deposit")}),
        state("release", "ReleaseBoxAndFinish"),
        features=(
            FeatureUse("done", FlagUp(DONE)),
            FeatureUse("ticks", TicksInState()),
        ),
        rules=(
            Rule("1", START, (), "grab"),
            Rule("2", "grab", (Condition(AtMost("ticks", 1.0), wanted=False),), "home"),
            Rule("3", "home", when(Equals("done", 1.0)), "release"),
        ),
    )


def forage() -> Automaton:
    """Wanders until it sees a box, goes there, and fetches it."""
    return automaton(
        "forage",
        nested("wander", "wander"),
        nested("approach", "goto", {"target": Ground("nearest-box")}),
        nested("fetch", "fetch"),
        features=(
            FeatureUse("sees", Sense("SeesABox")),
            FeatureUse("done", FlagUp(DONE)),
            FeatureUse("ground", Sense("Ground")),
        ),
        rules=(
            Rule("1", START, (), "wander"),
            Rule("2", "wander", when(Equals("sees", 1.0), Equals("ground", 0.0)), "approach"),
            Rule("3", "approach", when(Equals("done", 1.0)), "fetch"),
            Rule("4", "approach", when(Equals("sees", 0.0)), "wander"),
            Rule("5", "fetch", when(Equals("done", 1.0)), "wander"),
        ),
    )


def control() -> Automaton:
    """A group's: lets its agents forage, and calls them to the first who holds a box until someone has finished."""
    return automaton(
        "control",
        state("search", "forage"),
        state("gather", "goto", {"target": Ground("closest-attached-agent")}),
        features=(
            FeatureUse("attached", Statistic(Operation.ANY, Sense("IsAttached"))),
            FeatureUse("finished", Statistic(Operation.ANY, FlagUp(FINISHED))),
            FeatureUse("help", Sense("SomeoneNeedsHelp")),
        ),
        rules=(
            Rule("1", START, (), "search"),
            Rule("2", "search", when(Equals("attached", 1.0)), "gather"),
            Rule("3", "gather", when(Equals("finished", 1.0)), "search"),
            Rule("4", "gather", when(Equals("help", 1.0)), "search", 0.01),
        ),
    )


def goto_examples() -> tuple[Example, ...]:
    """Three picks in one demonstration of goto: forward and left with continuations, then done."""
    far, near = {"distance": 40.0, "direction": 0.1}, {"distance": 1.5, "direction": -0.2}
    aside = {"distance": 30.0, "direction": 2.0}
    return (
        recorded("1", START, "forward", far, pick=1),
        recorded("2", "forward", "forward", far, pick=1, continuation=True),
        recorded("3", "forward", "left", aside, pick=2),
        recorded("4", "left", "left", aside, pick=2, continuation=True),
        recorded("5", "left", "done", near, pick=3),
    )


def recorded(
    number: str,
    source: str,
    label: str,
    values: Mapping[str, float],
    *,
    pick: int,
    continuation: bool = False,
) -> Example:
    """An example of the sample demonstration, recorded 100 ticks after the pick before."""
    came_from = Example(number, source, label, values, continuation, demonstration="goto-1", node="agent-1")
    return replace(came_from, tick=100 * (pick - 1), snapshot="m1", pick=pick)


def moment() -> Moment:
    """A tiny world with one agent."""
    return Moment("sample", {"boxes": 1}, "independent", {"x": (1.0,), "y": (2.0,)})


def project() -> Project:
    """Agents, groups and squads; five behaviors, examples of one, three arms and a demonstration."""
    demonstration = Demonstration(
        "goto-1",
        AGENT,
        "goto",
        "independent",
        seed=1,
        picks=(Pick(0, "agent-1", "forward"), Pick(100, "agent-1", "left"), Pick(200, "agent-1", "done")),
        ticks=300,
        arguments={"target": "deposit"},
    )
    agents = (wander(), goto(), fetch(), forage())
    return Project(
        "Sample",
        "sample",
        TYPES,
        worlds={"": {"boxes": 10}, "hard": {"boxes": 4}},
        libraries={AGENT: Library({a.id: a for a in agents}), GROUP: Library({"control": control()})},
        examples={AGENT: {"goto": goto_examples()}},
        moments={"m1": moment()},
        arms=(
            Arm("independent", LevelTable((4,), (AGENT,)), "forage"),
            Arm("one level", LevelTable((2, 3), (GROUP, AGENT)), "control", world="hard"),
            Arm("two levels", LevelTable((1, 2, 3), (SQUAD, GROUP, AGENT)), "control"),
        ),
        demonstrations=(demonstration,),
    )
