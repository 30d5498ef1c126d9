"""What projects are made from: text and numbers, what a scenario declares, node types, forests."""

from collections.abc import Sequence
from dataclasses import replace
from typing import TypeVar

from hypothesis import strategies as st

from app.core.hierarchy import Hierarchy, Node
from app.core.library import NodeType
from app.core.project import LevelTable, Value
from app.core.vocabulary import (
    DONE,
    STANDARD_FLAGS,
    BasicBehavior,
    Feature,
    FeatureKind,
    Target,
    Vocabulary,
)

T = TypeVar("T")

PARAMETERS = ("target", "other")
FLAGS = (*STANDARD_FLAGS, "lost")

finite = st.floats(allow_nan=False, allow_infinity=False)
words = st.text(max_size=5)
scalars: st.SearchStrategy[Value] = st.one_of(st.booleans(), st.integers(-(2**63), 2**63 - 1), finite, words)


def some(items: Sequence[T], least: int = 0, most: int = 3) -> st.SearchStrategy[list[T]]:
    """A few of *items*, each at most once, in any order."""
    most = min(most, len(items))
    return (
        st.lists(st.sampled_from(items), min_size=least, max_size=most, unique=True) if most else st.just([])
    )


@st.composite
def vocabularies(draw: st.DrawFn) -> Vocabulary:
    """What a scenario declares; at least one behavior and one target that agents can use as they are."""
    parameters = some(PARAMETERS, most=2).map(tuple)
    behaviors = [BasicBehavior("Forward")]
    for name in draw(some(("Face", "GrabBox", "ReleaseBox", "Done"))):
        raises = draw(st.sampled_from((None, None, *FLAGS)))
        behaviors.append(BasicBehavior(name, draw(parameters), draw(st.booleans()), raises, raises == DONE))
    features = [
        draw(st.builds(_feature, st.just(name), st.sampled_from(FeatureKind), parameters, finite))
        for name in draw(some(("DistanceTo", "DirectionTo", "SeesABox", "Ground"), least=1, most=4))
    ]
    features += [
        replace(_feature(name, draw(st.sampled_from(FeatureKind))), whose="group")
        for name in draw(some(("SomeoneNeedsHelp", "Spread"), most=2))
    ]
    targets = [Target("deposit"), *(Target(f"target-{level}", level) for level in draw(some((0, 1, 2))))]
    return Vocabulary(
        0, {b.name: b for b in behaviors}, {f.name: f for f in features}, {t.name: t for t in targets}
    )


def _feature(name: str, kind: FeatureKind, parameters: tuple[str, ...] = (), default: float = 0.0) -> Feature:
    categories = ("grass", "sand", "rock") if kind is FeatureKind.CATEGORICAL else ()
    usual = default if kind is FeatureKind.CONTINUOUS else 0.0
    return Feature(name, kind, parameters, usual, categories, period=4.0)


@st.composite
def node_types(draw: st.DrawFn) -> tuple[NodeType, ...]:
    """One or two types of agents, and up to two levels of controllers above them; lower levels first."""
    levels = [[NodeType(name) for name in draw(some(("agent", "scout"), least=1))]]
    for level, names in ((1, ("group", "patrol")), (2, ("squad",))):
        below = [node_type.name for node_type in levels[-1]]
        found = (
            [NodeType(n, level, tuple(draw(some(below, least=1)))) for n in draw(some(names))]
            if below
            else []
        )
        levels.append(found)
    return tuple(node_type for level in levels for node_type in level)


@st.composite
def forests(draw: st.DrawFn, types: Sequence[NodeType]) -> Hierarchy:
    """One to three trees of nodes of these *types*, of any shape that the types allow."""
    by_name = {node_type.name: node_type for node_type in types}
    numbers = iter(range(1, 1000))

    def grow(type_name: str) -> Node:
        below = by_name[type_name].subsidiaries
        chosen = draw(st.lists(st.sampled_from(below), min_size=1, max_size=2)) if below else []
        return Node(
            f"{type_name}-{next(numbers)}", type_name, tuple(grow(name) for name in chosen), draw(words)
        )

    roots = draw(st.lists(st.sampled_from([node_type.name for node_type in types]), min_size=1, max_size=3))
    return Hierarchy(tuple(grow(name) for name in roots))


@st.composite
def level_tables(draw: st.DrawFn, types: Sequence[NodeType]) -> LevelTable:
    """A regular forest from one of *types* down to agents."""
    by_name = {node_type.name: node_type for node_type in types}
    names = [draw(st.sampled_from(sorted(by_name)))]
    while by_name[names[-1]].subsidiaries:
        names.append(draw(st.sampled_from(by_name[names[-1]].subsidiaries)))
    return LevelTable(tuple(draw(st.integers(1, 3)) for _ in names), tuple(names))
