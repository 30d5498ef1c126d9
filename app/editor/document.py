"""The project that is open, with its history: the one place where the window changes it."""

from collections.abc import Callable
from datetime import datetime
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

from ..core.automaton import Automaton
from ..core.errors import UnderstudyError
from ..core.history import Edit, History
from ..core.library import Types
from ..core.project import Project
from ..core.remembered import Remembered
from ..core.vocabulary import Vocabulary
from ..learner.freshness import Freshness
from ..sim.scenario import Scenario


class Document(QObject):
    """A project, its history, and where it is kept.

    Attributes:
        scenario: What the project lives in.
        folder: Where it is kept; None before it was saved for the first time.
        revision: Grows with every change.
        read_only: Whether saving is to ask for another folder.
        saving: Whether it is being saved just now.
        freshness: Which automata have changed since they were learned; threads may ask it.
        autosaved: When unsaved work was kept last; None while nothing unsaved is kept.

    Signals:
        opened: Another project was opened.
        project_changed: From one value to the next, whether by an edit, by undo or redo, or by what the session recorded.
        history_changed: What can be undone, redone or saved is something else.
        refused: An edit was not possible; the message says why.
    """

    opened = Signal()
    project_changed = Signal(object, object)
    history_changed = Signal()
    refused = Signal(str)

    def __init__(self, project: Project, scenario: Scenario, folder: Path | None = None) -> None:
        super().__init__()
        self._history = History(project)
        self.scenario = scenario
        self.folder = folder
        self.revision = 0
        self.read_only = False
        self.saving = False
        self.autosaved: datetime | None = None
        self.freshness = Freshness()
        self._types: Remembered[str, Types] = Remembered()

    def begin(self, project: Project, scenario: Scenario, folder: Path | None, *, saved: bool = True) -> None:
        """Open another project.

        Args:
            saved: Whether this value of it is what the folder holds.
        """
        self._history = History(project)
        if not saved:
            self._history.mark_unsaved()
        self.scenario, self.folder = scenario, folder
        self.read_only, self.autosaved = False, None
        self.revision += 1
        self.opened.emit()
        self.history_changed.emit()

    # ----------------------------------------------------------------------------------------- looking

    @property
    def project(self) -> Project:
        """The project as it is now."""
        return self._history.project

    @property
    def history(self) -> History:
        """What can be undone and redone; to be read only."""
        return self._history

    @property
    def is_saved(self) -> bool:
        """Whether the folder holds the project as it is now."""
        return self._history.is_saved

    @property
    def types(self) -> Types:
        """The node types with what they can use."""
        project, scenario = self.project, self.scenario
        made_of = project.types, project.libraries, scenario
        return self._types.of("", made_of, lambda: project.types_with(scenario.vocabulary))

    def vocabulary(self, type_name: str) -> Vocabulary:
        """What automata of a type are made from."""
        return self.types.vocabulary(type_name)

    def automaton(self, type_name: str, automaton_id: str) -> Automaton | None:
        """The automaton with this id, if there is one."""
        return self.project.library(type_name).automata.get(automaton_id)

    # ---------------------------------------------------------------------------------------- changing

    def do(self, edit: Callable[..., Any], *args: Any, gesture: str = "", **kwargs: Any) -> Any:
        """Change the project by an edit of `app.core.edits`, undoable under its own sentence.

        Returns:
            What the edit returns besides the project, such as the id of what it made.

        Raises:
            UnderstudyError: The edit is not possible.
        """
        before = self.project
        result = self._history.do(edit, *args, gesture=gesture, **kwargs)
        self._arrived(before)
        return result

    def attempt(self, edit: Callable[..., Any], *args: Any, gesture: str = "", **kwargs: Any) -> Any:
        """Like `do`, but an edit that is not possible is told to the user.

        Returns:
            What `do` returns, True where that is None, and False where the edit was refused.
        """
        try:
            result = self.do(edit, *args, gesture=gesture, **kwargs)
        except UnderstudyError as error:
            self.refused.emit(str(error))
            return False
        return True if result is None else result

    def push(self, text: str, project: Project, gesture: str = "", mark: object = None) -> None:
        """Go on with *project*, undoable as *text*; see `History.push`."""
        before = self.project
        self._history.push(text, project, gesture, mark)
        self._arrived(before)

    def amend(self, change: Callable[[Project], Project]) -> None:
        """Change the project as part of the last step; see `History.amend`."""
        before = self.project
        self._history.amend(change)
        self._arrived(before)

    def end_gesture(self) -> None:
        """The button was released: the next step stands by itself."""
        self._history.end_gesture()

    def undo(self) -> Edit:
        """Go back one step; see `Studio.undo`, which also undoes what happened in the world."""
        before = self.project
        edit = self._history.undo()
        self._arrived(before)
        return edit

    def redo(self) -> Edit:
        """Go forward again one step."""
        before = self.project
        edit = self._history.redo()
        self._arrived(before)
        return edit

    def mark_saved(self, project: Project, folder: Path) -> None:
        """Say that *project*, which may be an earlier value, is what *folder* holds."""
        self.folder = folder
        self._history.mark_saved(project)
        self.history_changed.emit()

    def _arrived(self, before: Project) -> None:
        if self.project is not before:
            self.revision += 1
            self.project_changed.emit(before, self.project)
        self.history_changed.emit()
