"""The card of the lesson: it hides nobody who is selected, and closes at a button."""

from functools import partial

from PySide6.QtCore import QPoint, QRect, Qt
from pytestqt.qtbot import QtBot

from app.editor.window.main_window import MainWindow
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
    qtbot.waitUntil(lambda: canvas.scene is not None, timeout=PATIENCE)
    for _ in range(3):
        before = guide.geometry()
        hidden = agent_within(lesson, before)
        lesson.studio.selection.select_nodes([hidden])
        qtbot.waitUntil(partial(lambda before: guide.geometry() != before, before), timeout=PATIENCE)
        assert not guide.geometry().contains(place_of(lesson, hidden))
        assert canvas.rect().contains(guide.geometry())


def test_what_the_canvas_tells_of_who_is_under_the_mouse_lies_above_the_card(
    lesson: MainWindow, qtbot: QtBot
) -> None:
    canvas, guide = lesson.canvas, lesson.guide
    lesson.resize(1280, 800)
    qtbot.waitUntil(lambda: canvas.scene is not None, timeout=PATIENCE)
    beside = guide.geometry().adjusted(-60, 0, 0, 0)
    spots = [place_of(lesson, node) for node in agents_of(lesson)]
    spot = next(p for p in spots if beside.contains(p) and not guide.geometry().contains(p))
    qtbot.mouseMove(canvas, spot)
    qtbot.waitUntil(canvas.card.isVisible, timeout=PATIENCE)
    shared = canvas.card.geometry().intersected(guide.geometry())
    assert not shared.isEmpty()
    over = canvas.parentWidget()
    assert over is not None
    layers = over.children()
    assert layers.index(canvas.card) > layers.index(guide)


def agents_of(window: MainWindow) -> tuple[str, ...]:
    assert window.canvas.scene is not None
    return window.canvas.scene.place.agents


def place_of(window: MainWindow, node: str) -> QPoint:
    """Where a node is on the canvas."""
    scene = window.canvas.scene
    assert scene is not None
    entity = scene.entity(node)
    x, y = window.canvas.looking.camera.to_view(float(scene.x[entity]), float(scene.y[entity]))
    return QPoint(round(x), round(y))


def agent_within(window: MainWindow, card: QRect) -> str:
    """Somebody whom the card hides."""
    return next(node for node in agents_of(window) if card.contains(place_of(window, node)))
