"""Checks of examples: finite numbers, states that exist, a value for every feature."""

from collections.abc import Collection, Iterator
from functools import partial
from math import isfinite

from ..automaton import START
from ..edits import disable_examples
from ..errors import ExampleError
from ..examples import Example
from ..naming import shown_state
from ..project import Project
from .problem import Problem, Severity, allowed, examples_file, place
from .scope import Scope, Subject
from .transitions import raises_flag


def stray_examples(project: Project, scopes: dict[str, Scope]) -> Iterator[Problem]:
    """Examples of automata that do not exist. Those of types that do not exist are told with the types."""
    for type_name, by_id in project.examples.items():
        for automaton_id in by_id:
            if type_name in scopes and automaton_id not in scopes[type_name].library.automata:
                there = allowed(automaton_id, scopes[type_name].library.automata)
                message = (
                    f"the library of {type_name!r} has no behavior with the id {automaton_id!r}; {there}"
                )
                yield Problem(
                    examples_file(type_name, automaton_id), "automaton", message, raises=ExampleError
                )


def example_problems(subject: Subject, examples: tuple[Example, ...]) -> Iterator[Problem]:
    """What is wrong with the enabled examples of an automaton; disabled ones are not learned from."""
    states = {state.id: state for state in subject.automaton.states}
    vocabulary = subject.scope.vocabulary
    raising = {state.id for state in states.values() if raises_flag(state, vocabulary)}
    features = {use.id for use in subject.automaton.features}
    for index, example in _suspects(examples, states.keys(), raising):
        for key, value in example.values.items():
            if not isfinite(value):
                message = f"feature {key!r} is {value}; it must be a finite number"
                yield _problem(subject, example, place("examples", index, "values", key), message, "error")
        if not (isfinite(example.weight) and example.weight > 0.0):
            message = f"the weight is {example.weight}; it must be a finite number above 0"
            yield _problem(subject, example, place("examples", index, "weight"), message, "error")
        for end, state_id in (("source", example.source), ("label", example.label)):
            if state_id not in states:
                message = f"state {state_id!r} does not exist, so nothing is learned from this; {allowed(state_id, states)}"
                yield _problem(subject, example, place("examples", index, end), message, "warning")
        if example.source in raising:
            message = f"state {example.source!r} raises a flag and is left at once, so nothing can be learned for it"
            yield _problem(subject, example, place("examples", index, "source"), message, "error")
        if example.label == START:
            message = "it leads to Start, where only a raised flag leads"
            yield _problem(subject, example, place("examples", index, "label"), message, "error")
    yield from _unmeasured(subject, examples, features)
    if not features:
        yield from _not_told_apart(subject, examples)


def _suspects(
    examples: tuple[Example, ...], states: Collection[str], raising: Collection[str]
) -> Iterator[tuple[int, Example]]:
    """Those in which something may be wrong: nearly all are sound, and thousands are looked at after every edit."""
    for index, example in enumerate(examples):
        sound = (
            example.source in states
            and example.label in states
            and example.source not in raising
            and example.label != START
            and isfinite(sum(example.values.values()) + example.weight)
            and example.weight > 0.0
        )
        if example.enabled and not sound:
            yield index, example


def _problem(subject: Subject, example: Example, where: str, message: str, severity: Severity) -> Problem:
    type_name, automaton_id = subject.scope.type.name, subject.automaton.id
    mend = partial(_disable, type_name, automaton_id, example.id)
    text = f"example {example.id!r} of {subject.automaton.name}: {message}"
    file = examples_file(type_name, automaton_id)
    return Problem(file, where, text, severity, "disable the example", mend, ExampleError)


def _disable(type_name: str, automaton_id: str, example_id: str, project: Project) -> Project:
    return disable_examples(project, type_name, automaton_id, [example_id])


def _unmeasured(subject: Subject, examples: tuple[Example, ...], features: set[str]) -> Iterator[Problem]:
    """One warning for each feature that some enabled examples have no value of."""
    lacking: dict[str, list[Example]] = {}
    for example in examples:
        if example.enabled and not features <= example.values.keys():
            for feature in features - example.values.keys():
                lacking.setdefault(feature, []).append(example)
    for feature in sorted(lacking):
        without = lacking[feature]
        lost = sum(not example.snapshot for example in without)
        message = (
            f"{len(without)} of {len(examples)} examples of {subject.automaton.name} have no value of feature {feature!r}, so "
            f"nothing is learned from them; it can be measured in the stored moments of {len(without) - lost} of them"
        )
        file = examples_file(subject.scope.type.name, subject.automaton.id)
        yield Problem(file, "examples", message, "warning", raises=ExampleError)


def _not_told_apart(subject: Subject, examples: tuple[Example, ...]) -> Iterator[Problem]:
    """A warning if examples of what looks at nothing go from one state to several: then chance decides where to."""
    automaton, library = subject.automaton, subject.scope.library
    goes: dict[str, dict[str, None]] = {}
    for example in examples:
        if example.enabled:
            goes.setdefault(example.source, {})[example.label] = None
    for source, labels in goes.items():
        if len(labels) > 1:
            choices = " or ".join(shown_state(automaton, label, library) for label in labels)
            message = (
                f"{automaton.name} looks at nothing (its settings say, under Features, what it may look at, also after it was "
                f"taught), so chance decides in {shown_state(automaton, source, library)}: {choices}"
            )
            yield subject.warning("features", message)
            return
