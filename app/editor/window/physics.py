"""What moves things in a world, in words: what is taught in one need not hold in the other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...core.amounts import number
from ...sim.physics import KINEMATIC, RIGID
from ..actions import ActionRow, When, when_there
from ..message import Message

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ...core.project import Value
    from ...sim.bodies import Bodies
    from ..studio import Studio


def physics_words(physics: str, bodies: Bodies | None, parameters: Mapping[str, Value]) -> str:
    """What bumps into what, and what that means for behaviors.

    Args:
        bodies: The scenario's; None if it has none.
        parameters: The world's.
    """
    if physics != RIGID or bodies is None:
        return "Kinematic physics: nothing bumps into anything"
    if not parameters[bodies.contact]:
        return (
            f"Rigid physics: each {bodies.loads} is a body and needs force to move; agents do not bump into each other "
            f"({bodies.contact} is off)"
        )
    wide = float(parameters[bodies.agent_diameter])
    return (
        f"Rigid physics: agents are bodies, {number(wide)} wide, so two of them come no nearer than {number(wide)} to each "
        "other. What was taught without contact may wait forever to get nearer: teach it again here, or change "
        f"{bodies.agent_diameter} or {bodies.contact}"
    )


def physics_rows() -> tuple[ActionRow, ...]:
    """What moves things."""
    return (
        ActionRow(
            "run.rigid",
            "Rigid physics",
            "Run",
            _turn,
            "physics",
            tip="Begin the arm again in a world of bodies: contact, walls, boxes pulled by forces; or without",
            icon="cube-outline",
            enabled=When(
                lambda studio: when_there(studio) and studio.document.scenario.bodies is not None,
                lambda studio: (
                    f"the scenario {studio.document.scenario.name} says nothing of bodies"
                    if when_there(studio)
                    else when_there.why_not(studio)
                ),
            ),
            checked=lambda studio: studio.physics == RIGID,
        ),
    )


def _turn(studio: Studio) -> None:
    """Take the other physics, and say what is different where things bump into each other."""
    snapshot = studio.snapshot
    if studio.physics == RIGID or snapshot is None:
        studio.use_physics(KINEMATIC)
        return
    studio.use_physics(RIGID)
    words = physics_words(RIGID, studio.document.scenario.bodies, snapshot.place.parameters)
    answers = (("Parameters", studio.actions["arm.settings"].trigger),)
    studio.said.emit(Message(words, answers=answers, holds=lambda: studio.physics == RIGID))
