"""Leaving a project: what is unsaved, still being learned, or ended by it is asked about first."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from ...core.amounts import counted
from ...engine.snapshots import Mode
from .asking import Answer
from .held import Then

if TYPE_CHECKING:
    from .files import Files


class Leaving(QObject):
    """Lets whoever wants to end the work on the open project do so once nothing can be lost by it."""

    def __init__(self, files: Files) -> None:
        super().__init__(files)
        self._files = files
        self._studio = files.studio
        self._then: Then | None = None  # when all is learned

    def leave(self, then: Then) -> None:
        """Do *then*, unless the user decides otherwise."""
        saving = self._files.saving
        if self._files.is_asking:
            return  # something else is being asked
        if saving.runs:
            saving.afterwards(partial(self.leave, then))
        elif self._studio.is_open and not self._studio.document.is_saved:
            self._ask_unsaved(then)
        elif self._is_learning:
            self._ask_learning(then)
        elif ended := self._files.what_ends():
            self._ask_ending(ended, then)
        else:
            then()

    @property
    def _is_learning(self) -> bool:
        studio = self._studio
        return studio.is_open and (studio.relearning.busy or studio.mode is Mode.LEARNING)

    def _ask_unsaved(self, then: Then) -> None:
        document, folder = self._studio.document, self._files.held.folder
        steps = counted(len(document.history.steps), "step")
        where = "" if folder is None else f" in {folder}"
        text = f"{document.project.name or 'This project'}{where} has unsaved changes ({steps} that can be undone)."
        if self._is_learning:
            text += (
                " Something is still being learned; what comes of it is learned again when it is opened next."
            )
        text += self._ending()
        self._files.ask(
            "Save the changes?",
            text,
            (
                Answer("Save", lambda: self._files.saving.save(partial(self._after_saving, then))),
                Answer("Discard", then, "Close without saving; the changes are gone"),
                Answer("Cancel"),
            ),
            look="content-save-outline",
        )

    def _after_saving(self, then: Then) -> None:
        """Go on after saving, unless something else has become unsaved meanwhile."""
        if self._studio.document.is_saved:
            then()
        else:
            self.leave(then)

    def _ask_learning(self, then: Then) -> None:
        def wait() -> None:
            self._studio.relearning.changed.connect(self._learned)
            self._studio.bridge.mode_changed.connect(self._learned)
            self._then = then
            self._learned()

        self._files.ask(
            "Something is being learned",
            "Behaviors are being learned from their examples. The examples are saved; what is not learned now can be "
            "learned again at any time." + self._ending(),
            (Answer("Wait for it", wait), Answer("Close now", then), Answer("Cancel")),
            look="school-outline",
        )

    def _ending(self) -> str:
        ended = self._files.what_ends()
        return f"\n\n{ended}" if ended else ""

    def _ask_ending(self, ended: str, then: Then) -> None:
        self._files.ask(
            "Stop what is running?",
            ended,
            (
                Answer("Stop it", then, "Stop it, and close the project"),
                Answer("Keep it running", tip="The project stays open"),
            ),
            look="flask-outline",
        )

    def _learned(self) -> None:
        if self._then is not None and not self._is_learning:
            then, self._then = self._then, None
            self._studio.relearning.changed.disconnect(self._learned)
            self._studio.bridge.mode_changed.disconnect(self._learned)
            self.leave(then)
