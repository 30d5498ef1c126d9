"""Copying states to automata of another node type: what they hold is found there, or comes along where the type allows it."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from ..automaton import START, Automaton, Basic, Content, Nested
from ..errors import EditError
from ..features import Bindings, FeatureUse, Ground, Parameter, Sense, Statistic
from ..library import Library
from ..naming import fresh_id
from ..project import Project
from ..vocabulary import Vocabulary
from .bindings import bindings_of
from .copying import Where, copied_states, tests, with_rules_of_trees
from .place import find_automaton, find_type, listed, with_automaton, with_examples, with_layout, with_library
from .states import refuse_states


def carry_states(
    project: Project, scenario: Vocabulary, source: Where, state_ids: Sequence[str], into: Where
) -> tuple[Project, dict[str, str]]:
    """Like `copy_states`, where *into* may be an automaton of another node type.

    What a state holds is known there by its name: as an automaton of that type, or as one of its basic behaviors. An
    automaton that the type lacks comes along with its examples and all that it holds, where the type has the basic
    behaviors, features and targets that it is made from. Transitions that test what the automaton cannot see do not come
    along (`left_behind` says which that are): that its type has no such feature, or it no such parameter. A feature that
    is open would keep all its examples from being learned from.

    Raises:
        EditError: The other type cannot do or see something; the message says what.
    """
    original = find_automaton(project, *source)
    refuse_states(original, state_ids)
    contents: dict[str, Content] = {}
    for state in original.states:
        if state.id in state_ids and state.id != START:
            carrier = _Carrier(project, scenario, source[0], into[0])
            contents[state.id] = carrier.held(state.content)
            project = carrier.project
    unseen = [use.id for use in _unseen(project, scenario, original, into)]
    return copied_states(project, source, state_ids, into, contents, unseen)


def lend(project: Project, type_name: str, automaton: Automaton) -> tuple[Project, str]:
    """*project* with an automaton as it once was beside its own, for its states to be copied; also returns its id."""
    lent = fresh_id(project.library(type_name).automata, automaton.id, "lent")
    return with_automaton(project, type_name, replace(automaton, id=lent)), lent


def give_back(project: Project, type_name: str, lent: str) -> Project:
    """*project* without what was lent to it."""
    automata = project.library(type_name).automata
    return with_library(project, type_name, {key: one for key, one in automata.items() if key != lent})


def left_behind(
    project: Project, scenario: Vocabulary, source: Where, state_ids: Sequence[str], into: Where
) -> tuple[str, ...]:
    """What the transitions test, in the user's words, that do not come along with states since *into* cannot see it."""
    original = with_rules_of_trees(project, source, state_ids)
    copied = [rule for rule in original.rules if rule.source in state_ids]
    unseen = _unseen(project, scenario, original, into)
    return tuple(use.shown for use in unseen if any(tests(rule, (use.id,)) for rule in copied))


def _unseen(project: Project, scenario: Vocabulary, automaton: Automaton, into: Where) -> list[FeatureUse]:
    vocabulary = project.types_with(scenario).vocabulary(into[0])
    known = find_automaton(project, *into).parameters
    return [
        use for use in automaton.features if _why_unseen(use, vocabulary) or not _parameters(use) <= {*known}
    ]


def _parameters(use: FeatureUse) -> set[str]:
    """The parameters of its automaton that a feature looks through."""
    return {bound.name for bound in bindings_of(use.source).values() if isinstance(bound, Parameter)}


def _why_unseen(use: FeatureUse, vocabulary: Vocabulary) -> str:
    """Why a type with this vocabulary cannot see a feature; empty if it can."""
    match use.source:
        case Sense(name) if name not in vocabulary.features:
            return f"it has no feature {name!r}"
        case Statistic() if vocabulary.level == 0:
            return f"it has no subsidiaries for {use.shown!r}"
    return ""


class _Carrier:
    """Brings what states hold from one type to another.

    Attributes:
        project: With what has come along so far.
    """

    def __init__(self, project: Project, scenario: Vocabulary, source: str, into: str) -> None:
        find_type(project, into)
        self.project = project
        self._scenario = scenario
        self._source, self._into = source, into

    def held(self, content: Content) -> Content:
        """What a state of the other type holds to do the same."""
        if self._source == self._into:
            return content
        match content:
            case Nested(automaton_id, bindings):
                return self._nested(find_automaton(self.project, self._source, automaton_id), bindings)
            case Basic(name, bindings):
                known = self._known(name, bindings)
                if known is None:
                    raise EditError(
                        f"{self._into!r} has no behavior {name!r}; it has: {listed(sorted(self._vocabulary.behaviors))}"
                    )
                return known
        return content

    def _nested(self, automaton: Automaton, bindings: Bindings) -> Content:
        known = self._known(automaton.name, bindings)
        return Nested(self._bring(automaton), bindings) if known is None else known

    def _known(self, name: str, bindings: Bindings) -> Basic | Nested | None:
        """The behavior of that name in the other type; None if it has none."""
        library, basics = self._library, self._vocabulary.behaviors
        automaton = library.by_name(name)
        behavior = automaton or basics.get(name)
        if behavior is None:
            return None
        if lacking := sorted(bindings.keys() - set(behavior.parameters)):
            raise EditError(
                f"{name} of {self._into!r} has no parameter {lacking[0]!r}, unlike that of {self._source!r}"
            )
        return Basic(name, bindings) if automaton is None else Nested(automaton.id, bindings)

    def _bring(self, automaton: Automaton) -> str:
        """Copy an automaton, and before it what it holds, into the other type's library; returns its id there."""
        reasons = list(self._obstacles(automaton))
        if reasons:
            raise EditError(f"{automaton.name} cannot come along to {self._into!r}: {listed(reasons)}")
        states = tuple(replace(state, content=self.held(state.content)) for state in automaton.states)
        new_id = fresh_id(self._library.automata, automaton.name, "behavior")
        there = self._into, new_id
        old = self._source, automaton.id
        project = with_automaton(self.project, self._into, replace(automaton, id=new_id, states=states))
        project = with_layout(project, *there, project.layout_of(*old))
        self.project = with_examples(project, *there, project.examples_of(*old))
        return new_id

    def _obstacles(self, automaton: Automaton) -> Iterator[str]:
        """What the other type cannot see or mean of an automaton."""
        vocabulary = self._vocabulary
        for use in automaton.features:
            if problem := _why_unseen(use, vocabulary):
                yield problem
        bound = [bindings_of(state.content) for state in automaton.states]
        bound += [bindings_of(use.source) for use in automaton.features]
        targets = {b.target for bindings in bound for b in bindings.values() if isinstance(b, Ground)}
        yield from (f"it knows no target {name!r}" for name in sorted(targets - vocabulary.targets.keys()))

    @property
    def _library(self) -> Library:
        return self.project.library(self._into)

    @property
    def _vocabulary(self) -> Vocabulary:
        return self.project.types_with(self._scenario).vocabulary(self._into)
