"""Undo and redo by value: a step keeps the projects before and after it, which share all that did not change."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from .edits import describe
from .errors import EditError
from .project import Project


@dataclass(frozen=True, slots=True)
class Edit:
    """One step.

    Attributes:
        text: What the undo menu says: "Rename state left of Goto to turn".
        gesture: Steps of one gesture, such as dragging a slider, become one; empty for a step of its own.
        mark: What else happened with it, for whoever pushed it: a pick of a lesson, or something moved in the world.
    """

    text: str
    before: Project
    after: Project
    gesture: str = ""
    mark: object = None


class History:
    """The project as it is now, with the steps that led here and those that were undone.

    Attributes:
        project: The project as it is now.
    """

    def __init__(self, project: Project, longest: int | None = None) -> None:
        """Begin with a *project* as it is saved.

        Args:
            longest: How many steps can be undone; None means all.
        """
        if longest is not None and longest < 1:
            raise EditError(f"a history keeps 1 step or more, or all of them, but not {longest}")
        self.project = project
        self._saved: Project | None = project
        self._longest = longest
        self._done: list[Edit] = []
        self._undone: list[Edit] = []
        self._gesture = ""

    # ------------------------------------------------------------------------------------------- forward

    def push(self, text: str, project: Project, gesture: str = "", mark: object = None) -> None:
        """Go on with *project*; the way there can be undone as *text*, and what was undone is gone.

        Args:
            gesture: Where it is the same as that of the step before, and nothing came between, the two become one.
            mark: See `Edit`; a step with one is kept even where the project stays the same.
        """
        if project is self.project and mark is None:
            return
        before = self.project
        if gesture and gesture == self._gesture and self._done and not self.is_saved:
            before = self._done.pop().before
        self._done.append(Edit(text, before, project, gesture, mark))
        self._undone.clear()
        if self._longest is not None:
            del self._done[: -self._longest]
        self._gesture = gesture
        self.project = project

    def do(self, edit: Callable[..., Any], *args: Any, gesture: str = "", **kwargs: Any) -> Any:
        """Push what *edit* makes of the project, under its own sentence.

        Args:
            edit: A function of `app.core.edits`; *args* and *kwargs* are its arguments after the project.

        Returns:
            What the edit returns besides the project, such as the id of what it made; None if there is nothing.
        """
        text = describe(edit, self.project, *args, **kwargs)
        result = edit(self.project, *args, **kwargs)
        project, *more = result if isinstance(result, tuple) else (result,)
        self.push(text, project, gesture)
        return more[0] if more else None

    def end_gesture(self) -> None:
        """The button was released: the next step stands by itself."""
        self._gesture = ""

    # ---------------------------------------------------------------------------------------------- back

    @property
    def can_undo(self) -> bool:
        """Whether there is a step to undo."""
        return bool(self._done)

    @property
    def can_redo(self) -> bool:
        """Whether there is a step to redo."""
        return bool(self._undone)

    @property
    def undo_text(self) -> str:
        """What `undo` would undo; empty if there is nothing."""
        return self._done[-1].text if self._done else ""

    @property
    def redo_text(self) -> str:
        """What `redo` would redo; empty if there is nothing."""
        return self._undone[-1].text if self._undone else ""

    @property
    def last(self) -> Edit | None:
        """The step that `undo` would undo, if there is one."""
        return self._done[-1] if self._done else None

    @property
    def next(self) -> Edit | None:
        """The step that `redo` would redo, if there is one."""
        return self._undone[-1] if self._undone else None

    @property
    def steps(self) -> tuple[Edit, ...]:
        """The steps that can be undone, the oldest first."""
        return tuple(self._done)

    def undo(self) -> Edit:
        """Go back one step, which is returned.

        Raises:
            EditError: There is none.
        """
        if not self._done:
            raise EditError("there is nothing to undo")
        edit = self._done.pop()
        self._undone.append(edit)
        return self._arrive(edit, edit.before)

    def redo(self) -> Edit:
        """Go forward again one step, which is returned.

        Raises:
            EditError: There is none.
        """
        if not self._undone:
            raise EditError("there is nothing to redo")
        edit = self._undone.pop()
        self._done.append(edit)
        return self._arrive(edit, edit.after)

    def _arrive(self, edit: Edit, project: Project) -> Edit:
        self._gesture = ""
        self.project = project
        return edit

    # --------------------------------------------------------------------------------------------- saved

    @property
    def is_saved(self) -> bool:
        """Whether the project as it is now is the one that was saved last."""
        return self.project is self._saved

    def mark_saved(self, project: Project | None = None) -> None:
        """Say that *project*, or the one as it is now, has been saved.

        Saving takes time, so what was saved may not be what there is when it ends.
        """
        self._saved = self.project if project is None else project

    def mark_unsaved(self) -> None:
        """Say that no value of the project is on disk, e.g. after a recovery or in a new project."""
        self._saved = None

    def amend(self, change: Callable[[Project], Project]) -> None:
        """Change the project without a step of its own: undoing the last step undoes this as well.

        For what follows by itself from a step, such as what is learned from the examples that it recorded.
        """
        changed = change(self.project)
        if changed is self.project:
            return
        if self._done:
            self._done[-1] = replace(self._done[-1], after=changed)
        self.project = changed
