"""The world is painted apart from the window: when it has changed, and not when something else has."""

from __future__ import annotations

import pytest
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from app.editor.canvas.frame import Frame
from app.editor.canvas.ink import Ink
from app.editor.canvas.painting import paint
from app.editor.canvas.picture import Picture
from app.engine.commands import Step

from .pilot import Pilot

GROUND = QColor("#445566")


class Shown(QWidget):
    """Shows a picture of one color."""

    def __init__(self) -> None:
        super().__init__()
        self.painted: list[str] = []
        self.color = "#102030"
        self.picture = Picture(self, self._paint)

    def _paint(self, painter: QPainter) -> None:
        self.painted.append(self.color)
        painter.fillRect(self.rect(), QColor(self.color))

    def paintEvent(self, _event: object) -> None:  # noqa: N802 - Qt's name
        self.picture.show(GROUND)


@pytest.fixture
def shown(qtbot: QtBot) -> Shown:
    widget = Shown()
    qtbot.addWidget(widget)
    widget.resize(60, 40)
    return widget


def color_at(widget: Shown, x: int, y: int) -> str:
    return widget.grab().toImage().pixelColor(x, y).name()


def test_what_was_painted_is_shown_until_it_is_painted_anew(shown: Shown) -> None:
    assert color_at(shown, 59, 39) == "#102030"
    shown.color = "#a0b0c0"
    assert color_at(shown, 0, 0) == "#102030"
    shown.picture.paint_anew()
    assert color_at(shown, 0, 0) == "#a0b0c0"
    assert shown.painted == ["#102030", "#a0b0c0"]


def test_where_there_is_more_room_than_before_there_is_ground_until_it_is_painted_anew(shown: Shown) -> None:
    shown.grab()
    shown.resize(90, 70)
    assert (color_at(shown, 59, 39), color_at(shown, 89, 69)) == ("#102030", GROUND.name())
    shown.picture.paint_anew()
    assert color_at(shown, 89, 69) == "#102030"


def test_what_was_forgotten_is_painted_anew(shown: Shown) -> None:
    shown.grab()
    shown.color = "#a0b0c0"
    shown.picture.forget()
    assert color_at(shown, 0, 0) == "#a0b0c0"


def watched_painting(monkeypatch: pytest.MonkeyPatch) -> list[Frame]:
    """The frames of the world that are painted from now on."""
    painted: list[Frame] = []

    def noted(painter: QPainter, frame: Frame, ink: Ink, controllers: list[QColor]) -> None:
        painted.append(frame)
        paint(painter, frame, ink, controllers)

    monkeypatch.setattr("app.editor.canvas.view.paint", noted)
    return painted


def test_a_step_of_the_world_is_seen(pilot: Pilot) -> None:
    before = pilot.picture()
    pilot.send(Step(60))
    assert pilot.picture() != before


def test_a_window_that_nobody_sees_paints_no_world_and_shows_it_as_it_is_once_it_is_back(
    pilot: Pilot, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = pilot.picture()
    painted = watched_painting(monkeypatch)
    pilot.window.showMinimized()
    pilot.wait(pilot.window.isMinimized)
    painted.clear()
    pilot.send(Step(60))
    assert painted == []
    pilot.window.showNormal()
    pilot.wait(lambda: painted)
    assert pilot.picture() != before


def test_what_lies_on_the_world_does_not_have_it_painted_anew(
    pilot: Pilot, monkeypatch: pytest.MonkeyPatch
) -> None:
    pilot.picture()
    painted = watched_painting(monkeypatch)
    pilot.canvas.on_top.legend.update()
    pilot.canvas.on_top.badge.update()
    pilot.canvas.update()
    pilot.window.repaint()
    assert painted == []
