"""What automata of a type can use, worked out once for each value of the project."""

from ...core.automaton import Automaton
from ...core.check.scope import Scope, scopes
from ...core.errors import UnderstudyError
from ...core.project import Project
from ..document import Document


class Scoping:
    """The scopes of the document's types."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._kept: tuple[Project, dict[str, Scope]] | None = None

    def scope(self, type_name: str) -> Scope | None:
        """The scope of a type; None where the types themselves are broken."""
        project = self._document.project
        if self._kept is None or not _alike(self._kept[0], project):
            self._kept = project, self._made()
        return self._kept[1].get(type_name)

    def _made(self) -> dict[str, Scope]:
        document = self._document
        try:
            return scopes(document.types, document.scenario.vocabulary)
        except UnderstudyError:
            return {}

    def automaton(self, type_name: str, automaton_id: str) -> Automaton | None:
        """An automaton, if it is there."""
        return self._document.automaton(type_name, automaton_id)


def _alike(a: Project, b: Project) -> bool:
    return a.libraries is b.libraries and a.types is b.types and a.scenario == b.scenario
