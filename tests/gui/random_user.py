"""A user without a plan: does hundreds of things that the window lets him do, the same ones for the same seed."""

from __future__ import annotations

from collections.abc import Callable
from random import Random

from PySide6.QtCore import QAbstractItemModel, QItemSelectionModel, QModelIndex, QPoint, Qt
from PySide6.QtWidgets import QAbstractItemView, QApplication, QWidget
from pytestqt.qtbot import QtBot

from app.core.edits import relabel_examples, weight_examples
from app.editor.examples.model import Column
from app.editor.examples.panel import ExamplesPanel
from app.editor.graph.panel import GraphPanel
from app.editor.message import Kind
from app.editor.soon import catch_up
from app.editor.window.main_window import MainWindow
from tests.gui.canvas.pilot import Pilot
from tests.gui.teach.hand import CONTROL, SHIFT, Hand

LEFT = Qt.MouseButton.LeftButton
NONE = Qt.KeyboardModifier.NoModifier
EDITING = QAbstractItemView.State.EditingState
#: These end the session, write files or leave the window.
ELSEWHERE = ("file.", "experiment.", "edit.undo", "edit.redo", "help.")
KEYS = (Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Home, Qt.Key.Key_End)
#: More often than once in a while: what a lesson is made of, and what takes it back.
OFTEN = 3


class RandomUser(Hand):
    """Acts by chance.

    Attributes:
        did: What it has done, in words, for whoever has to find out what went wrong.
        errors: Messages of the window that tell of something that nobody foresaw.
    """

    def __init__(self, window: MainWindow, qtbot: QtBot, seed: int) -> None:
        super().__init__(window, qtbot)
        self.chance = Random(seed)
        self.pilot = Pilot(window, qtbot)
        self.did: list[str] = []
        self.errors: list[str] = []
        self.studio.said.connect(self._hear)
        self._acts: list[Callable[[], str]] = [
            *OFTEN * [self.pick_something, self.action, self.undo_or_redo],
            self.shortcut,
            self.click_canvas,
            self.drag_entity,
            self.click_library,
            self.click_agents,
            self.rename_node,
            self.example_ticked,
            self.example_relabeled,
            self.example_weighted,
            self.example_chosen,
            self.walk_in_graph,
            self.remove_in_graph,
            self.switch_arm,
            self.teach_something,
            self.test_it,
        ]

    def _hear(self, message: object) -> None:
        text, kind = getattr(message, "text", ""), getattr(message, "kind", None)
        if kind is Kind.ERROR or "could not be kept" in text or "Error: " in text:
            self.errors.append(text)

    def act_once(self) -> None:
        """Do something, and wait until the window shows what came of it."""
        self.did.append(self.chance.choice(self._acts)())
        self._close_what_opened()
        self.settle()

    def _close_what_opened(self) -> None:
        """Menus, lists and editors that an act has opened go away again."""
        for _ in range(4):
            opened = QApplication.activePopupWidget() or QApplication.activeModalWidget()
            if opened is None:
                break
            self.qtbot.keyClick(opened, Qt.Key.Key_Escape)
        for view in self.window.findChildren(QAbstractItemView):
            if view.state() is EDITING:
                self.wait(lambda: self._has_left(view))  # noqa: B023 - called at once
        if QApplication.activeWindow() is None:  # what closed was: a window manager gives the keys back
            self.window.activateWindow()
            self.wait(self.window.isActiveWindow)
        self.window.setFocus()

    def _has_left(self, view: QAbstractItemView) -> bool:
        """Press Escape until no name is being typed any more."""
        if view.state() is EDITING:
            self.window.activateWindow()  # as a window manager does
            # Another row may have become the current one meanwhile: the editor is what stands among the rows.
            among = [w for w in view.viewport().children() if isinstance(w, QWidget) and w.isVisibleTo(view)]
            editor = among[0] if among else QApplication.focusWidget() or view
            editor.setFocus()
            self.qtbot.keyClick(editor, Qt.Key.Key_Escape)
        return view.state() is not EDITING

    # -------------------------------------------------------------------------------------------- anything

    def action(self) -> str:
        """Trigger any action that is possible and asks for nothing."""
        possible = [
            row.id
            for row in self.studio.actions.rows.values()
            if self.studio.actions[row.id].isEnabled()
            and not row.text.endswith("…")
            and not row.id.startswith(ELSEWHERE)
        ]
        chosen = self.chance.choice(possible)
        self.studio.actions[chosen].trigger()
        return chosen

    def shortcut(self) -> str:
        """Press a key of time or of a lesson."""
        keys = (Qt.Key.Key_Space, Qt.Key.Key_Period, Qt.Key.Key_Comma, Qt.Key.Key_Plus, Qt.Key.Key_Minus)
        key = self.chance.choice((*keys, Qt.Key.Key_1, Qt.Key.Key_2, Qt.Key.Key_3, Qt.Key.Key_Tab))
        self.key(key, CONTROL if key == Qt.Key.Key_Tab else Qt.KeyboardModifier.NoModifier)
        return f"key {key.name}"

    def undo_or_redo(self) -> str:
        """Go some steps back, and perhaps some forward again."""
        back, forward = self.chance.randint(1, 3), self.chance.choice((0, 0, 1, 2))
        for _ in range(back):
            self.key(Qt.Key.Key_Z, CONTROL)
        if forward:
            self.wait(lambda: not self.studio._undo_ticket)
        for _ in range(forward):
            self.key(Qt.Key.Key_Z, CONTROL | SHIFT)
        return f"undo {back}, redo {forward}"

    # ----------------------------------------------------------------------------------------------- lessons

    def teach_something(self) -> str:
        """Take the selected nodes into training mode for what is shown."""
        self.key(Qt.Key.Key_T)
        return "teach"

    def test_it(self) -> str:
        """Test what was taught; learning may still go on when the next thing is done."""
        self.key(Qt.Key.Key_T, SHIFT)
        return "test"

    def pick_something(self) -> str:
        """Press one of the buttons of the lesson."""
        if self.studio.teaching.lesson is None:
            return self.teach_something()
        every = (*self.page.buttons.values(), *self.page.new.values())
        buttons = [button for button in every if button.isVisible() and button.isEnabled()]
        if not buttons:
            return "no button"
        button = self.chance.choice(buttons)
        self.click(button)
        return f"pick {button.text()}"

    def switch_arm(self) -> str:
        """Choose another arm in the tool bar."""
        box = self.window.toolbar.arm
        at = self.chance.randrange(box.count())
        box.setCurrentIndex(at)
        box.activated.emit(at)
        return f"arm {box.itemText(at)}"

    # ------------------------------------------------------------------------------------------------ the world

    def click_canvas(self) -> str:
        """Click an agent, perhaps besides those that are selected, or nothing."""
        width, height = self.pilot.canvas.width(), self.pilot.canvas.height()
        at = QPoint(self.chance.randrange(width), self.chance.randrange(height))
        frame = self.pilot.canvas.frame()
        if frame is not None and frame.scene.agents and self.chance.random() < 0.8:
            at = self.pilot.at(self.chance.randrange(frame.scene.agents))
        modifier = SHIFT if self.chance.random() < 0.3 else NONE
        self.qtbot.mouseClick(self.pilot.canvas, LEFT, modifier, at)
        return f"click canvas at {at.toTuple()}"

    def drag_entity(self) -> str:
        """Drag an entity somewhere else while time stands still."""
        frame = self.pilot.canvas.frame()
        if frame is None or self.snapshot.speed != 0.0:
            return "nothing to drag"
        entity = self.chance.randrange(len(frame.scene.x))
        begin = self.pilot.at(entity)
        end = begin + QPoint(self.chance.randint(-60, 60), self.chance.randint(-60, 60))
        canvas = self.pilot.canvas
        self.qtbot.mousePress(canvas, LEFT, NONE, begin)
        for step in (begin + (end - begin) / 2, end):
            self.qtbot.mouseMove(canvas, step)
        self.qtbot.mouseRelease(canvas, LEFT, NONE, end)
        return f"drag {entity}"

    # ------------------------------------------------------------------------------------------------ the panels

    def click_library(self) -> str:
        """Show another behavior."""
        return f"library {self._click(self._view('library'))}"

    def click_agents(self) -> str:
        """Select another node."""
        modifier = CONTROL if self.chance.random() < 0.3 else NONE
        return f"agents {self._click(self._view('agents'), modifier)}"

    def rename_node(self) -> str:
        """Type another name for the current node."""
        if not self.studio.actions["node.rename"].isEnabled():
            return "no node to rename"
        self.studio.actions["node.rename"].trigger()
        editor = QApplication.focusWidget()
        if editor is not None and hasattr(editor, "selectAll"):
            editor.selectAll()
            self.qtbot.keyClicks(editor, f"node{self.chance.randrange(9)}")
            self.qtbot.keyClick(editor, Qt.Key.Key_Return)
            self.wait(lambda: self._view("agents").state() is not EDITING)
        return "rename node"

    def _view(self, panel: str) -> QAbstractItemView:
        view = self.window.docks[panel].widget().tree  # type: ignore[attr-defined]  # both panels have one
        assert isinstance(view, QAbstractItemView)
        return view

    def _click(self, view: QAbstractItemView, modifier: Qt.KeyboardModifier = NONE) -> str:
        catch_up()  # nobody sees what is about to go, and an index of it is worth nothing: Qt may crash on one
        rows = [index for index in _below(view.model()) if view.visualRect(index).isValid()]
        if not rows or not view.isVisible():
            return "nothing there"
        index = self.chance.choice(rows)
        words = str(index.data())
        view.scrollTo(index)
        self.qtbot.mouseClick(view.viewport(), LEFT, modifier, view.visualRect(index).center())
        return words

    # ------------------------------------------------------------------------------------------------ examples

    @property
    def _examples(self) -> ExamplesPanel:
        panel = self.window.docks["examples"].widget()
        assert isinstance(panel, ExamplesPanel)
        return panel

    def _row(self) -> int:
        """A row of the table; -1 if there is none."""
        rows = self._examples.model.rowCount()
        return self.chance.randrange(rows) if rows else -1

    def example_ticked(self) -> str:
        """Tick an example, or take its tick away, by the space bar."""
        row, table = self._row(), self._examples.table
        if row < 0:
            return "no example"
        table.setCurrentIndex(self._examples.model.index(row, Column.ID))
        self.qtbot.keyClick(table, Qt.Key.Key_Space)
        return f"tick row {row}"

    def example_relabeled(self) -> str:
        """Let an example go to another state."""
        row, subject = self._row(), self._examples.model.subject
        if row < 0 or subject is None:
            return "no example"
        example = self._examples.model.example(row)
        label = self.chance.choice([state.id for state in subject.automaton.states])
        self.studio.document.attempt(
            relabel_examples, subject.type, subject.automaton.id, [example.id], label
        )
        return f"relabel {example.id} to {label}"

    def example_weighted(self) -> str:
        """Let an example count otherwise."""
        row, subject = self._row(), self._examples.model.subject
        if row < 0 or subject is None:
            return "no example"
        example, weight = self._examples.model.example(row), self.chance.choice((0.5, 2.0, 3.0))
        self.studio.document.attempt(
            weight_examples, subject.type, subject.automaton.id, [example.id], weight
        )
        return f"weigh {example.id} by {weight}"

    def example_chosen(self) -> str:
        """Select an example, which shows its moment."""
        row, table = self._row(), self._examples.table
        if row < 0:
            return "no example"
        rows = QItemSelectionModel.SelectionFlag.Rows
        flags = QItemSelectionModel.SelectionFlag.ClearAndSelect | rows
        table.selectionModel().select(self._examples.model.index(row, 0), flags)
        return f"choose row {row}"

    # ------------------------------------------------------------------------------------------------- the graph

    def walk_in_graph(self) -> str:
        """Go to another state by keys."""
        key = self.chance.choice(KEYS)
        self.qtbot.keyClick(self._graph.view, key)
        return f"graph {key.name}"

    def remove_in_graph(self) -> str:
        """Remove the state or transition that is selected in the graph."""
        if not self.studio.actions["graph.remove"].isEnabled():
            return "nothing to remove"
        self.qtbot.keyClick(self._graph.view, Qt.Key.Key_Delete)
        return "remove in the graph"

    @property
    def _graph(self) -> GraphPanel:
        panel = self.window.docks["graph"].widget()
        assert isinstance(panel, GraphPanel)
        return panel


def _below(model: QAbstractItemModel, parent: QModelIndex | None = None) -> list[QModelIndex]:
    """The first rows of a tree, as many as one sees at a glance."""
    parent = parent or QModelIndex()
    found: list[QModelIndex] = []
    for row in range(min(model.rowCount(parent), 12)):
        index = model.index(row, 0, parent)
        found += [index, *_below(model, index)]
    return found
