"""Whole projects, and what only they have: moments, examples, arms, demonstrations."""

from collections.abc import Sequence
from dataclasses import replace

from hypothesis import strategies as st

from app.core.automaton import Automaton
from app.core.examples import Example, Moment
from app.core.library import Library, Types
from app.core.project import Arm, Demonstration, Pick, Project
from app.core.storage import moment_hash
from app.core.vocabulary import Vocabulary

from .automata import NOWHERE, Scope, automata, entered_states, left_states, values_of
from .vocabularies import finite, forests, level_tables, node_types, scalars, some, vocabularies, words

#: Ids become file names: plain ones, long ones, and some with spaces, dots and letters of other alphabets.
AUTOMATA = ("goto", "return-with-box", "x.y", "a b", "größe", "目标", "b" * 60)
DEMONSTRATIONS = ("first", "goto 2", "größe")
ARMS = ("independent", "one level", "zwei Ebenen", "x/y")
WORLDS = ("", "hard", "small arena")

parameter_sets = st.dictionaries(st.sampled_from(("boxes", "speed", "arena")), scalars, max_size=2)
json_values = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**70), 2**70) | finite | words,
    lambda inner: st.lists(inner, max_size=2) | st.dictionaries(words, inner, max_size=2),
    max_leaves=4,
)
columns = st.one_of(
    st.lists(st.floats(allow_nan=False), max_size=4),
    st.lists(st.integers(-(2**63), 2**63 - 1), max_size=4),
    st.lists(st.integers(0, 2**64 - 1), max_size=4),
).map(tuple)
moments = st.builds(
    Moment,
    st.just("sample"),
    parameter_sets,
    st.sampled_from(ARMS),
    st.dictionaries(st.sampled_from(("x", "y", "clock", "größe")), columns, max_size=3),
    st.dictionaries(st.sampled_from(("now", "nodes")), json_values, max_size=2),
)


@st.composite
def examples(
    draw: st.DrawFn, scope: Scope, automaton: Automaton, hashes: Sequence[str]
) -> tuple[Example, ...]:
    """What picks could have recorded for *automaton*; *hashes* name the moments that there are."""
    sources, labels = left_states(automaton, scope.vocabulary), entered_states(automaton)
    if not labels:
        return ()
    numbers = {use.id: values_of(scope.declared(use.source).kind) for use in automaton.features}
    one = st.builds(
        Example,
        st.just(""),
        scope.reference(sources),
        scope.reference(labels),
        st.fixed_dictionaries(numbers),
        continuation=st.booleans(),
        enabled=st.booleans(),
        weight=st.sampled_from((0.5, 1.0, 3.0)),
        tick=st.integers(0, 10**6),
        node=words,
        snapshot=st.sampled_from(("", *hashes)),
        pick=st.integers(0, 100),
    )
    return tuple(replace(e, id=str(n)) for n, e in enumerate(draw(st.lists(one, max_size=4)), start=1))


@st.composite
def projects(draw: st.DrawFn, *, checked: bool = True) -> Project:
    """A project; see the module for what *checked* means."""
    return draw(projects_with_vocabulary(checked=checked))[0]


@st.composite
def projects_with_vocabulary(draw: st.DrawFn, *, checked: bool = True) -> tuple[Project, Vocabulary]:
    """A project and the vocabulary of the scenario that it is made for."""
    vocabulary, types = draw(vocabularies()), draw(node_types())
    stored = {moment_hash(moment): moment for moment in draw(st.lists(moments, max_size=2))}
    libraries: dict[str, Library] = {}
    recorded: dict[str, dict[str, tuple[Example, ...]]] = {}
    for node_type in types:  # a controller's behaviors come from the libraries below it
        scope = Scope(Types(types, libraries, vocabulary), node_type.name, {}, checked)
        library = draw(_libraries(scope))
        taken = {a.id: draw(examples(scope, a, tuple(stored))) for a in library.automata.values()}
        if library.automata:
            libraries[node_type.name] = library
        if any(taken.values()):
            recorded[node_type.name] = {
                automaton_id: taught for automaton_id, taught in taken.items() if taught
            }
    used = {e.snapshot for by_id in recorded.values() for several in by_id.values() for e in several}
    project = Project(
        draw(words),
        "sample",
        types,
        {name: draw(parameter_sets) for name in draw(some(WORLDS))},
        libraries,
        recorded,
        {name: moment for name, moment in stored.items() if name in used},
        note=draw(words),
    )
    project = replace(project, arms=draw(_arms(project, vocabulary, checked=checked)))
    return replace(
        project, demonstrations=draw(_demonstrations(project, vocabulary, checked=checked))
    ), vocabulary


@st.composite
def _libraries(draw: st.DrawFn, scope: Scope) -> Library:
    """A few automata, each of which may hold those drawn before it; any of them if nothing is checked."""
    drawn: dict[str, Automaton] = {}
    ids = draw(some(AUTOMATA))
    for automaton_id in ids:
        held = drawn if scope.checked else {**dict.fromkeys(ids, Automaton("", "")), **drawn}
        name = "The " + automaton_id if scope.checked else draw(words)
        drawn[automaton_id] = draw(automata(replace(scope, held=held), automaton_id, name))
    return Library(drawn)


@st.composite
def _arms(draw: st.DrawFn, project: Project, vocabulary: Vocabulary, *, checked: bool) -> tuple[Arm, ...]:
    types, arms = project.types_with(vocabulary), []
    for name in draw(some(ARMS)):
        hierarchy = draw(forests(project.types) | level_tables(project.types))
        world = draw(st.sampled_from(("", *project.worlds, *(() if checked else (NOWHERE,)))))
        arm = Arm(name, hierarchy, "", world, draw(parameter_sets), draw(words))
        arms.append(replace(arm, top=draw(st.sampled_from(tops(arm, types) if checked else (NOWHERE, "")))))
    return tuple(arms)


def tops(arm: Arm, types: Types) -> list[str]:
    """What every root of *arm* can be told to do and needs no target for."""
    repertoires = [types.repertoire(root.type) for root in arm.forest().roots]
    return sorted(n for n in repertoires[0] if all(n in r and not r[n].parameters for r in repertoires))


@st.composite
def _demonstrations(
    draw: st.DrawFn, project: Project, vocabulary: Vocabulary, *, checked: bool
) -> tuple[Demonstration, ...]:
    chances = [
        (automaton, type_name, arm, nodes)
        for type_name, library in project.libraries.items()
        for automaton in library.automata.values()
        for arm in project.arms
        if (nodes := [node.id for node in arm.forest().walk() if node.type == type_name])
    ]
    if not chances:
        return ()
    found = []
    for demonstration_id in draw(some(DEMONSTRATIONS)):
        automaton, type_name, arm, nodes = draw(st.sampled_from(chances))
        targets = project.types_with(vocabulary).vocabulary(type_name).targets
        picks = draw(
            st.lists(_picks(automaton, nodes), max_size=4).map(lambda p: tuple(sorted(p, key=_tick)))
        )
        arguments = {p: draw(st.sampled_from(sorted(targets))) for p in automaton.parameters}
        found.append(
            Demonstration(
                demonstration_id,
                type_name if checked else draw(st.sampled_from((type_name, NOWHERE))),
                automaton.id,
                arm.name,
                draw(st.integers(0, 2**63 - 1)),
                picks,
                1 + (picks[-1].tick if picks else 0),
                draw(parameter_sets),
                arguments,
                draw(st.sampled_from(("idle", "run"))),
                draw(words),
            )
        )
    return tuple(found)


def _tick(pick: Pick) -> int:
    return pick.tick


def _picks(automaton: Automaton, nodes: Sequence[str]) -> st.SearchStrategy[Pick]:
    ticks = st.integers(0, 1000)
    acts = st.builds(
        Pick,
        ticks,
        st.sampled_from(nodes),
        st.just(""),
        st.sampled_from(("should not have left", "undo", "test")),
    )
    entered = entered_states(automaton)
    picks = st.builds(Pick, ticks, st.sampled_from(nodes), st.sampled_from(entered)) if entered else acts
    return picks | acts
