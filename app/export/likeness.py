"""Telling which behaviors of a file a project has already, and which only share a name with one of its own."""

from dataclasses import replace

from ..core.automaton import Automaton, Basic, Nested, State, trimmed
from ..core.edits.calls import meanings
from ..core.examples import Example
from ..core.project import Project
from ..core.storage.convert import automaton_document
from ..core.storage.text import written
from ..core.vocabulary import Vocabulary
from .bundle import refitted_from, without_moments


class Likeness:
    """Compares the behaviors of a file with those of a project.

    Behaviors are compared as they run: without notes and states that cannot be entered, and whatever their ids are.

    Attributes:
        taken: The names of the file that mean something else in the project, for any node type; those of behaviors that
            hold or direct such a one are among them, since they would do something else as well.
    """

    def __init__(self, project: Project, source: Project, vocabulary: Vocabulary) -> None:
        self._project, self._source = project, source
        self._directed = {
            (above, automaton.name)
            for node_type in source.types
            for automaton in source.library(node_type.name).automata.values()
            for above in meanings(source, node_type.name, automaton.name)
        }
        self.taken = frozenset(self._found(vocabulary))

    def directs(self, type_name: str, behavior: str) -> bool:
        """Whether a controller of this type means a behavior of the file by that name."""
        return (type_name, behavior) in self._directed

    def _found(self, vocabulary: Vocabulary) -> set[str]:
        behaviors = [
            (node_type, automaton)
            for node_type in self._source.types
            for automaton in self._source.library(node_type.name).automata.values()
        ]
        taken = {
            automaton.name
            for node_type, automaton in behaviors
            if (node_type.level == 0 and automaton.name in vocabulary.behaviors)
            or not self._agrees(node_type.name, automaton)
        }
        while more := {
            automaton.name
            for node_type, automaton in behaviors
            if automaton.name not in taken
            and self._project.library(node_type.name).by_name(automaton.name) is not None
            and self._mentioned(node_type.name, automaton) & taken
        }:
            taken |= more
        return taken

    def _agrees(self, type_name: str, automaton: Automaton) -> bool:
        """Whether the project has the same behavior of this name, or none."""
        here = self._project.library(type_name).by_name(automaton.name)
        if here is None:
            return True
        if _form(self._source, type_name, automaton) != _form(self._project, type_name, here):
            return False
        theirs = self._source.examples_of(type_name, automaton.id)
        return (
            not theirs
            or theirs in _taught(self._project, type_name, here)
            or self.completes(type_name, automaton)
        )

    def completes(self, type_name: str, automaton: Automaton) -> bool:
        """Whether the file has examples for a behavior that the project has already, but without any."""
        here = self._project.library(type_name).by_name(automaton.name)
        if here is None or self._project.examples_of(type_name, here.id):
            return False
        states = {state.id for state in automaton.states}
        return bool(self._source.examples_of(type_name, automaton.id)) and all(
            state.id in states for state in here.states
        )

    def _mentioned(self, type_name: str, automaton: Automaton) -> set[str]:
        """The names of behaviors that an automaton of the file holds or directs."""
        library = self._source.library(type_name)
        held = {library.get(nested).name for nested in automaton.nested()}
        return held | {
            state.content.behavior
            for state in automaton.states
            if isinstance(state.content, Basic) and self.directs(type_name, state.content.behavior)
        }


def _taught(
    project: Project, type_name: str, automaton: Automaton
) -> tuple[tuple[Example, ...], tuple[Example, ...]]:
    """The examples of an automaton as they would leave the project: those that models are fitted from, and all."""
    every = without_moments(project.examples_of(type_name, automaton.id))
    return refitted_from(project, type_name, trimmed(automaton)), every


def _form(project: Project, type_name: str, automaton: Automaton) -> bytes:
    """What an automaton does, apart from ids that differ from project to project."""
    library = project.library(type_name)

    def by_name(state: State) -> State:
        match state.content:
            case Nested(held, bindings) if held in library.automata:
                return replace(state, content=Nested(library.automata[held].name, bindings), note="")
        return replace(state, note="")

    plain = trimmed(automaton)
    states = tuple(by_name(state) for state in plain.states)
    return written(automaton_document(replace(plain, id="", learned_from="", states=states, note="")))
