"""Learning the transition functions of whole automata, and telling when they are stale.

Learning answers with a value of its own, `Learned`, which `apply` puts into a project: whoever asked may have changed
the project meanwhile, and decides whether the answer is still wanted.
"""

import hashlib
import json
import struct
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, is_dataclass, replace

from ..core.automaton import Automaton, Model, Refit
from ..core.cuts import with_cuts
from ..core.errors import ExampleError
from ..core.examples import Example
from ..core.library import Library, Types
from ..core.machine import Classifiers, stored_classifiers
from ..core.naming import shown_state
from ..core.project import Project
from ..core.transition import Classifier
from ..core.tree import Forest, Tree, flatten
from ..core.vocabulary import Vocabulary
from .builder import IsCancelled, LearningCancelled, never
from .dataset import Dataset, Sifted, columns_of, datasets, reader, refuse_unlearnable, sift
from .evaluation import BehaviorReport, StateReport, cross_validated, report_on
from .registry import fit, options_of, stored

#: Type name and automaton id.
Key = tuple[str, str]
#: Told the share that is done, from 0 to 1, and what is being worked on.
Progress = Callable[[float, str], None]

#: Raised whenever the same examples would give other models than before.
LEARNER_VERSION = 1


@dataclass(frozen=True, slots=True)
class LearnedAutomaton:
    """The models of one automaton, by state id, what they were learned from, and how good they are."""

    models: Mapping[str, Model]
    fingerprint: str
    report: BehaviorReport


@dataclass(frozen=True, slots=True)
class Learned:
    """What was learned, by type name and automaton id."""

    automata: Mapping[Key, LearnedAutomaton] = field(default_factory=dict)

    @property
    def reports(self) -> tuple[BehaviorReport, ...]:
        """The reports, in the order of learning."""
        return tuple(automaton.report for automaton in self.automata.values())


def quiet(share: float, what: str) -> None:
    """For *progress*: tell nobody."""


def learn(
    project: Project,
    vocabulary: Vocabulary,
    only: Sequence[Key] | None = None,
    progress: Progress = quiet,
    cancelled: IsCancelled = never,
    *,
    cross_validate: bool = False,
) -> Learned:
    """Learn the transition functions of automata from their examples.

    Args:
        vocabulary: The scenario's.
        only: Which automata, by type name and id; None takes all that have examples, the others are authored.
        cross_validate: Whether to estimate the accuracy on new examples too, which takes many times as long.

    Raises:
        ExampleError: One of *only* has nothing to learn from, or an example cannot be learned from.
        LibraryError: One of *only* does not exist.
        ScenarioError: The scenario lacks a feature in use.
        ParameterError: An automaton's classifier or one of its options is not allowed.
        LearningCancelled: *cancelled* returned true; it is asked between states and levels of trees.
    """
    types = project.types_with(vocabulary)
    keys = with_examples(project) if only is None else tuple(dict.fromkeys(only))
    learned: dict[Key, LearnedAutomaton] = {}
    for number, key in enumerate(keys):
        task = _Task(project, vocabulary, types, key, cross_validate=cross_validate)
        if only is not None:
            task.refuse_empty()

        def portion(share: float, what: str, number: int = number) -> None:
            progress((number + share) / len(keys), what)

        learned[key] = task.run(portion, cancelled)
    progress(1.0, "")
    return Learned(learned)


def with_examples(project: Project) -> tuple[Key, ...]:
    """The automata that have examples, disabled ones included, each after those that it holds."""
    return tuple(
        (node_type.name, automaton.id)
        for node_type in project.types
        for automaton in project.library(node_type.name).bottom_up()
        if project.examples_of(node_type.name, automaton.id)
    )


def every_automaton(project: Project) -> tuple[Key, ...]:
    """All automata, with examples or without."""
    return tuple(
        (node_type.name, automaton_id)
        for node_type in project.types
        for automaton_id in project.library(node_type.name).automata
    )


class _Task:
    """Learning one automaton."""

    def __init__(
        self, project: Project, scenario: Vocabulary, types: Types, key: Key, *, cross_validate: bool
    ) -> None:
        self._key = key
        self._type = types.type(key[0])
        self._library = project.library(key[0])
        self._automaton = self._library.get(key[1])
        self._examples = project.examples_of(*key)
        self._sifted = sift(self._automaton, self._examples)
        self._datasets = _checked(self._automaton, self._sifted, types.vocabulary(key[0]), scenario)
        self._cross_validate = cross_validate

    def refuse_empty(self) -> None:
        """Raise an `ExampleError` if there is nothing to learn from."""
        if self._sifted.kept:
            return
        left_out = len(self._sifted.left_out)
        disabled = len(self._examples) - left_out
        why = f"{disabled} are disabled and {left_out} left out" if self._examples else "teach it first"
        first = f", the first because {self._sifted.left_out[0].reason}" if left_out else ""
        raise ExampleError(
            f"behavior {self._automaton.name!r} has no examples to learn from ({why}{first}); it needs at least one"
        )

    def run(self, progress: Progress, cancelled: IsCancelled) -> LearnedAutomaton:
        automaton = self._automaton
        models: dict[str, Model] = {}
        reports: list[StateReport] = []
        options_of(automaton.settings)
        for number, (state, data) in enumerate(self._datasets.items()):
            name = shown_state(automaton, state, self._library)

            def step(share: float, number: int = number, name: str = name) -> None:
                progress((number + share) / len(self._datasets), f"{automaton.name}: {name}")

            step(0.0)
            if cancelled():
                raise LearningCancelled
            fitted = fit(data, automaton.settings, cancelled)
            if isinstance(fitted, Tree):
                fitted = with_cuts(fitted, automaton.cuts_of(state))
            held_out = (
                cross_validated(data, automaton.settings, cancelled, step) if self._cross_validate else None
            )
            models[state] = stored(fitted, automaton.settings)
            reports.append(report_on(data, fitted, (state, name), held_out))
        return LearnedAutomaton(models, fingerprint(automaton, self._examples), self._report(tuple(reports)))

    def _report(self, states: tuple[StateReport, ...]) -> BehaviorReport:
        kept, left_out = len(self._sifted.kept), self._sifted.left_out
        return BehaviorReport(*self._key, self._automaton.name, self._type.level, kept, states, left_out)


def _checked(
    automaton: Automaton, sifted: Sifted, vocabulary: Vocabulary, scenario: Vocabulary
) -> dict[str, Dataset]:
    refuse_unlearnable(automaton, sifted.kept, vocabulary)
    return datasets(automaton, sifted.kept, columns_of(automaton.features, scenario))


# ---------------------------------------------------------------------------------------------- into the project


def apply(project: Project, learned: Learned) -> Project:
    """*project* with what was learned; automata that it no longer has are skipped, unchanged ones stay the same value."""
    for (type_name, automaton_id), new in learned.automata.items():
        automata = project.library(type_name).automata
        old = automata.get(automaton_id)
        if old is not None and not _same(old, new):
            taught = replace(old, learned=new.models, learned_from=new.fingerprint)
            library = Library({**automata, automaton_id: taught})
            project = replace(project, libraries={**project.libraries, type_name: library})
    return project


def _same(old: Automaton, new: LearnedAutomaton) -> bool:
    return (
        old.learned_from == new.fingerprint
        and old.learned.keys() == new.models.keys()
        and all(_flat(old.learned[state]) == _flat(model) for state, model in new.models.items())
    )


def _flat(model: Model) -> object:
    """Comparable however deep: trees compare node by node, recursively."""
    if isinstance(model, Forest):
        return tuple(map(flatten, model.trees))
    return flatten(model) if isinstance(model, Tree) else model


# ---------------------------------------------------------------------------------------------- staleness


def fingerprint(automaton: Automaton, examples: Sequence[Example]) -> str:
    """A hash of exactly what learning depends on, so that models are stale when it has changed.

    That is: the contents of the examples that are learned from, in any order; the features in use; the order of the
    states they mention; classifier, options and pruning. Not: names, sampling, where examples came from, or how the
    scenario declares its features.
    """
    kept = sift(automaton, examples).kept
    used = {state for example in kept for state in (example.source, example.label)}
    features = [use.id for use in automaton.features]
    settings = automaton.settings
    contents = {
        "version": LEARNER_VERSION,
        "features": [[use.id, _plain(use.source)] for use in automaton.features],
        "states": [state.id for state in automaton.states if state.id in used],
        "classifier": settings.classifier,
        "options": {name: float(value) for name, value in settings.options.items()},
        "pruning": settings.pruning_confidence,
    }
    if automaton.cuts:  # without any, what was learned before there were cuts is not stale
        contents["cuts"] = [_plain(cut) for cut in automaton.cuts]
    found = hashlib.sha256(json.dumps(contents, sort_keys=True).encode())
    found.update(b"".join(_records(kept, features)))
    return found.hexdigest()


def _records(examples: Sequence[Example], features: Sequence[str]) -> list[bytes]:
    """The contents of examples as bytes, sorted. Thousands are told apart after every edit, so this is to be quick."""
    pack, read = struct.Struct(f"<{1 + len(features)}d").pack, reader(features)
    words: dict[tuple[str, str, bool], bytes] = {}  # few differ
    records = []
    for example in examples:
        kind = example.source, example.label, example.continuation
        if kind not in words:
            words[kind] = repr(kind).encode()
        records.append(words[kind] + pack(example.weight, *read(example.values)))
    return sorted(records)


def _plain(value: object) -> object:
    """A frozen value as JSON-ready data, with the name of its class."""
    if is_dataclass(value):
        return {type(value).__name__: {f.name: _plain(getattr(value, f.name)) for f in fields(value)}}
    if isinstance(value, tuple):
        return [_plain(item) for item in value]
    if isinstance(value, Mapping):
        return {str(key): _plain(item) for key, item in value.items()}
    return value


def is_stale(project: Project, type_name: str, automaton_id: str) -> bool:
    """Whether learning the automaton again could give something else; never for one without examples."""
    examples = project.examples_of(type_name, automaton_id)
    automaton = project.library(type_name).get(automaton_id)
    return bool(examples) and automaton.learned_from != fingerprint(automaton, examples)


# ---------------------------------------------------------------------------------------------- running


def classifiers(project: Project, vocabulary: Vocabulary) -> Classifiers:
    """Finds what the learned states of *project* decide by: stored trees and forests, or classifiers refitted once."""
    refitted: dict[tuple[str, str, str], Classifier | None] = {}

    def find(type_name: str, automaton: Automaton, state: str) -> Classifier | None:
        if not isinstance(automaton.learned.get(state), Refit):
            return stored_classifiers(type_name, automaton, state)
        key = type_name, automaton.id, state
        if key not in refitted:
            refitted[key] = refit(project, vocabulary, *key)
        return refitted[key]

    return find


def refit(
    project: Project, vocabulary: Vocabulary, type_name: str, automaton_id: str, state: str
) -> Classifier | None:
    """The classifier of a state, learned anew from the project's examples; None if there are none for it."""
    automaton = project.library(type_name).get(automaton_id)
    sifted = sift(automaton, project.examples_of(type_name, automaton_id))
    found = _checked(automaton, sifted, project.types_with(vocabulary).vocabulary(type_name), vocabulary)
    return fit(found[state], automaton.settings) if state in found else None
