"""What the first lesson is made of: each step says what to do, where, and how it is told that it was done."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ...engine.snapshots import Mode, Picked
from .pupil import choose_pupil
from .scratch import FORAGE, TYPE, WANDER

if TYPE_CHECKING:
    from ...engine.watching import WatchedLevel
    from ..studio import Studio


@dataclass(frozen=True, slots=True)
class Seen:
    """What the user has done since a step began.

    Attributes:
        picked: The state that was picked last; empty if none was.
        ticks: Ticks that have passed.
    """

    studio: Studio
    picked: str
    ticks: int

    def level(self, automaton: str) -> WatchedLevel | None:
        """What the agent that is taught is about to decide in an automaton; None if it does not run it."""
        snapshot = self.studio.snapshot
        watched = None if snapshot is None else snapshot.watched.get(self.studio.teaching.node)
        levels = () if watched is None else watched.levels
        return next((level for level in levels if level.automaton == automaton), None)


def _never(_seen: Seen) -> int | None:
    return None


def _when_it_is_said(_seen: Seen) -> bool:
    return False


def _nothing(_studio: Studio) -> None:
    return None


@dataclass(frozen=True, slots=True)
class Step:
    """One thing to do.

    Attributes:
        points_at: Where: ``action:ID`` a button of the tool bar, ``pick:NAME`` a behavior in the teach panel, ``panel:ID``,
            or ``canvas``.
        done: Whether it was done.
        stops: After how many ticks time is to stand still, so that the right moment cannot be missed; None while that
            is not known.
        prepares: Sees to what has to be so before it can be done.
        is_watched: There is only something to see, and the user says when it was seen.
    """

    title: str
    text: str
    points_at: str
    done: Callable[[Seen], bool]
    stops: Callable[[Seen], int | None] = _never
    prepares: Callable[[Studio], object] = _nothing
    is_watched: bool = False


def _teaches(automaton: str) -> Callable[[Seen], bool]:
    def done(seen: Seen) -> bool:
        snapshot = seen.studio.snapshot
        lesson = None if snapshot is None else snapshot.lesson
        return lesson is not None and lesson.plan.automaton == automaton and not lesson.testing

    return done


def _picked(state: str) -> Callable[[Seen], bool]:
    return lambda seen: seen.picked == state


def _passed_or_picked(ticks: int, state: str) -> Callable[[Seen], bool]:
    """Who goes ahead of the lesson has done what was to come before."""
    return lambda seen: seen.ticks >= ticks or seen.picked == state


def _tests(seen: Seen) -> bool:
    return seen.studio.mode is Mode.TESTING


def _shows(automaton: str) -> Callable[[Seen], bool]:
    def done(seen: Seen) -> bool:
        behavior = seen.studio.selection.behavior
        return behavior is not None and behavior.id == automaton

    return done


def _as_long_as_before(seen: Seen) -> int | None:
    """Until it has walked exactly as long as before it turned left."""
    level = seen.level(WANDER)
    if level is None or level.state != "forward":
        return None
    examples = seen.studio.document.project.examples_of(TYPE, WANDER)
    walks = [e.values["ticks"] for e in examples if (e.source, e.label) == ("forward", "rotate-left")]
    return max(0, round(walks[-1] - level.values["ticks"])) if walks else None


def _when(feature: str) -> Callable[[Seen], int | None]:
    """Once a feature of Forage is true."""

    def stops(seen: Seen) -> int | None:
        level = seen.level(FORAGE)
        return 0 if level is not None and level.values.get(feature) else None

    return stops


def picked_state(event: object) -> str:
    """The state that an event of the session says was picked; empty if it says nothing of the sort."""
    return event.recorded.goal if isinstance(event, Picked) else ""


WANDERING: tuple[Step, ...] = (
    Step(
        "Teach an agent to wander",
        "Wander is an empty behavior: nobody knows yet how it goes. Press Teach (T) to take one agent in hand.",
        "action:teach.teach",
        _teaches(WANDER),
    ),
    Step(
        "Send it ahead",
        "The agent does exactly what you pick. Pick Forward: click its button, or press the key on it.",
        "pick:Forward",
        _picked("forward"),
    ),
    Step(
        "Let it walk",
        "Press Space and let time pass for a while. Each pick is an example; keeping to it is one, too.",
        "action:run.play",
        _passed_or_picked(90, "rotate-left"),
    ),
    Step("Turn it left", "Now pick RotateLeft, while it walks.", "pick:RotateLeft", _picked("rotate-left")),
    Step(
        "And ahead again",
        "Let it turn a little, then pick Forward.",
        "pick:Forward",
        _picked("forward"),
    ),
    Step(
        "Turn it right",
        "Let it walk (+ is faster). Time stops by itself when it has walked as long as before: then pick RotateRight, "
        "since at that moment either turn is fine.",
        "pick:RotateRight",
        _picked("rotate-right"),
        _as_long_as_before,
    ),
    Step(
        "Ahead once more",
        "Let it turn a little (Space goes on), and pick Forward.",
        "pick:Forward",
        _picked("forward"),
    ),
    Step(
        "Test it",
        "That was the lesson. Press Test (Shift+T): Understudy learns from your examples, and all fifty agents wander.",
        "action:teach.test",
        _tests,
    ),
    Step(
        "Watch them",
        "Let time pass (Space): they walk and turn as you showed. If the library says “2 in conflict”, you turned both "
        "ways at the same moment, and they choose left or right by chance.",
        "canvas",
        _when_it_is_said,
        is_watched=True,
    ),
)
FORAGING: tuple[Step, ...] = (
    Step(
        "Now foraging",
        "Forage is made of behaviors: Wander, which you taught, and ReturnWithBox, which is there already. "
        "Choose Forage in the library.",
        "panel:library",
        _shows(FORAGE),
    ),
    Step(
        "Take an agent in hand",
        "Press Teach (T). The agent that is selected sees no box yet.",
        "action:teach.teach",
        _teaches(FORAGE),
        prepares=choose_pupil,
    ),
    Step(
        "Let it search",
        "Pick Wander.",
        "pick:Wander",
        _picked("wander"),
    ),
    Step(
        "When it finds a box",
        "Time stops by itself once the agent sees a box, which is then within the circle around it: pick ReturnWithBox, "
        "and it fetches the box and pulls it home. Until then let time pass (Space goes on and stops; + is faster), or "
        "drag the agent to a box while time stands still.",
        "pick:ReturnWithBox",
        _picked("return-with-box"),
        _when("sees"),
    ),
    Step(
        "And off again",
        "Press Space. Time stops again when the box has arrived at the cross and the agent is done: then pick Wander.",
        "pick:Wander",
        _picked("wander"),
        _when("done"),
    ),
    Step(
        "Test it",
        "Press Test (Shift+T): all fifty forage now, by what you showed one of them.",
        "action:teach.test",
        _tests,
    ),
    Step(
        "Watch them, and correct them",
        "Let them work (Space). If one goes wrong, click it and pick what it should do: that is another example, and all "
        "of them know better at once.",
        "canvas",
        _when_it_is_said,
        is_watched=True,
    ),
)
STEPS = (*WANDERING, *FORAGING)
#: Where the second half begins, which needs what the first has taught.
SECOND = len(WANDERING)
