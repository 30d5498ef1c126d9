"""The actions that concern the window as a whole: time, undo, looks."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtGui import QGuiApplication

from ...engine.commands import GoTo, Pause, Play, Reset, Step
from ...engine.snapshots import Mode
from ..actions import ActionRow, When, needs, when_there
from ..theme import ThemeMode

if TYPE_CHECKING:
    from ...engine.place import Place
    from ..studio import Studio

#: What the speed slider stands for, from left to right; None is as fast as it can.
SPEEDS: tuple[float | None, ...] = (0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, None)
#: The greatest seed that files can hold.
MOST_SEED = 2**63 - 1


def is_playing(studio: Studio) -> bool:
    """Whether time passes."""
    snapshot = studio.snapshot
    return snapshot is not None and snapshot.speed != 0.0


def speed_words(speed: float | None) -> str:
    """A speed as the user reads it: "16x", "max"."""
    return "max" if speed is None else f"{speed:g}×"


class Speed:
    """The speed that playing has: chosen before or while time passes; how one watches, whatever project is open."""

    def __init__(self) -> None:
        self.chosen: float | None = 1.0
        # Of which world, by which ticket, and whether to play.
        self._asked: tuple[Place | None, int, bool] = None, 0, False

    def choose(self, studio: Studio, speed: float | None) -> None:
        """Go on at another speed; a world that stands still stays so."""
        self.chosen = speed
        if is_playing(studio):
            studio.bridge.send(Play(speed))
        studio.touch()

    def shift(self, studio: Studio, steps: int) -> None:
        """Take the next faster or slower speed."""
        place = SPEEDS.index(self.chosen) + steps
        if 0 <= place < len(SPEEDS):
            self.choose(studio, SPEEDS[place])
        else:
            studio.say(f"this is as {'fast' if steps > 0 else 'slow'} as it can be")

    def play_or_pause(self, studio: Studio) -> None:
        """Let time pass, or stop it; what was asked for already counts, though no answer to it has come yet."""
        plays = self._will_play(studio)
        ticket = studio.bridge.send(Pause() if plays else Play(self.chosen))
        self._asked = None if studio.snapshot is None else studio.snapshot.place, ticket, not plays

    def _will_play(self, studio: Studio) -> bool:
        """Whether time passes once all that was asked for here is done."""
        snapshot, (place, ticket, plays) = studio.snapshot, self._asked
        if snapshot is not None and snapshot.place is place and snapshot.acknowledged < ticket:
            return plays
        return is_playing(studio)


def _why_no_way_back(studio: Studio) -> str:
    snapshot = studio.snapshot
    if snapshot is None:
        return when_there.why_not(studio)
    if snapshot.mode is not Mode.RUNNING:
        return "end the lesson first"
    return "this is as early as it is known" if snapshot.tick else "this is the beginning"


@needs(_why_no_way_back)
def can_go_back(studio: Studio) -> bool:
    """Whether there is an earlier tick, and nobody is taught."""
    snapshot = studio.snapshot
    return snapshot is not None and snapshot.mode is Mode.RUNNING and snapshot.tick > snapshot.earliest


def go_back(studio: Studio, ticks: int | None = None) -> None:
    """Show the world some ticks earlier, or as it began; where that cannot be, as early as it can, which is told."""
    snapshot = studio.snapshot
    if snapshot is None:
        return
    wanted = 0 if ticks is None else snapshot.tick - ticks
    studio.bridge.send(Pause())
    studio.bridge.send(GoTo(max(snapshot.earliest, wanted)))
    if ticks is None and snapshot.earliest > 0:
        studio.say(
            f"this run can be gone back in to tick {snapshot.earliest:,}: what came before ran with other behaviors, or "
            "someone was taught",
            (("Reset", studio.actions["run.reset"].trigger),),
        )


def time_rows(speed: Speed) -> tuple[ActionRow, ...]:
    """Playing, pausing, stepping."""
    return (
        ActionRow(
            "run.play",
            "Play",
            "Run",
            speed.play_or_pause,
            keys="Space",
            tip="Let time pass, or stop it",
            icon="play",
            enabled=when_there,
            says=lambda studio: "Pause" if is_playing(studio) else "Play",
        ),
        ActionRow(
            "run.step",
            "Step",
            "Run",
            lambda studio: studio.bridge.send(Step()),
            keys=".",
            tip="Pass a single tick",
            icon="step-forward",
            enabled=when_there,
        ),
        ActionRow(
            "run.back",
            "Step back",
            "Run",
            lambda studio: go_back(studio, 1),
            keys=",",
            tip="Go back a single tick; not while somebody is taught",
            icon="step-backward",
            enabled=can_go_back,
        ),
        ActionRow(
            "run.begin",
            "Go to the beginning",
            "Run",
            go_back,
            keys="Home",
            tip="Show the world as it began, or as early as it is known; not while somebody is taught",
            icon="skip-backward",
            enabled=can_go_back,
        ),
        ActionRow(
            "run.faster",
            "Faster",
            "Run",
            lambda studio: speed.shift(studio, 1),
            "speed",
            "+",
            "Double the speed",
            "fast-forward",
            when_there,
        ),
        ActionRow(
            "run.slower",
            "Slower",
            "Run",
            lambda studio: speed.shift(studio, -1),
            "speed",
            "-",
            "Halve the speed",
            "rewind",
            when_there,
        ),
        ActionRow(
            "run.reset",
            "Reset",
            "Run",
            lambda studio: studio.bridge.send(Reset()),
            "reset",
            "Ctrl+R",
            "Begin the world again with the same seed; a lesson or test goes on in it",
            "restart",
            when_there,
        ),
        ActionRow(
            "run.next_seed",
            "Reset with the next seed",
            "Run",
            next_seed,
            "reset",
            "Ctrl+Shift+R",
            "Begin another world",
            "dice-5-outline",
            when_there,
        ),
    )


def next_seed(studio: Studio) -> None:
    """Begin another world; after the greatest seed comes the first."""
    if studio.snapshot is not None:
        seed = studio.snapshot.seed
        studio.bridge.send(Reset(0 if seed == MOST_SEED else seed + 1))


def undo_words(studio: Studio) -> str:
    """What undo would undo."""
    text = studio.document.history.undo_text
    return f"Undo: {text}" if text else "Undo"


def redo_words(studio: Studio) -> str:
    """What redo would redo."""
    text = studio.document.history.redo_text
    return f"Redo: {text}" if text else "Redo"


def edit_rows() -> tuple[ActionRow, ...]:
    """Undo and redo."""
    return (
        ActionRow(
            "edit.undo",
            "Undo",
            "Edit",
            lambda studio: studio.undo(),
            keys="Ctrl+Z",
            tip="Take back the last step, picks included",
            icon="undo",
            enabled=When(lambda studio: studio.document.history.can_undo, "nothing has been done yet"),
            says=undo_words,
        ),
        ActionRow(
            "edit.redo",
            "Redo",
            "Edit",
            lambda studio: studio.redo(),
            keys="Ctrl+Shift+Z",
            tip="Do again what was undone last",
            icon="redo",
            enabled=When(lambda studio: studio.can_redo, "nothing was undone last"),
            says=redo_words,
        ),
    )


def _theme_row(mode: ThemeMode, text: str, tip: str) -> ActionRow:
    def use(studio: Studio) -> None:
        studio.settings.theme = mode

    return ActionRow(
        f"view.{mode}",
        text,
        "View",
        use,
        "theme",
        tip=tip,
        checked=lambda studio: studio.settings.theme is mode,
    )


def view_rows() -> tuple[ActionRow, ...]:
    """Looks."""
    return (
        _theme_row(ThemeMode.LIGHT, "Light theme", "Light colors"),
        _theme_row(ThemeMode.DARK, "Dark theme", "Dark colors"),
        _theme_row(ThemeMode.SYSTEM, "Theme as the system", "Colors as the system has them"),
        ActionRow(
            "view.copy_tick",
            "Copy tick and seed",
            "View",
            copy_place,
            "copy",
            tip="Put scenario, arm, seed and tick of what is shown into the clipboard",
            icon="content-copy",
            enabled=when_there,
        ),
    )


def copy_place(studio: Studio) -> None:
    """Put what is shown into the clipboard, in words."""
    snapshot = studio.snapshot
    if snapshot is not None:
        place = f"scenario {snapshot.place.scenario}, arm {snapshot.arm}"
        text = f"{place}, seed {snapshot.seed}, tick {snapshot.tick}"
        QGuiApplication.clipboard().setText(text)
        studio.say(f"copied: {text}")


def teach_rows() -> tuple[ActionRow, ...]:
    """Teaching and testing."""
    return (
        ActionRow(
            "teach.teach",
            "Teach",
            "Teach",
            lambda studio: studio.teaching.teach(),
            keys="T",
            tip="Teach the behavior that is shown to the nodes that are selected",
            icon="school-outline",
            enabled=when_there,
            checked=lambda studio: studio.mode is Mode.TEACHING,
        ),
        ActionRow(
            "teach.test",
            "Test",
            "Teach",
            lambda studio: studio.teaching.test(),
            keys="Shift+T",
            tip="Learn what was taught, and let all nodes of the type run it",
            icon="play-outline",
            enabled=when_there,
            checked=lambda studio: studio.mode in (Mode.TESTING, Mode.LEARNING),
        ),
        ActionRow(
            "teach.stop",
            "End the lesson",
            "Teach",
            lambda studio: studio.teaching.stop(),
            keys="Esc",
            tip="Let the arm run what it runs; what was taught stays",
            icon="close",
            enabled=When(
                lambda studio: studio.teaching.is_teaching or studio.teaching.choosing.is_busy,
                "nobody is taught",
            ),
        ),
    )
