"""Of several that are taught by turns, the world shows whose turn it is, without a color."""

from dataclasses import replace
from math import cos, pi, sin

import pytest
from PySide6.QtCore import QPoint
from PySide6.QtGui import QColor, QImage, QPainter

from app.editor.canvas.frame import Frame
from app.editor.canvas.ink import Ink
from app.editor.canvas.pupils import paint_pupils
from app.editor.theme import ThemeMode
from app.engine.commands import Teach
from tests.gui.canvas.pilot import Pilot

RADIUS = 14.0


def painted(frame: Frame, *, crowded: bool = False) -> QImage:
    """The rings of a frame alone, in greys."""
    camera = frame.camera
    image = QImage(round(camera.width), round(camera.height), QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(QColor(frame.palette.canvas))
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    paint_pupils(painter, frame, Ink(), RADIUS, crowded=crowded)
    painter.end()
    return image.convertToFormat(QImage.Format.Format_Grayscale8)


def share(image: QImage, frame: Frame, node: str, more: float = 0.0) -> float:
    """How much of the lower half of a circle around an agent is drawn; its number stands in the upper one."""
    x, y = (places[frame.scene.entity(node)] for places in frame.places())
    ground = QColor(frame.palette.canvas).lightness()
    angles = [pi * (k + 0.5) / 60 for k in range(60)]
    spots = [QPoint(int(x + (RADIUS + more) * cos(a)), int(y + (RADIUS + more) * sin(a))) for a in angles]
    seen = [image.pixelColor(spot).lightness() for spot in spots if image.rect().contains(spot)]
    return sum(abs(grey - ground) > 30 for grey in seen) / len(seen)


@pytest.mark.parametrize("mode", [ThemeMode.LIGHT, ThemeMode.DARK])
def test_the_ring_is_thick_and_whole_whose_turn_it_is_and_dashed_around_the_others(
    pilot: Pilot, mode: ThemeMode
) -> None:
    pilot.studio.settings.theme = mode
    agents = pilot.snapshot.place.agents
    its, other = agents[pilot.alone()], agents[(pilot.alone() + 1) % len(agents)]
    frame = replace(pilot.frame, taught=frozenset({its, other}), pupils=(its, other), turn=its)
    image = painted(frame)
    assert share(image, frame, its) == 1.0
    assert share(image, frame, its, more=1.0) == 1.0
    assert 0.3 < share(image, frame, other) < 0.9
    turned = replace(frame, turn=other)
    assert share(painted(turned), turned, its) < 0.9


def test_who_is_taught_alone_has_a_plain_ring_and_no_number(pilot: Pilot) -> None:
    its = pilot.snapshot.place.agents[pilot.alone()]
    frame = replace(pilot.frame, taught=frozenset({its}), pupils=(its,), turn=its)
    image = painted(frame)
    x, y = (places[frame.scene.entity(its)] for places in frame.places())
    assert share(image, frame, its) == 1.0
    assert image.pixelColor(int(x - RADIUS), int(y - RADIUS)).lightness() == pytest.approx(
        QColor(frame.palette.canvas).lightness(), abs=2
    )


def test_of_too_many_for_wide_rings_the_one_has_it_whose_turn_it_is(pilot: Pilot) -> None:
    agents = pilot.snapshot.place.agents
    its = agents[pilot.alone()]
    frame = replace(pilot.frame, taught=frozenset(agents), pupils=agents, turn=its)
    image = painted(frame, crowded=True)
    assert share(image, frame, its) == 1.0
    others = [node for node in agents if node != its]
    assert max(share(image, frame, node) for node in others) < 1.0


def test_the_world_shows_another_turn_at_once(pilot: Pilot) -> None:
    pilot.send(Teach("agent", "forage", ("agent-17", "agent-3")))
    pilot.wait(lambda: pilot.frame.taught == {"agent-17", "agent-3"})
    assert (pilot.frame.pupils, pilot.frame.turn) == (("agent-17", "agent-3"), "agent-17")
    before = pilot.picture()
    pilot.choose("teach.next")
    pilot.wait(lambda: pilot.frame.turn == "agent-3")
    assert pilot.picture() != before


def test_a_click_on_one_of_them_makes_it_its_turn(pilot: Pilot) -> None:
    alone = pilot.snapshot.place.agents[pilot.alone()]
    first = next(node for node in pilot.snapshot.place.agents if node != alone)
    pilot.send(Teach("agent", "forage", (first, alone)))
    pilot.wait(lambda: pilot.frame.turn == first)
    pilot.click(pilot.at(pilot.entity(alone)))
    pilot.wait(lambda: pilot.frame.turn == alone)
