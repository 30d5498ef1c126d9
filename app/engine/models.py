"""Learned models in the form in which they decide, kept until they are learned anew."""

from ..core.automaton import Automaton, Refit
from ..core.machine import Classifiers, stored_classifiers
from ..core.project import Project
from ..core.transition import Classifier
from ..core.vocabulary import Vocabulary
from ..learner.trainer import refit

#: Type name, automaton id, and the fingerprint of what was learned from.
Version = tuple[str, str, str]


class Models:
    """Finds what learned states decide by.

    Models without a table form are fitted again from the examples, when they are first asked for. That happens once for
    each time they were learned: an example that is recorded later changes nothing before it is learned from.
    """

    def __init__(self, vocabulary: Vocabulary) -> None:
        self._vocabulary = vocabulary
        self._projects: dict[Version, Project] = {}
        self._fitted: dict[tuple[Version, str], Classifier | None] = {}

    def use(self, project: Project) -> None:
        """Decide by the models of *project* from now on."""
        versions = [
            (type_name, automaton.id, automaton.learned_from)
            for type_name, library in project.libraries.items()
            for automaton in library.automata.values()
            if any(isinstance(model, Refit) for model in automaton.learned.values())
        ]
        self._projects = {version: self._projects.get(version, project) for version in versions}
        self._fitted = {key: fitted for key, fitted in self._fitted.items() if key[0] in self._projects}

    @property
    def classifiers(self) -> Classifiers:
        """For the machine; the same function always."""
        return self._find

    def _find(self, type_name: str, automaton: Automaton, state: str) -> Classifier | None:
        version = type_name, automaton.id, automaton.learned_from
        if version not in self._projects or not isinstance(automaton.learned.get(state), Refit):
            return stored_classifiers(type_name, automaton, state)
        key = version, state
        if key not in self._fitted:
            self._fitted[key] = refit(
                self._projects[version], self._vocabulary, type_name, automaton.id, state
            )
        return self._fitted[key]
