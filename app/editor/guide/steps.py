"""What the first lesson is made of: each step says what to do, where, and how it is told that it was done."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ...engine.snapshots import Mode, Picked
from .scratch import FORAGE, WANDER

if TYPE_CHECKING:
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


@dataclass(frozen=True, slots=True)
class Step:
    """One thing to do.

    Attributes:
        points_at: Where: ``action:ID`` a button of the tool bar, ``pick:NAME`` a behavior in the teach panel, ``panel:ID``,
            or ``canvas``.
        done: Whether it was done.
    """

    title: str
    text: str
    points_at: str
    done: Callable[[Seen], bool]


def _teaches(automaton: str) -> Callable[[Seen], bool]:
    def done(seen: Seen) -> bool:
        snapshot = seen.studio.snapshot
        lesson = None if snapshot is None else snapshot.lesson
        return lesson is not None and lesson.plan.automaton == automaton and not lesson.testing

    return done


def _picked(state: str) -> Callable[[Seen], bool]:
    return lambda seen: seen.picked == state


def _passed(ticks: int) -> Callable[[Seen], bool]:
    return lambda seen: seen.ticks >= ticks


def _tests(seen: Seen) -> bool:
    return seen.studio.mode is Mode.TESTING


def _shows(automaton: str) -> Callable[[Seen], bool]:
    def done(seen: Seen) -> bool:
        behavior = seen.studio.selection.behavior
        return behavior is not None and behavior.id == automaton

    return done


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
        _passed(90),
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
        "Let it walk about as long as before, then pick RotateRight.",
        "pick:RotateRight",
        _picked("rotate-right"),
    ),
    Step("Ahead once more", "A little later, pick Forward.", "pick:Forward", _picked("forward")),
    Step(
        "Test it",
        "That was the lesson. Press Test (Shift+T): Understudy learns from your examples, and all agents wander.",
        "action:teach.test",
        _tests,
    ),
    Step(
        "Watch them",
        "They walk and turn as you showed, and choose left or right by chance. If time stands still, press Space.",
        "canvas",
        _passed(200),
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
    Step("Take an agent in hand", "Press Teach (T).", "action:teach.teach", _teaches(FORAGE)),
    Step(
        "Let it search",
        "Pick Wander, and let time pass (Space). You may make it faster with the slider or +.",
        "pick:Wander",
        _picked("wander"),
    ),
    Step(
        "It has found a box",
        "Wait until a box is within the circle around the agent, what it can see. Then pick ReturnWithBox: it fetches "
        "the box and pulls it home.",
        "pick:ReturnWithBox",
        _picked("return-with-box"),
    ),
    Step(
        "And off again",
        "When the box has arrived at the cross and the agent is free, pick Wander.",
        "pick:Wander",
        _picked("wander"),
    ),
    Step(
        "Test it",
        "Press Test (Shift+T): all agents forage now, by what you showed one of them.",
        "action:teach.test",
        _tests,
    ),
    Step(
        "Watch them, and correct them",
        "If one goes wrong, select it and pick what it should do: that is another example. Let them work for a while.",
        "canvas",
        _passed(600),
    ),
)
STEPS = (*WANDERING, *FORAGING)
#: Where the second half begins, which needs what the first has taught.
SECOND = len(WANDERING)
