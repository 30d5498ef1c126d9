"""Automata with any mixture of authored and learned transitions, within what their node type can use."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from hypothesis import strategies as st

from app.core.automaton import (
    START,
    Automaton,
    Basic,
    Content,
    Cut,
    Nested,
    Prune,
    RaiseFlag,
    Refit,
    Rule,
    Sampling,
    Settings,
    Start,
    State,
)
from app.core.conditions import AtMost, Condition, Equals, Guard, InArc, Test
from app.core.features import (
    Bindings,
    FeatureUse,
    FlagUp,
    Ground,
    Operation,
    Over,
    Parameter,
    Sense,
    Source,
    Statistic,
    TicksInState,
    declaration,
)
from app.core.library import Types, statistic_vocabulary
from app.core.tree import Branch, Forest, Leaf, Tree, TreeNode
from app.core.vocabulary import DONE, FINISHED, Feature, FeatureKind, Vocabulary

from .vocabularies import FLAGS, PARAMETERS, finite, some, words

#: Where references lead that lead nowhere.
NOWHERE = "nowhere"
CLASSIFIERS = ("c45", "cart", "random-forest")


@dataclass(frozen=True, slots=True)
class Scope:
    """What an automaton is drawn within.

    Attributes:
        types: The node types with what has been drawn so far.
        held: Automata that its states may hold, by id.
        checked: Whether all that it refers to must be there.
    """

    types: Types
    type_name: str
    held: Mapping[str, Automaton]
    checked: bool

    @property
    def vocabulary(self) -> Vocabulary:
        """What automata of this type are made from."""
        return self.types.vocabulary(self.type_name)

    def reference(self, names: Sequence[str]) -> st.SearchStrategy[str]:
        """One of *names*, or also none of them where nothing is checked."""
        return st.sampled_from(names if self.checked else (*names, NOWHERE))

    def declared(self, source: Source) -> Feature:
        """What values *source* has."""
        if isinstance(source, Statistic):
            return declaration(source, statistic_vocabulary(self.types))
        return declaration(source, self.vocabulary)


@st.composite
def automata(draw: st.DrawFn, scope: Scope, automaton_id: str, name: str) -> Automaton:
    """An automaton with any mixture of authored and learned transitions."""
    parameters = tuple(draw(some(PARAMETERS, most=2)))
    contents = draw(st.lists(_contents(scope, parameters), max_size=4))
    states = (
        State(START, Start(), "Start"),
        *(State(f"s{n}", content, draw(words), draw(words)) for n, content in enumerate(contents, start=1)),
    )
    sources = draw(st.lists(_sources(scope, parameters), max_size=3))
    features = tuple(FeatureUse(f"f{n}", source, draw(words)) for n, source in enumerate(sources, start=1))
    bare = Automaton(automaton_id, name, parameters, states, features, note=draw(words))
    return draw(_with_transitions(scope, bare))


@st.composite
def _with_transitions(draw: st.DrawFn, scope: Scope, bare: Automaton) -> Automaton:
    sources, targets = left_states(bare, scope.vocabulary), entered_states(bare)
    if not targets:
        return bare
    guard = _guards(scope, bare.features)
    rules = draw(
        st.lists(
            st.tuples(scope.reference(sources), guard, scope.reference(targets), st.floats(0, 1)), max_size=3
        )
    )
    forbidden = st.frozensets(scope.reference(targets), min_size=1, max_size=2)
    prunes = draw(st.lists(st.tuples(scope.reference(sources), guard, forbidden), max_size=2))
    moved = st.tuples(scope.reference(sources), guard, feature_tests(scope, bare.features))
    cuts = draw(st.lists(moved, max_size=1)) if bare.features else ()
    return replace(
        bare,
        rules=tuple(Rule(str(number), *rule) for number, rule in enumerate(rules, start=1)),
        prunes=tuple(Prune(str(number), *prune) for number, prune in enumerate(prunes, start=1)),
        learned={state: draw(models(scope, bare)) for state in draw(some(sources))},
        cuts=tuple(Cut(str(number), *cut) for number, cut in enumerate(cuts, start=1)),
        learned_from=draw(words),
        settings=draw(_settings),
    )


_settings = st.builds(
    Settings,
    st.sampled_from(CLASSIFIERS),
    st.sampled_from(Sampling),
    st.none() | st.floats(0, 0.5, exclude_min=True),
    st.dictionaries(st.sampled_from(("trees", "neighbors")), finite, max_size=2),
)


def left_states(automaton: Automaton, vocabulary: Vocabulary) -> list[str]:
    """Ids of the states that transitions and examples can start from: all that raise no flag."""
    return [state.id for state in automaton.states if not _raises(state.content, vocabulary)]


def entered_states(automaton: Automaton) -> list[str]:
    """Ids of the states that transitions and examples can lead to: all but Start."""
    return [state.id for state in automaton.states[1:]]


def _raises(content: Content, vocabulary: Vocabulary) -> bool:
    if isinstance(content, Basic) and content.behavior in vocabulary.behaviors:
        return vocabulary.behaviors[content.behavior].raises is not None
    return isinstance(content, RaiseFlag)


def _contents(scope: Scope, parameters: Sequence[str]) -> st.SearchStrategy[Content]:
    behaviors = scope.vocabulary.behaviors

    def basic(name: str) -> st.SearchStrategy[Content]:
        slots = behaviors[name].parameters if name in behaviors else PARAMETERS
        return st.builds(Basic, st.just(name), bindings(scope, slots, parameters))

    def nested(held: str) -> st.SearchStrategy[Content]:
        slots = scope.held[held].parameters if held in scope.held else PARAMETERS
        return st.builds(Nested, st.just(held), bindings(scope, slots, parameters))

    kinds = [scope.reference(sorted(behaviors)).flatmap(basic), st.builds(RaiseFlag, st.sampled_from(FLAGS))]
    if scope.held:
        kinds.append(scope.reference(sorted(scope.held)).flatmap(nested))
    return st.one_of(kinds)


@st.composite
def bindings(draw: st.DrawFn, scope: Scope, slots: Sequence[str], parameters: Sequence[str]) -> Bindings:
    """All of *slots* bound to a target, or to a parameter of the automaton; maybe only some if nothing is checked."""
    ground = st.builds(Ground, scope.reference(sorted(scope.vocabulary.targets)))
    either = ground | st.builds(Parameter, scope.reference(parameters)) if parameters else ground
    bound = slots if scope.checked else draw(some(slots))
    return {slot: draw(either) for slot in bound}


# ------------------------------------------------------------------------------------- features and conditions


def _sources(scope: Scope, parameters: Sequence[str]) -> st.SearchStrategy[Source]:
    flags = st.builds(FlagUp, st.sampled_from(FLAGS))
    kinds: list[st.SearchStrategy[Source]] = [flags, st.just(TicksInState())]
    if scope.vocabulary.features:
        kinds.append(_senses(scope, scope.vocabulary, parameters))
    if scope.vocabulary.level > 0:
        inner = _senses(scope, statistic_vocabulary(scope.types), parameters)
        below = inner | st.builds(FlagUp, st.sampled_from((FINISHED, DONE)))
        kinds.append(st.builds(Statistic, st.sampled_from(Operation), below, st.sampled_from(Over)))
    return st.one_of(kinds)


@st.composite
def _senses(draw: st.DrawFn, scope: Scope, declared: Vocabulary, parameters: Sequence[str]) -> Sense:
    name = draw(st.sampled_from(sorted(declared.features)))
    return Sense(name, draw(bindings(scope, declared.features[name].parameters, parameters)))


def _guards(scope: Scope, features: Sequence[FeatureUse]) -> st.SearchStrategy[Guard]:
    conditions = st.builds(Condition, feature_tests(scope, features), st.booleans())
    return st.lists(conditions, max_size=2).map(tuple) if features else st.just(())


@st.composite
def feature_tests(draw: st.DrawFn, scope: Scope, features: Sequence[FeatureUse]) -> Test:
    """A test of one of *features*, of the sort and with numbers that suit its kind."""
    use = draw(st.sampled_from(features))
    kind = scope.declared(use.source).kind
    name = use.id if scope.checked else draw(scope.reference((use.id,)))
    if kind is FeatureKind.CONTINUOUS:
        return AtMost(name, draw(finite))
    if kind is FeatureKind.TOROIDAL:
        return InArc(name, draw(values_of(kind)), draw(values_of(kind)))
    return Equals(name, draw(values_of(kind)))


def values_of(kind: FeatureKind) -> st.SearchStrategy[float]:
    """Values of the features that `vocabularies` declares with this kind."""
    match kind:
        case FeatureKind.BOOLEAN:
            return st.sampled_from((0.0, 1.0))
        case FeatureKind.CATEGORICAL:
            return st.sampled_from((0.0, 1.0, 2.0))
        case FeatureKind.TOROIDAL:
            return st.floats(-2.0, 2.0, exclude_max=True)
    return finite


# ------------------------------------------------------------------------------------------------ learned models


@st.composite
def models(draw: st.DrawFn, scope: Scope, automaton: Automaton) -> Tree | Forest | Refit:
    """What could have been learned for a state of *automaton*, which has states besides Start."""
    labels = tuple(
        sorted(set(draw(st.lists(scope.reference(entered_states(automaton)), min_size=1, max_size=3))))
    )
    tree = trees(labels, scope, automaton.features)
    several = st.lists(tree, min_size=1, max_size=2).map(tuple)
    refits = st.builds(Refit, st.sampled_from(CLASSIFIERS))
    return draw(st.one_of(tree, st.builds(Forest, st.just(labels), several), refits))


def trees(labels: tuple[str, ...], scope: Scope, features: Sequence[FeatureUse]) -> st.SearchStrategy[Tree]:
    """A tree that tests *features*, of which every node counts what is below it."""
    counts = st.lists(st.floats(0, 1e6), min_size=len(labels), max_size=len(labels)).map(tuple)
    leaves: st.SearchStrategy[TreeNode] = st.builds(Leaf, counts)
    if not features:
        return st.builds(Tree, st.just(labels), leaves)
    tests = feature_tests(scope, features)
    roots = st.recursive(leaves, lambda below: st.builds(_branch, tests, below, below), max_leaves=5)
    return st.builds(Tree, st.just(labels), roots)


def _branch(test: Test, yes: TreeNode, no: TreeNode) -> Branch:
    return Branch(test, yes, no, tuple(a + b for a, b in zip(yes.counts, no.counts, strict=True)))
