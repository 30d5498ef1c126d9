"""Works the graph as a person does: by mouse and keys, and by nothing else."""

import json
from collections.abc import Callable

from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication, QComboBox, QDoubleSpinBox, QMenu, QWidget
from pytestqt.qtbot import QtBot

from app.core.automaton import Automaton
from app.editor.graph.condition_row import ConditionRow
from app.editor.graph.offers import BEHAVIOR_MIME
from app.editor.graph.panel import GraphPanel
from app.editor.graph.rule_form import RuleBlock
from app.editor.graph.state_item import Path
from app.editor.selection import BehaviorKey
from tests.gui.conftest import PATIENCE, said

LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
COPY = Qt.DropAction.CopyAction
NO_KEY, CTRL = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ControlModifier
MIDDLE = QPointF(0, 0)


class Author:
    """A hand on the graph panel."""

    def __init__(self, panel: GraphPanel, qtbot: QtBot) -> None:
        self.panel, self.qtbot = panel, qtbot

    # ---------------------------------------------------------------------------------------------- looking

    def settle(self) -> None:
        """Wait until what is shown is arranged by Graphviz and up to date."""
        panel = self.panel
        self.qtbot.waitUntil(
            lambda: panel.laying_out.is_idle and not panel.is_pending and panel.scene.is_settled,
            timeout=PATIENCE,
        )

    def show(self, key: BehaviorKey) -> None:
        """Look at another automaton, as a click in the library does."""
        self.panel.studio.selection.select_behavior(key)
        self.settle()

    def named(self, name: str) -> Path:
        """The state that is called so."""
        return next(path for path, item in self.panel.scene.states.items() if item.state.name == name)

    def at(self, path: Path, offset: QPointF = MIDDLE) -> QPoint:
        """Where a state is on the screen."""
        return self.panel.view.mapFromScene(self.panel.scene.states[path].mapToScene(offset))

    def edge_at(self, level: Path, source: str, target: str) -> QPoint:
        """Where an edge's label is on the screen."""
        item = self.panel.scene.edges[level, source, target]
        return self.panel.view.mapFromScene(item.mapToScene(QPointF(*item.run.label)))

    # ---------------------------------------------------------------------------------------------- the hand

    def click(self, path: Path, offset: QPointF = MIDDLE, keys: Qt.KeyboardModifier = NO_KEY) -> None:
        self.qtbot.mouseClick(self.panel.view.viewport(), LEFT, keys, self.at(path, offset))

    def click_edge(self, source: str, target: str) -> None:
        self.qtbot.mouseClick(self.panel.view.viewport(), LEFT, pos=self.edge_at((), source, target))

    def trigger(self, action: str) -> None:
        """Choose an action, once it is possible."""
        found = self.panel.studio.actions[action]
        self.qtbot.waitUntil(found.isEnabled, timeout=PATIENCE)
        found.trigger()
        self.settle()

    def key(self, key: Qt.Key, keys: Qt.KeyboardModifier = NO_KEY) -> None:
        self.qtbot.keyClick(self.panel.view, key, keys)
        self.settle()

    def drag(self, start: QPoint, end: QPoint) -> None:
        surface = self.panel.view.viewport()
        self.qtbot.mouseMove(surface, start)
        self.qtbot.mousePress(surface, LEFT, pos=start)
        self.qtbot.mouseMove(surface, (start + end) / 2)
        self.qtbot.mouseMove(surface, end)
        self.qtbot.mouseRelease(surface, LEFT, pos=end)
        self.settle()

    def drop(self, content: dict[str, str], place: QPoint) -> None:
        """Let go of a behavior that was dragged from the library."""
        data = QMimeData()
        data.setData(BEHAVIOR_MIME, json.dumps(content).encode())
        surface = self.panel.view.viewport()
        QApplication.sendEvent(surface, QDragEnterEvent(place, COPY, data, LEFT, NO_KEY))
        QApplication.sendEvent(surface, QDropEvent(QPointF(place), COPY, data, LEFT, NO_KEY))
        self.settle()

    def link(self, source: str, target: str) -> None:
        """Drag from the handle of a state to a state."""
        path = self.named(source)
        self.qtbot.mouseMove(self.panel.view.viewport(), self.at(path))
        self.drag(self.at(path, self.panel.scene.states[path].handle_at()), self.at(self.named(target)))

    # --------------------------------------------------------------------------------------- menus and forms

    def come_back(self) -> None:
        """Once a menu is closed, the window has the keys again, as a window manager sees to."""
        self.panel.activateWindow()
        self.qtbot.waitUntil(self.panel.isActiveWindow, timeout=PATIENCE)

    def pick(self, menu: QMenu, text: str) -> None:
        """Click an entry of a menu."""
        action = next(action for action in menu.actions() if said(action) == text)
        self.qtbot.mouseClick(menu, LEFT, pos=menu.actionGeometry(action).center())
        self.settle()

    def choose(self, box: QComboBox, text: str) -> None:
        """Open a list and choose, by keys."""
        box.setFocus()
        self.qtbot.keyClick(box, Qt.Key.Key_Down)
        view = box.view()
        self.qtbot.keyClick(view, Qt.Key.Key_Home)
        for _ in range(box.count()):
            if view.currentIndex().data() == text:
                break
            self.qtbot.keyClick(view, Qt.Key.Key_Down)
        assert view.currentIndex().data() == text
        self.qtbot.keyClick(view, Qt.Key.Key_Return)
        self.settle()

    def type_number(self, field: QDoubleSpinBox, text: str) -> None:
        field.setFocus()
        field.selectAll()
        self.qtbot.keyClicks(field, text)
        self.qtbot.keyClick(field, Qt.Key.Key_Return)
        self.settle()

    def press(self, button: QWidget) -> None:
        self.qtbot.mouseClick(button, LEFT)
        self.settle()

    @property
    def block(self) -> RuleBlock:
        """The last rule of the form."""
        return self.panel.form.rules.blocks[-1]

    def row(self, number: int) -> ConditionRow:
        """A test of the last rule of the form."""
        return self.block.rows[number]

    def add_state(self, text: str) -> None:
        """By the menu that a key opens."""
        self.trigger("graph.add_state")
        menu = self.panel.menu
        assert menu is not None
        self.pick(menu, text)

    def test(self, what: str, *said: Callable[[ConditionRow], None]) -> None:
        """Add a test to the last rule of the form, then say more of it."""
        number = len(self.block.rows)
        self.press(self.block.add)
        if self.row(number).what.currentText() != what:
            self.choose(self.row(number).what, what)
        for act in said:
            act(self.row(number))
            self.settle()


def automaton(author: Author) -> Automaton:
    root = author.panel.root
    assert root is not None
    found = author.panel.studio.document.automaton(root.type, root.id)
    assert found is not None
    return found
