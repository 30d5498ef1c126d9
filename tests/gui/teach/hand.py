"""A user's hand in the window: keys and clicks, each followed by a look until the window shows what came of it."""

from collections.abc import Callable

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from app.core.automaton import Automaton
from app.core.examples import Example
from app.editor.selection import BehaviorKey
from app.editor.teach.button import BehaviorButton
from app.editor.teach.lesson_page import LessonPage
from app.editor.teach.panel import TeachPanel
from app.editor.teach.target_row import TargetRow
from app.editor.window.main_window import MainWindow
from app.engine.snapshots import LessonView, Mode, Snapshot
from tests.gui.conftest import PATIENCE

SHIFT, CONTROL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier
LEFT = Qt.MouseButton.LeftButton
#: Milliseconds between two looks whether a menu is open.
POLL = 5


class Hand:
    """Teaches in a window as a user does."""

    def __init__(self, window: MainWindow, qtbot: QtBot) -> None:
        self.window = window
        self.qtbot = qtbot
        self.studio = window.studio
        self.said: list[str] = []
        self.studio.said.connect(lambda message: self.said.append(message.text))

    # ------------------------------------------------------------------------------------------ eyes

    @property
    def panel(self) -> TeachPanel:
        """The teach panel."""
        panel = self.window.docks["teach"].widget()
        assert isinstance(panel, TeachPanel)
        return panel

    @property
    def page(self) -> LessonPage:
        """The part of it with the buttons."""
        return self.panel.lesson

    @property
    def snapshot(self) -> Snapshot:
        """What the window shows."""
        assert self.studio.snapshot is not None
        return self.studio.snapshot

    @property
    def lesson(self) -> LessonView:
        """The lesson that is going on."""
        assert self.studio.teaching.lesson is not None
        return self.studio.teaching.lesson

    @property
    def automaton(self) -> Automaton:
        """What is taught, or would be."""
        assert self.studio.teaching.automaton is not None
        return self.studio.teaching.automaton

    @property
    def examples(self) -> tuple[Example, ...]:
        """What it has learned from."""
        key = self.studio.teaching.key
        assert key is not None
        return self.studio.document.project.examples_of(key.type, key.id)

    @property
    def acts(self) -> int:
        """How many picks the session can take back."""
        lesson = self.studio.teaching.lesson
        return 0 if lesson is None else lesson.acts

    def sees(self, feature: str, node: str = "") -> float:
        """The value of a feature of what is taught, as the next decision will see it."""
        node = node or self.studio.teaching.node
        self.wait(lambda: node in self.snapshot.watched)
        levels = {level.automaton: level for level in self.snapshot.watched[node].levels}
        return levels[self.automaton.id].values[feature]

    def wait(self, ready: Callable[[], object]) -> None:
        """Look until it is so."""
        self.qtbot.waitUntil(lambda: bool(ready()), timeout=PATIENCE)

    # ------------------------------------------------------------------------------------------ hands

    def key(self, key: Qt.Key, modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
        """Press a key."""
        self.qtbot.keyClick(self.window, key, modifiers)

    def act(self, command: Callable[[], object]) -> None:
        """Do something that makes the session obey a command, and wait for its answer."""
        before = self.answered
        command()
        self.wait(lambda: self.answered > before)
        self.settle()

    @property
    def answered(self) -> int:
        """How many commands the session has dealt with, as far as the window knows."""
        return self.snapshot.acknowledged

    @property
    def is_answered(self) -> bool:
        """Whether the session has dealt with all commands, as far as the window knows."""
        engine = self.studio.bridge._engine
        assert engine is not None
        return self.answered >= engine._tickets

    def settle(self) -> None:
        """Wait until the session has answered all that was asked, and the actions say what is possible."""
        # Both at once: while the one is waited for, background learning may ask for the other again.
        self.wait(lambda: self.is_answered and not self.studio._soon.is_due)

    def click(self, widget: QWidget) -> None:
        """Click a widget that can be seen."""
        assert widget.isVisible(), f"{widget} cannot be seen"
        self.qtbot.mouseClick(widget, LEFT)

    def show(self, behavior: str, *nodes: str, type_name: str = "agent") -> None:
        """Choose a behavior and nodes, as the library and the canvas do."""
        found = self.studio.document.project.library(type_name).by_name(behavior)
        assert found is not None
        self.studio.selection.select_behavior(BehaviorKey(type_name, found.id))
        self.studio.selection.select_nodes(nodes)
        self.settle()

    def teach(self, behavior: str, *nodes: str, type_name: str = "agent") -> None:
        """Choose, and press T."""
        self.show(behavior, *nodes, type_name=type_name)
        self.key(Qt.Key.Key_T)
        self.wait(lambda: self.studio.mode is Mode.TEACHING)
        self.settle()

    @property
    def all_buttons(self) -> list[BehaviorButton]:
        """Those of states, and of what is none yet."""
        return [*self.page.buttons.values(), *self.page.new.values()]

    def pick(self, name: str) -> None:
        """Click the button that says *name*; where there is no room for it, find it in the list."""
        buttons = {button.text().rstrip("…"): button for button in self.all_buttons}
        assert name in buttons, f"{name} is not among {list(buttons)}"
        button = buttons[name]
        if button.isVisible():
            self.act(lambda: self.click(button))
            return
        self.click(self.page.add)
        self.qtbot.keyClicks(self.page.list.search, name)
        self.act(lambda: self.qtbot.keyClick(self.page.list.search, Qt.Key.Key_Return))

    def choose_target(self, row: TargetRow, slot: str, target: str) -> None:
        """Click the button of a slot, and in the menu that opens what says *target*."""

        def is_there() -> bool:
            return row.menus[slot].isVisible()  # looked up anew: the row may have been laid out again

        def choose() -> None:
            menu = button.menu()
            if not menu.isVisible():
                QTimer.singleShot(POLL, choose)
                return
            action = next(action for action in menu.actions() if action.objectName() == target)
            self.qtbot.mouseClick(menu, LEFT, pos=menu.actionGeometry(action).center())

        self.wait(is_there)
        button = row.menus[slot]
        QTimer.singleShot(POLL, choose)  # an open menu waits inside the click that opened it
        self.click(button)
        self.window.activateWindow()  # without a screen, nobody gives the keys back once a menu has closed
        self.wait(self.window.isActiveWindow)

    def hold(self, ticks: int) -> None:
        """Hold the key that passes single ticks until so many have passed."""
        goal = self.snapshot.tick + ticks
        for _ in range(ticks):
            self.key(Qt.Key.Key_Period)
        self.wait(lambda: self.snapshot.tick == goal)

    def test(self) -> None:
        """Press Shift+T."""
        self.key(Qt.Key.Key_T, SHIFT)
        self.wait(lambda: self.studio.mode is Mode.TESTING)
        self.settle()

    def undo(self) -> None:
        """Press Ctrl+Z, and wait until it is done."""
        self.wait(self.studio.actions["edit.undo"].isEnabled)
        self.key(Qt.Key.Key_Z, CONTROL)
        self.wait(lambda: not self.studio._undo_ticket)
        self.settle()
