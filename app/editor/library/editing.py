"""What the forms about a behavior change: the project itself, edit by edit, or a draft that is kept on OK."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from ...core.automaton import Automaton
from ...core.check.scope import Scope, scopes
from ...core.edits import rename_automaton
from ...core.errors import UnderstudyError
from ...core.library import Types
from ...core.project import Project

if TYPE_CHECKING:
    from ..studio import Studio

Change = Callable[..., Any]


class Editing(QObject):
    """An automaton that is being edited.

    Attributes:
        type, id: Which one.

    Signals:
        changed: It, or something that it is made from, is another value now.
    """

    changed = Signal()

    def __init__(self, studio: Studio, type_name: str, automaton_id: str) -> None:
        super().__init__()
        self._studio = studio
        self.type = type_name
        self.id = automaton_id
        self._scope: tuple[Project, Scope | None] | None = None

    @property
    def studio(self) -> Studio:
        """The studio that it belongs to."""
        return self._studio

    @property
    def project(self) -> Project:
        """The project with the automaton as it is now."""
        raise NotImplementedError

    def do(self, edit: Change, *args: Any, gesture: str = "", **kwargs: Any) -> str:
        """Apply an edit of `app.core.edits` to the automaton.

        Returns:
            Why that was not possible, in words; empty if it was.
        """
        try:
            self._apply(edit, (self.type, self.id, *args), kwargs, gesture)
        except UnderstudyError as error:
            return str(error)
        return ""

    def would(self, edit: Change, *args: Any, **kwargs: Any) -> str:
        """Why an edit would not be possible; empty if it would."""
        try:
            edit(self.project, self.type, self.id, *args, **kwargs)
        except UnderstudyError as error:
            return str(error)
        return ""

    def end_gesture(self) -> None:
        """The button was released."""

    def _apply(self, edit: Change, args: tuple[Any, ...], kwargs: dict[str, Any], gesture: str) -> None:
        raise NotImplementedError

    @property
    def automaton(self) -> Automaton | None:
        """The automaton as it is now; None if it is gone."""
        return self.project.library(self.type).automata.get(self.id)

    @property
    def types(self) -> Types:
        """The node types with what they can use, the automaton included."""
        return self.project.types_with(self._studio.document.scenario.vocabulary)

    @property
    def scope(self) -> Scope | None:
        """What the automaton can be made from; None while the types contradict each other."""
        project = self.project
        if self._scope is None or self._scope[0] is not project:
            try:
                found = scopes(self.types, self._studio.document.scenario.vocabulary).get(self.type)
            except UnderstudyError:
                found = None
            self._scope = project, found
        return self._scope[1]


class LiveEditing(Editing):
    """Changes the document at once; each edit is a step that can be undone."""

    def __init__(self, studio: Studio, type_name: str, automaton_id: str) -> None:
        super().__init__(studio, type_name, automaton_id)
        studio.document.project_changed.connect(self.changed)
        studio.opened.connect(self.changed)

    @property
    def project(self) -> Project:
        """The document's."""
        return self._studio.document.project

    def end_gesture(self) -> None:
        """The next change is a step of its own."""
        self._studio.document.end_gesture()

    def _apply(self, edit: Change, args: tuple[Any, ...], kwargs: dict[str, Any], gesture: str) -> None:
        self._studio.document.do(edit, *args, gesture=gesture, **kwargs)


class DraftEditing(Editing):
    """Collects edits of an automaton that does not exist yet, see `keep`."""

    def __init__(self, studio: Studio, begin: Callable[..., tuple[Project, str]], type_name: str) -> None:
        """A draft.

        Args:
            begin: The edit that makes the automaton, which takes a *name*; also returns its id.
        """
        self._begin = begin
        self._base = studio.document.project
        self._project, automaton_id = begin(self._base)
        self._steps: list[Callable[[Project], Any]] = []
        super().__init__(studio, type_name, automaton_id)

    @property
    def project(self) -> Project:
        """The document's project when the draft was begun, with the draft in it."""
        return self._project

    def _apply(self, edit: Change, args: tuple[Any, ...], kwargs: dict[str, Any], _gesture: str) -> None:
        if edit is rename_automaton:
            self._rename(*args[2:])
            return

        def step(project: Project) -> Project:  # under the id that it has in that project
            result = edit(project, self.type, self.id, *args[2:], **kwargs)
            return result[0] if isinstance(result, tuple) else result

        self._project = step(self._project)
        self._steps.append(step)
        self.changed.emit()

    def _rename(self, name: str) -> None:
        """Begin under another name: the id, which names the file, is made from the one that is kept."""
        begin = partial(self._begin, name=name)
        begin(self._base)  # raises if it cannot be called so
        self._begin = begin
        self._project = self._made(self._base)
        self.changed.emit()

    def _made(self, project: Project) -> Project:
        project, self.id = self._begin(project)
        for step in self._steps:
            project = step(project)
        return project

    def kept(self, project: Project) -> Project:
        """*project* with the draft.

        Raises:
            UnderstudyError: *project* has changed so much meanwhile that the draft does not go into it.
        """
        return self._project if project is self._base else self._made(project)
