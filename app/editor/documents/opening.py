"""Opening a project: looking at its folder in the background, asking what has to be asked, and only then showing it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from ...core.amounts import counted
from ...core.errors import UnderstudyError
from ...core.project import Project
from ...core.storage import FilesError, file_is_there, load
from ...engine.scenarios import OWN_CODE, brings_code, open_scenario
from ...sim.scenario import Scenario
from ..message import Kind, Message
from . import autosaves, claims, words
from .asking import Answer
from .autosaves import Autosave
from .claims import Owner
from .held import Held
from .outside import Stamps, stamps_of
from .private import private_folder, unnamed_folder, writable
from .words import clock, whose

if TYPE_CHECKING:
    from .background import Job
    from .files import Files

#: The scenario, and what was autosaved, if that is wanted, or why it cannot be read.
Ready = tuple[Scenario, Project | UnderstudyError | None]


@dataclass(frozen=True, slots=True)
class Wish:
    """What is to be opened, and what the user has answered so far.

    Attributes:
        trust: Whether code that the project carries may run.
        shared: Whether it may be opened although another window has it.
    """

    folder: Path
    arm: str = ""
    trust: bool = False
    shared: bool = False
    read_only: bool = False
    recover: bool = False


@dataclass(frozen=True, slots=True)
class Found:
    """What was found in a folder.

    Attributes:
        project: None where it cannot be read; *error* says why.
        other: Who has it open already.
        unclaimed: Why it could not be claimed, in words; empty if it is, or others have it.
        kept: What a window that is gone had saved by itself.
        code: The text of the scenario that the project brings; empty if it brings none.
        writable: Whether anything can be saved there.
    """

    project: Project | None
    error: UnderstudyError | None
    private: Path
    stamps: Stamps
    other: Owner | None
    claimed: bool
    unclaimed: str
    kept: Autosave | None
    code: str
    writable: bool


def look(folder: Path, state: Path, owner: Owner) -> Found:
    """Read the project in *folder* and claim it; nothing that it holds is run."""
    folder = folder.resolve()
    private = private_folder(folder, state)
    stamps = stamps_of(folder)
    project, error = None, None
    try:
        project = load(folder)
    except UnderstudyError as found:
        error = found
    other, claimed, unclaimed = None, False, ""
    if file_is_there(folder / "project.json"):
        try:
            other = claims.claim(private, owner)
            claimed = other is None
        except OSError as why:  # it opens without a lock as well as with one
            unclaimed = words.unclaimed(private, why)
    kept = autosaves.find(private)
    if kept is not None and (not kept.is_left_over or kept.owner.token == owner.token):
        kept = None
    code, may_write = _code(project, folder), writable(folder)
    return Found(project, error, private, stamps, other, claimed, unclaimed, kept, code, may_write)


def _code(project: Project | None, folder: Path) -> str:
    if project is None or not brings_code(project):
        return ""
    try:
        return (folder / OWN_CODE).read_text(encoding="utf-8", errors="replace") or " "
    except OSError as error:
        return f"# cannot be read: {error.strerror}"


def _recovered(kept: Autosave | None) -> Project | UnderstudyError | None:
    """What was autosaved, or why that cannot be read."""
    try:
        return None if kept is None else kept.project()
    except UnderstudyError as error:
        return error


class Opening:
    """Opens projects, one at a time."""

    def __init__(self, files: Files) -> None:
        self._files = files
        self._job: Job | None = None

    def open(self, wish: Wish) -> None:
        """Open a project in the place of the one that is open, which has been dealt with."""
        self.cancel()
        files = self._files
        files.waiting.emit(f"Opening {wish.folder.name}…")
        self._job = files.background.do(
            partial(look, wish.folder, files.state, files.owner),
            partial(self._found, wish),
            partial(self._failed, wish),
        )

    def cancel(self) -> None:
        """Stay with what is open."""
        if self._job is not None:
            self._job.drop()
            self._job = None
            self._files.waiting.emit("")

    # ---------------------------------------------------------------------------------------------- questions

    def _found(self, wish: Wish, found: Found) -> None:
        """Ask the next thing that has to be asked; if nothing has, go on."""
        if found.project is None:
            self._unreadable(wish, found)
        elif found.other is not None and not wish.shared:
            self._ask_shared(wish, found, found.other)
        elif found.code and not wish.trust:
            self._ask_trust(wish, found)
        elif found.kept is not None and not wish.recover:
            self._ask_recover(wish, found, found.kept)
        else:
            self._go_on(wish, found)

    def _unreadable(self, wish: Wish, found: Found) -> None:
        self._give_up(found)
        problems = found.error.problems if isinstance(found.error, FilesError) else ()
        answers = [Answer("Close"), self._again(wish)]
        if found.kept is not None:
            kept = found.kept
            answers.insert(0, Answer("Open the autosave", lambda: self._files.recover(kept)))
        listed = "\n".join(str(problem) for problem in problems) or str(found.error)
        count = f"{counted(len(problems), 'problem')} in {wish.folder}" if problems else str(wish.folder)
        told = f"{count}. Nothing has been changed."
        if found.kept is not None:
            told += f" What was autosaved at {clock(found.kept.at)} can be opened instead."
        self._files.ask("This project cannot be opened", told, answers, listed, "alert-circle-outline")

    def _ask_shared(self, wish: Wish, found: Found, other: Owner) -> None:
        goes_on = partial(replace, wish, shared=True)
        self._files.ask(
            "Another window has this project open",
            f"{wish.folder} is open {whose(other)}. If both save, each finds what the other changed and asks which "
            "of the two is to stay.",
            (
                Answer(
                    "Open read-only",
                    lambda: self._found(goes_on(read_only=True), found),
                    "Look and try things out; what is to be kept goes into another folder",
                ),
                Answer("Open anyway", lambda: self._found(goes_on(), found), "Both windows can save"),
                Answer("Cancel", lambda: self._give_up(found)),
            ),
        )

    def _ask_trust(self, wish: Wish, found: Found) -> None:
        self._files.ask(
            "This project carries code",
            f"Opening it runs {wish.folder / OWN_CODE}, which can do whatever you can do on this machine. Read it, and "
            "open the project only if you trust whoever wrote it.",
            (
                Answer(
                    "Trust once", lambda: self._found(replace(wish, trust=True), found), "Run it this time"
                ),
                Answer("Don't open", lambda: self._give_up(found)),
            ),
            found.code,
            "shield-alert-outline",
            standard=1,
        )

    def _ask_recover(self, wish: Wish, found: Found, kept: Autosave) -> None:
        def discard() -> None:
            autosaves.discard(kept.private)
            self._found(wish, replace(found, kept=None))

        self._files.ask(
            "Understudy ended without saving this project",
            f"What was autosaved at {clock(kept.at)} can be recovered. It becomes a step that can be undone, which gives "
            "back the project as it was saved.",
            (
                Answer("Recover", lambda: self._found(replace(wish, recover=True), found)),
                Answer("Discard it", discard, "Open the project as it was saved, and throw the rest away"),
                Answer("Cancel", lambda: self._give_up(found)),
            ),
            look="backup-restore",
        )

    def _ask_without(self, wish: Wish, found: Found, error: UnderstudyError) -> None:
        """What was autosaved is damaged, which says nothing of the project."""
        as_saved = replace(wish, recover=False), replace(found, kept=None)
        self._files.waiting.emit("")
        self._files.ask(
            "What was autosaved cannot be read",
            f"The project in {wish.folder} can be opened as it was saved. What was autosaved stays in {found.private} "
            "until something else is saved or autosaved.",
            (
                Answer("Open as it was saved", lambda: self._found(*as_saved)),
                self._again(wish),
                Answer("Cancel", lambda: self._give_up(found)),
            ),
            str(error),
            "alert-circle-outline",
        )

    # ---------------------------------------------------------------------------------------------- going on

    def _go_on(self, wish: Wish, found: Found) -> None:
        project, files = found.project, self._files
        assert project is not None

        def ready() -> Ready:
            scenario = open_scenario(project, wish.folder.resolve(), trust=wish.trust)
            return scenario, _recovered(found.kept) if wish.recover else None

        files.waiting.emit(f"Opening {wish.folder.name}…")
        self._job = files.background.do(
            ready, partial(self._ready, wish, found), partial(self._unsound, wish, found)
        )

    def _ready(self, wish: Wish, found: Found, result: Ready) -> None:
        self._job = None
        scenario, recovered = result
        assert found.project is not None
        if isinstance(recovered, UnderstudyError):
            self._ask_without(wish, found, recovered)
            return
        folder, files = wish.folder.resolve(), self._files
        private = found.private if found.claimed else unnamed_folder(files.state, files.owner.token)
        held = Held(
            folder, private, found.project, found.stamps, claimed=found.claimed, read_only=wish.read_only
        )
        files.show(held, found.project, scenario, recovered=recovered, arm=wish.arm)
        files.waiting.emit("")
        if not found.writable:
            text = f"{folder} cannot be written to: what is to be kept goes into another folder"
            self._warn(text, folder, ("Save elsewhere…", files.save_as))
        if found.unclaimed:
            self._warn(found.unclaimed, folder, ("Reload…", files.ask_reload))

    def _warn(self, text: str, folder: Path, answer: tuple[str, Callable[[], object]]) -> None:
        """Tell of what is wrong with the folder of the open project, as long as it is kept there."""
        files = self._files
        files.studio.said.emit(
            Message(text, Kind.WARNING, (answer,), holds=lambda: files.held.folder == folder)
        )

    def _unsound(self, wish: Wish, found: Found, error: UnderstudyError) -> None:
        self._give_up(found)
        self._failed(wish, error)

    def _failed(self, wish: Wish, error: UnderstudyError) -> None:
        self._job = None
        self._files.waiting.emit("")
        self._files.ask(
            "This project cannot be opened",
            f"{wish.folder}. Nothing has been changed.",
            (Answer("Close"), self._again(wish)),
            str(error),
            "alert-circle-outline",
        )

    def _again(self, wish: Wish) -> Answer:
        return Answer(
            "Try again", lambda: self.open(wish), "Once the files are mended, e.g. with a text editor"
        )

    def _give_up(self, found: Found) -> None:
        """Stay with what is open; a project that is not opened is not claimed."""
        self._job = None
        if found.claimed and found.private != self._files.held.private:
            claims.release(found.private, self._files.owner)
        self._files.waiting.emit("")
