"""A project in which everything that a project can hold stands at least once; the golden folder holds it too."""

from dataclasses import replace

from app.core.automaton import (
    START,
    Automaton,
    Basic,
    Prune,
    RaiseFlag,
    Refit,
    Rule,
    Sampling,
    Settings,
    State,
)
from app.core.conditions import AtMost, Condition, Equals, InArc
from app.core.examples import Example, Moment
from app.core.features import (
    FeatureUse,
    FlagUp,
    Ground,
    Operation,
    Over,
    Parameter,
    Sense,
    Statistic,
    TicksInState,
)
from app.core.hierarchy import Hierarchy, Node
from app.core.library import Library
from app.core.project import Arm, Demonstration, LevelTable, Pick, Project
from app.core.storage import moment_hash
from app.core.tree import Branch, Forest, Leaf, Tree
from tests import samples
from tests.samples import AGENT, GROUP, SQUAD

LABELS = ("s1", "s2")
TREE = Tree(
    LABELS,
    Branch(
        InArc("f1", 3.0, -3.0),
        Leaf((2.0, 0.0)),
        Branch(
            Equals("f2", 1.0),
            Leaf((0.0, 0.5)),
            Branch(AtMost("f3", 0.1), Leaf((1.0, 0.0)), Leaf((0.0, 1.0)), (1.0, 1.0)),
            (1.0, 1.5),
        ),
        (3.0, 1.5),
    ),
)


def mixed() -> Automaton:
    """An automaton with every kind of content, feature, test and model."""
    return replace(
        samples.automaton(
            "mixed",
            State("s1", Basic("Face", {"target": Parameter("whom")}), "Face them", "What the note says."),
            samples.nested("s2", "goto", {"target": Ground("nearest-box")}),
            State("s3", RaiseFlag("lost")),
        ),
        name="Größe mixed",
        parameters=("whom", "where"),
        features=(
            FeatureUse("f1", Sense("DirectionTo", {"target": Parameter("whom")}), "direction"),
            FeatureUse("f2", FlagUp("done")),
            FeatureUse("f3", TicksInState()),
        ),
        rules=(
            Rule("1", START, (), "s1"),
            Rule(
                "2",
                "s1",
                (Condition(AtMost("f3", 10.0), wanted=False), Condition(Equals("f2", 0.0))),
                "s2",
                0.25,
            ),
        ),
        learned={
            START: Refit("k-nn"),
            "s1": TREE,
            "s2": Forest(LABELS, (TREE, Tree(LABELS, Leaf((1.0, 2.0))))),
        },
        learned_from="0f1e",
        prunes=(Prune("1", "s2", (Condition(InArc("f1", -0.5, 0.5)),), frozenset({"s2", "s1"})),),
        settings=Settings("random-forest", Sampling.HOLD, 0.25, {"trees": 10.0, "depth": 3.0}),
        note='Notes may hold "quotes", \\ and\nnew lines.',
    )


def control() -> Automaton:
    return replace(
        samples.control(),
        features=(
            FeatureUse("attached", Statistic(Operation.ANY, Sense("IsAttached"))),
            FeatureUse("finished", Statistic(Operation.COUNT, FlagUp("finished"), Over.SUBSIDIARIES)),
            FeatureUse("help", Sense("SomeoneNeedsHelp")),
        ),
        rules=(Rule("1", START, (), "search"),),
    )


def moment(tick: int) -> Moment:
    world = {"x": (1.0, -0.0, 1e-300), "weight": (1, -5), "clock": (7, 0, tick, 2**64 - 1), "none": ()}
    run = {
        "automaton": "goto",
        "arguments": {"target": ["deposit", "agent-1"]},
        "key": [[5], 3],
        "child": None,
    }
    machine = {"now": tick, "nodes": {"agent-1": {"run": run, "flags": ["done"]}}}
    return Moment(
        "sample", {"boxes": 1, "speed": 0.1, "walls": True, "arena": "wide"}, "independent", world, machine
    )


def examples(first: str, second: str) -> tuple[Example, ...]:
    return (
        Example(
            "1",
            START,
            "s1",
            {"f1": 0.1, "f2": 0.0, "f3": 1e300},
            demonstration="d1",
            node="agent-1",
            snapshot=first,
            pick=1,
        ),
        Example(
            "2",
            "s1",
            "s1",
            {"f1": 0.1, "f2": 0.0, "f3": 0.0},
            True,
            False,
            2.5,
            "d1",
            12,
            "agent-1",
            first,
            1,
        ),
        Example("3", "s1", "s2", {"f1": -3.0, "f2": 1.0, "f3": 5e-324}, snapshot=second),
        Example("4", "s2", "s1", {}),
    )


def arms() -> tuple[Arm, ...]:
    group = Node("g1", GROUP, (Node("a1", AGENT, name="the first"), Node("a2", AGENT)), "Group one")
    return (
        Arm("independent", LevelTable((4,), (AGENT,)), "forage"),
        Arm(
            "irregular",
            Hierarchy((group, Node("a3", AGENT))),
            "forage",
            "hard",
            {"boxes": 3, "slow": True},
            "Uneven.",
        ),
        Arm("two levels", LevelTable((1, 2, 3), (SQUAD, GROUP, AGENT)), "control"),
    )


def demonstration() -> Demonstration:
    picks = (
        Pick(0, "agent-1", "s1"),
        Pick(40, "agent-1", act="test"),
        Pick(90, "agent-1", act="should not have left"),
        Pick(91, act="undo", node=""),
        Pick(95, "agent-1", act="teach"),
    )
    return Demonstration(
        "d1",
        AGENT,
        "mixed",
        "independent",
        42,
        picks,
        100,
        {"boxes": 2},
        {"whom": "deposit"},
        "run",
        "By hand.",
    )


def project() -> Project:
    """The whole."""
    moments = {moment_hash(m): m for m in (moment(0), moment(12))}
    automata = (samples.wander(), samples.goto(), samples.fetch(), samples.forage(), mixed())
    return replace(
        samples.project(),
        name="Every kind",
        worlds={
            "": {"boxes": 10, "speed": 0.1},
            "hard": {"boxes": 4, "arena": "narrow", "walls": False, "one": 1.0},
        },
        libraries={AGENT: Library({a.id: a for a in automata}), GROUP: Library({"control": control()})},
        examples={AGENT: {"mixed": examples(*moments)}},
        moments=moments,
        arms=arms(),
        demonstrations=(replace(demonstration(), id="d2", note="", parameters={}), demonstration()),
        note="A note\non two lines.",
    )
