"""Checking one value of a project after another: only what has changed is looked at again."""

from collections.abc import Iterator
from dataclasses import dataclass

from ..examples import Example
from ..library import NodeType, Types
from ..project import Project
from ..remembered import Remembered
from ..vocabulary import Vocabulary
from .arms import arm_problems, demonstration_problems
from .automata import automaton_problems, library_problems
from .examples import example_problems, stray_examples
from .features import feature_problems
from .node_types import sound_types, type_problems
from .problem import Problem
from .reach import Where
from .scope import Scope, Subject, scopes
from .transitions import transition_problems


class Checker:
    """Finds everything that is wrong with a project, and remembers what it found out about each automaton."""

    def __init__(self) -> None:
        self._found: Remembered[Where, tuple[Problem, ...]] = Remembered()
        self._around: dict[str, _Around] = {}

    def check(self, project: Project, vocabulary: Vocabulary) -> tuple[Problem, ...]:
        """Everything that is wrong with *project* in a scenario with this *vocabulary*, file by file."""
        types = types_of(project, vocabulary)
        found = scopes(types, vocabulary)
        self._around = {name: self._known_around(name, scope) for name, scope in found.items()}
        problems = tuple(self._problems(project, types, found))
        self._found.keep([(name, key) for name, scope in found.items() for key in scope.library.automata])
        return problems

    def _known_around(self, type_name: str, scope: Scope) -> "_Around":
        """What surrounds the automata of a type: the same value as before where it is equal."""
        before = self._around.get(type_name)
        now = _Around(
            scope.type, scope.scenario, scope.vocabulary, scope.statistics, scope.shown, scope.senses
        )
        return before if before == now else now

    def _problems(self, project: Project, types: Types, found: dict[str, Scope]) -> Iterator[Problem]:
        yield from type_problems(project)
        yield from arm_problems(project, types)
        for type_name, scope in found.items():
            yield from library_problems(scope)
            for key, automaton in scope.library.automata.items():
                yield from self._of_automaton(scope, key, project.examples_of(type_name, automaton.id))
        yield from stray_examples(project, found)
        yield from demonstration_problems(project, types)

    def _of_automaton(self, scope: Scope, key: str, examples: tuple[Example, ...]) -> tuple[Problem, ...]:
        library, automaton = scope.library, scope.library.automata[key]
        held = tuple(library.automata.get(held) for held in automaton.nested())
        others = library if None in held else None  # where one is missing, all that there are are named
        made_of = (automaton, examples, self._around[scope.type.name], others, *held)
        subject = Subject(scope, automaton)
        return self._found.of(
            (scope.type.name, key), made_of, lambda: tuple(_automaton_problems(subject, examples))
        )


@dataclass(frozen=True, slots=True)
class _Around:
    """All of a scope that an automaton is checked against, but for the automata that it holds; see `Scope`."""

    type: NodeType
    scenario: Vocabulary
    vocabulary: Vocabulary
    statistics: Vocabulary
    shown: object
    senses: object


def types_of(project: Project, vocabulary: Vocabulary) -> Types:
    """The types of *project* that are sound enough to be checked against."""
    return Types(sound_types(project), project.libraries, vocabulary)


def _automaton_problems(subject: Subject, examples: tuple[Example, ...]) -> Iterator[Problem]:
    yield from automaton_problems(subject)
    yield from feature_problems(subject)
    yield from transition_problems(subject, examples)
    yield from example_problems(subject, examples)
