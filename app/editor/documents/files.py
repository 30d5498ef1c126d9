"""Projects as a window handles them: which one is open, where it is kept, and that nothing is lost on the way."""

from __future__ import annotations

import gc
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, Signal

from ...core.edits import rename_project
from ...core.errors import UnderstudyError
from ...core.project import Project
from ...core.storage import file_is_there
from ...engine.scenarios import open_scenario
from ...sim.scenario import Scenario
from ..actions import ActionRow
from ..message import Kind, Message
from . import autosaves, claims, colors
from .asking import Answer, Question
from .autosaves import Autosave
from .autosaving import Autosaving
from .background import Background
from .choosing import choose_folder
from .held import Held, Then
from .leaving import Leaving
from .new_project import NewProject, Order
from .opening import Opening, Wish
from .outside import Stamps, changes, stamps_of
from .private import private_folder, unnamed_folder
from .rows import file_rows, leaving_rows
from .save_as import SaveAs
from .saving import Saving, Stored
from .words import clock, unclaimed

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget

    from ..studio import Studio


class Files(QObject):
    """Opens, saves and closes projects for a window.

    Attributes:
        held: Where the open project is kept.
        state: The user's own folder for what the window keeps from one start to the next.
        owner: This window, as others find it in lock files.
        what_ends: Says what else runs for the open project and ends with the work on it; nothing where that is empty.

    Signals:
        waiting: What the user has to wait for; an empty text when that is over.
    """

    waiting = Signal(str)

    def __init__(self, studio: Studio, window: QWidget) -> None:
        super().__init__(window)
        self.studio = studio
        self.state = studio.settings.state
        self.owner = claims.new_owner()
        self.held = Held()
        self.what_ends: Callable[[], str] = lambda: ""
        self.background = Background(self)
        self.opening = Opening(self)
        self.saving = Saving(self)
        self.autosaving = Autosaving(self)
        self._leaving = Leaving(self)
        self._window = window
        self._looking = False
        self._told: tuple[str, ...] = ()
        studio.opened.connect(self._opened)
        window.installEventFilter(self)

    def rows(self) -> tuple[ActionRow, ...]:
        """The first actions of the File menu."""
        return file_rows(self)

    def leaving_rows(self) -> tuple[ActionRow, ...]:
        """The last ones."""
        return leaving_rows(self)

    @property
    def is_asking(self) -> bool:
        """Whether the user is being asked something in the window."""
        return any(question.isVisible() for question in self._window.findChildren(Question))

    def ask(
        self,
        title: str,
        text: str,
        answers: Sequence[Answer],
        details: str = "",
        look: str = "help-circle-outline",
        standard: int = 0,
    ) -> Question:
        """Ask the user in the window, who has to wait for nothing meanwhile; see `Question`."""
        self.waiting.emit("")
        question = Question(self._window, self.studio.theme, title, text, answers, details, look)
        question.buttons[standard].setDefault(True)
        question.buttons[standard].setFocus()
        question.ask()
        return question

    def unask(self) -> None:
        """Leave what is being asked, as Esc does."""
        for question in self._window.findChildren(Question):
            question.reject()

    # -------------------------------------------------------------------------------------------- opening

    def open(self, folder: Path, arm: str = "", *, trust: bool = False, recover: bool = False) -> None:
        """Open the project in *folder*, after asking what is to become of the one that is open.

        Args:
            recover: With what a window that is gone had kept of it; otherwise that is asked.
        """
        folder = folder.parent if folder.name == "project.json" else folder
        self.leave(lambda: self.opening.open(Wish(folder, arm, trust, recover=recover)))

    def choose(self) -> None:
        """Let the user choose a project's folder, and open it."""
        beside = self.held.folder or next(iter(self.studio.settings.recent), Path.home())
        choose_folder(self._window, "Open a project's folder", beside.parent, self.open)

    def reload(self) -> None:
        """Open the project again as its folder holds it; what is unsaved is gone."""
        if self.held.folder is not None:
            arm, held = self.studio.arm, self.held
            name = "" if arm is None else arm.name
            self.opening.open(Wish(self.held.folder, name, shared=not held.claimed, read_only=held.read_only))

    def recover(self, kept: Autosave) -> None:
        """Open what a window that is gone had kept of a project that cannot be opened or was never saved."""

        def ready() -> tuple[Project, Scenario]:
            project = kept.project()
            return project, open_scenario(project, kept.folder)

        def show(result: tuple[Project, Scenario]) -> None:
            project, scenario = result
            self.show(Held(kept.folder, kept.private), project, scenario, saved=False)
            self.autosaving.adopt(kept.private)

        self.leave(lambda: self.background.do(ready, show, self._refused))

    def show(
        self,
        held: Held,
        project: Project,
        scenario: Scenario,
        *,
        recovered: Project | None = None,
        arm: str = "",
        saved: bool = True,
    ) -> None:
        """Have the window show a project, which is kept as *held* says.

        Args:
            recovered: A later value of it, from an autosave; going there is a step that can be undone.
        """
        self._release(held.private)
        self.held = held
        self._told = ()
        places = {} if held.folder is None else colors.read(private_folder(held.folder, self.state))
        self.studio.open(project, scenario, held.folder, saved=saved, arm=arm, colors=places)
        self.studio.document.read_only = held.read_only
        self.studio.document.history_changed.emit()
        if recovered is not None and held.private is not None:
            self.studio.document.push("Recover what was autosaved", recovered)
            self.autosaving.adopt(held.private)
        if held.private is not None:
            self._quietly(partial(autosaves.note, self.state, self.owner, held.private))
        if held.folder is not None:
            self.studio.settings.remember(held.folder)
        gc.freeze()  # a project stays long: looking through it for garbage would hold the window up

    def scratch(self, project: Project, scenario: Scenario) -> None:
        """Open a project that no folder holds, in the place of the one that is open."""
        self.leave(
            lambda: self.show(
                Held(private=unnamed_folder(self.state, self.owner.token)), project, scenario, saved=True
            )
        )

    def offer_left_over(self, but: Path | None = None) -> None:
        """Tell of what windows that ended without closing had kept; opening project *but* asks about its own."""

        def found() -> list[Autosave]:
            ours = None if but is None else but.resolve()
            return [
                kept for kept in autosaves.left_over(self.state) if kept.folder is None or kept.folder != ours
            ]

        def offer(left: list[Autosave]) -> None:
            for kept in left:
                self._offer(kept)

        self.background.do(found, offer, self._refused)

    def _offer(self, kept: Autosave) -> None:
        folder = kept.folder
        openable: Callable[[], object] = partial(self.recover, kept)
        if folder is not None and file_is_there(folder / "project.json"):
            openable = partial(self.open, folder, recover=True)
        name = f"{kept.name or 'a project'}{'' if folder is None else f' in {folder}'}"
        text = f"Understudy ended without saving {name}; it was autosaved at {clock(kept.at)}"
        answers = (("Recover", openable), ("Discard", partial(autosaves.discard, kept.private)))
        self.studio.said.emit(
            Message(text, Kind.WARNING, answers, holds=lambda: self.held.private != kept.private)
        )

    # --------------------------------------------------------------------------------------------- a new one

    def ask_new(self) -> None:
        """Ask what a new project is to be like, and make it."""
        dialog = NewProject(self._window, self.studio)
        dialog.ordered.connect(lambda order: self.leave(lambda: self._make(order)))
        dialog.open()

    def _make(self, order: Order) -> None:
        self.studio.settings.projects_folder = order.folder.parent
        self.waiting.emit(f"Making {order.folder.name}…")
        wish = Wish(order.folder, trust=order.brings_code)
        self.background.do(order.make, lambda _: self.opening.open(wish), self._refused)

    # --------------------------------------------------------------------------------------------- saving

    def save(self) -> None:
        """Save the project where it is kept."""
        if self.studio.is_open:
            self.saving.save()

    def save_as(self) -> None:
        """Ask where to, and save."""
        self.choose_place()

    def choose_place(self, then: Then | None = None, why: str = "") -> None:
        """Ask for a folder, save there, and go on with *then*."""
        if not self.studio.is_open:
            return
        dialog = SaveAs(self._window, self.studio, self.held.folder, why)

        def chosen(name: str, folder: Path) -> None:
            if name != self.studio.document.project.name:
                self.studio.document.attempt(rename_project, name)
            self.studio.settings.projects_folder = folder.parent
            self.saving.into(folder, then)

        dialog.chosen.connect(chosen)
        dialog.open()

    def saved(self, project: Project, folder: Path, stored: Stored) -> None:
        """*folder* holds *project* now, and is where it is kept."""
        if folder != self.held.folder or not self.held.claimed:
            self._move_to(folder, stored.private)
        self.held = replace(self.held, folder=folder, base=project, stamps=stored.stamps, read_only=False)
        document = self.studio.document
        document.read_only = False
        document.mark_saved(project, folder)
        self.studio.settings.remember(folder)
        self._told = ()
        if document.is_saved:
            self.autosaving.discard()
        self.studio.touch()

    def _move_to(self, folder: Path, private: Path) -> None:
        """Give the folder free that the project was kept in, and claim the one that it is kept in now."""
        if folder != self.held.folder:
            self.autosaving.discard()
            self._release(private)
        try:
            claimed = claims.claim(private, self.owner) is None
        except OSError as error:
            claimed = False
            if folder != self.held.folder:  # of the other it was told when it was opened
                self.studio.warn(unclaimed(private, error))
        if claimed:
            self.held = replace(self.held, private=private, claimed=True)
            self._quietly(lambda: autosaves.note(self.state, self.owner, private))

    # --------------------------------------------------------------------------------------------- closing

    def close(self) -> None:
        """Close the project, and show the welcome page."""
        if self.studio.is_open:
            self.leave(self._close)

    def _close(self) -> None:
        self._release(None)
        self.held = Held()
        self.studio.close_project()

    def quit(self) -> None:
        """Close the window."""
        self._window.close()

    def may_close(self, then: Then) -> None:
        """Do *then*, which ends the window, once nothing can be lost by it."""

        def end() -> None:
            self._release(None)
            self.shut_down()
            then()

        self.leave(end)

    def leave(self, then: Then) -> None:
        """Do *then*, which ends the work on the open project, once nothing can be lost by it."""
        self._leaving.leave(then)

    def shut_down(self) -> None:
        """End what runs in the background."""
        self.opening.cancel()
        self.background.close()
        self.autosaving.stop()
        autosaves.strike(self.state, self.owner)

    def _release(self, next_private: Path | None) -> None:
        """Give the project free that was open; what was autosaved of it is not needed any more."""
        self.autosaving.discard()
        if self.held.claimed and self.held.private is not None and self.held.private != next_private:
            claims.release(self.held.private, self.owner)

    # ------------------------------------------------------------------------------- what happens outside

    def _opened(self) -> None:
        """A project was opened by somebody else than this, as a scratch or in a test."""
        folder = self.studio.document.folder
        if self.studio.is_open and folder != self.held.folder:
            self._release(None)
            self.held = Held(folder, None if folder is None else private_folder(folder, self.state))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Look at the files when the user comes back to the window."""
        if event.type() == QEvent.Type.WindowActivate:
            self.look_outside()
        return super().eventFilter(watched, event)

    def look_outside(self) -> None:
        """Tell the user if somebody else has changed the project's files."""
        folder, stamps = self.held.folder, self.held.stamps
        if folder is None or stamps is None or self._looking or self.saving.runs:
            return
        self._looking = True
        self.background.do(
            lambda: changes(stamps, stamps_of(folder, stamps)),
            partial(self._looked, stamps),
            lambda _: self._looked(stamps, ()),
        )

    def _looked(self, stamps: Stamps, found: tuple[str, ...]) -> None:
        self._looking = False
        if found == self._told or stamps is not self.held.stamps:
            return
        self._told = found
        if found:
            text = f"somebody else changed this project's files ({', '.join(found[:3])}{', …' if found[3:] else ''})"
            answers = (("Reload", self.ask_reload),)
            self.studio.said.emit(
                Message(text, Kind.WARNING, answers, holds=lambda: stamps is self.held.stamps)
            )

    def ask_reload(self) -> None:
        """Open the project again as its folder holds it, after asking if that costs something."""
        if self.studio.document.is_saved:
            self.reload()
            return
        self.ask(
            "Go back to what the folder holds?",
            "The unsaved changes in this window are gone then.",
            (Answer("Reload", self.reload), Answer("Save elsewhere…", self.save_as), Answer("Cancel")),
            look="file-refresh-outline",
            standard=2,
        )

    # --------------------------------------------------------------------------------------------- helping

    def _refused(self, error: UnderstudyError) -> None:
        self.waiting.emit("")
        self.ask(
            "That was not possible",
            "Nothing has been changed.",
            (Answer("Close"),),
            str(error),
            "alert-circle-outline",
        )

    def _quietly(self, act: Callable[[], object]) -> None:
        """Do what is only a help to recovery; where it cannot be done, work goes on without."""
        try:
            act()
        except OSError as error:
            self.studio.warn(f"after a crash this project may not be found again: {error}")
