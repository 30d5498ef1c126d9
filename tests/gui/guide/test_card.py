"""The card of the lesson: it hides nobody who is selected, and closes at a button."""

from functools import partial

from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from app.editor.window.main_window import MainWindow
from tests.gui.canvas.pilot import Pilot
from tests.gui.conftest import PATIENCE
from tests.gui.guide.newcomer import press_next


def test_the_lesson_is_closed_by_a_button_once_it_is_over(lesson: MainWindow, qtbot: QtBot) -> None:
    guide = lesson.guide
    while guide.title.text() != "Watch them, and correct them":
        qtbot.mouseClick(guide.skip, Qt.MouseButton.LeftButton)
    press_next(lesson, qtbot)
    assert guide.title.text() == "That is all it takes"
    assert guide.skip.text() == "Close"
    qtbot.mouseClick(guide.skip, Qt.MouseButton.LeftButton)
    assert not guide.isVisible()


def test_the_card_goes_where_it_hides_nobody_who_is_selected(lesson: MainWindow, qtbot: QtBot) -> None:
    canvas, guide = lesson.canvas, lesson.guide
    lesson.resize(1280, 800)
    for _ in range(3):
        qtbot.waitUntil(lambda: bool(hidden_by_the_card(lesson)), timeout=PATIENCE)
        hidden = hidden_by_the_card(lesson)[0]
        lesson.studio.selection.select_nodes([hidden])
        qtbot.waitUntil(partial(is_free_of_the_card, lesson, hidden), timeout=PATIENCE)
        qtbot.waitUntil(lambda: canvas.rect().contains(guide.geometry()), timeout=PATIENCE)


def test_what_the_canvas_tells_of_who_is_under_the_mouse_lies_above_the_card(
    lesson: MainWindow, qtbot: QtBot
) -> None:
    canvas, guide, pilot = lesson.canvas, lesson.guide, Pilot(lesson, qtbot)
    lesson.resize(1280, 800)

    def is_told_across_the_card() -> bool:
        """Whoever is just beside the card by now is pointed at."""
        beside = guide.geometry().adjusted(-60, 0, 0, 0)
        spots = [place_of(lesson, node) for node in agents_of(lesson)]
        spot = next((p for p in spots if beside.contains(p) and not guide.geometry().contains(p)), None)
        if spot is not None:
            pilot.hover(spot)
        return canvas.card.isVisible() and canvas.card.geometry().intersects(guide.geometry())

    qtbot.waitUntil(is_told_across_the_card, timeout=PATIENCE)
    over = canvas.parentWidget()
    assert over is not None
    layers = over.children()
    assert layers.index(canvas.card) > layers.index(guide)


def agents_of(window: MainWindow) -> tuple[str, ...]:
    scene = window.canvas.scene
    return () if scene is None else scene.place.agents


def place_of(window: MainWindow, node: str) -> QPoint:
    """Where a node is on the canvas."""
    scene = window.canvas.scene
    assert scene is not None
    entity = scene.entity(node)
    x, y = window.canvas.looking.camera.to_view(float(scene.x[entity]), float(scene.y[entity]))
    return QPoint(round(x), round(y))


def hidden_by_the_card(window: MainWindow) -> list[str]:
    return [node for node in agents_of(window) if window.guide.geometry().contains(place_of(window, node))]


def is_free_of_the_card(window: MainWindow, node: str) -> bool:
    return not window.guide.geometry().contains(place_of(window, node))
