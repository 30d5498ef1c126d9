"""Bindings inside an automaton: finding those to a parameter, and changing them everywhere at once."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

from ..automaton import Automaton, Basic, Content, Nested, State
from ..features import Binding, Bindings, FeatureUse, Parameter, Sense, Source, Statistic
from ..library import Library
from ..naming import shown_state

ChangeBinding = Callable[[Binding], Binding]


def renamed_parameter(old: str, new: str) -> ChangeBinding:
    """Turns a binding to parameter *old* into one to *new*, and leaves others alone."""
    return lambda binding: Parameter(new) if binding == Parameter(old) else binding


def bindings_of(value: Content | Source) -> Bindings:
    """The bindings of a state's content or of a feature's source; none if it has no slots."""
    match value:
        case Basic(_, bindings) | Nested(_, bindings) | Sense(_, bindings):
            return bindings
        case Statistic(_, Sense(_, bindings)):
            return bindings
    return {}


def parameter_uses(automaton: Automaton, parameter: str, library: Library) -> tuple[str, ...]:
    """What is bound to a parameter of the automaton, in words."""
    return tuple(_uses(automaton, Parameter(parameter), library))


def _uses(automaton: Automaton, bound: Binding, library: Library) -> Iterator[str]:
    for state in automaton.states:
        if bound in bindings_of(state.content).values():
            yield f"state {shown_state(automaton, state.id, library)}"
    for use in automaton.features:
        if bound in bindings_of(use.source).values():
            yield f"feature {use.shown}"


def map_bindings(automaton: Automaton, changed: ChangeBinding) -> Automaton:
    """*automaton* with every binding in it *changed*."""
    states = with_bindings(automaton.states, changed)
    features = tuple(_feature(use, changed) for use in automaton.features)
    return replace(automaton, states=states, features=features)


def with_bindings(states: Iterable[State], changed: ChangeBinding) -> tuple[State, ...]:
    """*states* with every binding in them *changed*."""
    return tuple(replace(state, content=_content(state.content, changed)) for state in states)


def _content(content: Content, changed: ChangeBinding) -> Content:
    return (
        replace(content, bindings=_mapped(content.bindings, changed))
        if isinstance(content, Basic | Nested)
        else content
    )


def _feature(use: FeatureUse, changed: ChangeBinding) -> FeatureUse:
    return replace(use, source=_source(use.source, changed))


def _source(source: Source, changed: ChangeBinding) -> Source:
    match source:
        case Sense(name, bindings):
            return Sense(name, _mapped(bindings, changed))
        case Statistic(operation, Sense(name, bindings), over):
            return Statistic(operation, Sense(name, _mapped(bindings, changed)), over)
    return source


def _mapped(bindings: Bindings, changed: ChangeBinding) -> Bindings:
    return {slot: changed(binding) for slot, binding in bindings.items()}
