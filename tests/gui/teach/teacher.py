"""A person who makes behaviors in the dialog, chooses agents on the canvas, and teaches by clicks and keys."""

from collections.abc import Sequence

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QAbstractItemView, QApplication, QComboBox, QDialogButtonBox, QWidget

from app.editor.forms.choosing import Chooser
from app.editor.library.new_automaton import NewAutomatonDialog
from app.engine.snapshots import Mode
from tests.gui.teach.hand import CONTROL, LEFT, SHIFT, Hand

NO_MODIFIER = Qt.KeyboardModifier.NoModifier


class Teacher(Hand):
    """Does all of it as a user does."""

    # --------------------------------------------------------------------------------------- behaviors

    def make(
        self,
        name: str,
        *features: str | tuple[str, str],
        parameters: int = 0,
        type_name: str = "",
        sum_up: Sequence[str] = (),
    ) -> None:
        """Make a behavior in the dialog of the library.

        Args:
            features: As the dialog calls them, those with a slot together with what it is bound to.
            parameters: How many.
            type_name: Whose behavior it is, if not of the type that is shown.
            sum_up: How each feature is summed up, where it is a statistic.
        """
        self.key(Qt.Key.Key_N, CONTROL | SHIFT)
        (dialog,) = (d for d in self.window.findChildren(NewAutomatonDialog) if d.isVisible())
        dialog.activateWindow()  # as a window manager does
        self.wait(dialog.isActiveWindow)
        if type_name:
            self._step_to(dialog.general.types, type_name)
        dialog.general.name.setFocus()
        dialog.general.name.selectAll()
        self.qtbot.keyClicks(dialog.general.name, name)
        self.qtbot.keyClick(dialog.general.name, Qt.Key.Key_Tab)
        for _ in range(parameters):
            self.click(dialog.general.add)
        dialog.tabs.setCurrentWidget(dialog.features)
        for at, feature in enumerate(features):
            what, bound = (feature, "") if isinstance(feature, str) else feature
            self._type(dialog.features.new.what, what)
            if bound:
                (box,) = dialog.features.new.slots.boxes.values()
                self._step_to(box, bound)
            if sum_up:
                self._step_to(dialog.features.new.operation, sum_up[at])
            self.click(dialog.features.add)
        button = dialog.buttons.button(QDialogButtonBox.StandardButton.Ok)
        self.qtbot.mouseClick(button, LEFT)
        self.wait(lambda: not dialog.isVisible())
        self.window.activateWindow()  # as a window manager does when a dialog closes
        self.settle()

    def _type(self, chooser: Chooser, text: str) -> None:
        chooser.field.setFocus()
        chooser.field.selectAll()
        self.qtbot.keyClicks(chooser.field, text)
        completions = QApplication.activePopupWidget()
        assert completions is not None
        for key in (Qt.Key.Key_Down, Qt.Key.Key_Return):
            self.qtbot.keyClick(completions, key)

    def _step_to(self, box: QComboBox, text: str) -> None:
        box.setFocus()
        goal = box.findText(text)
        assert goal >= 0, f"{text!r} is not in the list"
        while box.currentIndex() != goal:
            self._step(box, box.currentIndex(), goal)
            if box.view().isVisible():  # one that opens instead of stepping
                self._choose_in(box.view(), goal)

    def _choose_in(self, opened: QAbstractItemView, goal: int) -> None:
        while opened.currentIndex().row() != goal:
            self._step(opened, opened.currentIndex().row(), goal)
        self.qtbot.keyClick(opened, Qt.Key.Key_Return)

    def _step(self, widget: QWidget, row: int, goal: int) -> None:
        self.qtbot.keyClick(widget, Qt.Key.Key_Down if row < goal else Qt.Key.Key_Up)

    # ------------------------------------------------------------------------------------------- the world

    def world(self, seed: int, arm: str = "") -> None:
        """Begin the world anew with *seed*, in another arm if one is named."""
        box, field = self.window.toolbar.arm, self.window.toolbar.seed
        if arm and self.snapshot.arm != arm:
            with self.qtbot.waitSignal(self.studio.bridge.place_changed):
                self._step_to(box, f"Arm: {arm}")
            self.wait(lambda: self.snapshot.arm == arm)
        field.setFocus()
        field.selectAll()
        self.qtbot.keyClicks(field, str(seed))
        self.act(lambda: self.qtbot.keyClick(field, Qt.Key.Key_Return))
        self.wait(lambda: (self.snapshot.tick, self.snapshot.seed) == (0, seed))

    def point_of(self, entity: int) -> QPoint:
        """Where something is on the canvas."""
        columns = self.snapshot.columns
        x, y = float(columns["x"][entity]), float(columns["y"][entity])
        across, down = self.window.canvas.looking.camera.to_view(x, y)
        return QPoint(round(float(across)), round(float(down)))

    def click_entity(self, entity: int, modifiers: Qt.KeyboardModifier = NO_MODIFIER) -> None:
        """Click something in the world."""
        self.qtbot.mouseClick(self.window.canvas, LEFT, modifiers, self.point_of(entity))

    def entity(self, node: str) -> int:
        """The number of an agent."""
        return self.snapshot.place.agents.index(node)

    def choose_agents(self, *nodes: str) -> None:
        """Click agents on the canvas, the second and further ones with Ctrl."""
        for at, node in enumerate(nodes):
            self.click_entity(self.entity(node), CONTROL if at else NO_MODIFIER)
        self.settle()
        assert set(self.studio.selection.nodes) == set(nodes)

    # -------------------------------------------------------------------------------------------- the lesson

    def begin(self) -> None:
        """Press T."""
        self.key(Qt.Key.Key_T)
        self.wait(lambda: self.studio.mode is Mode.TEACHING)
        self.settle()

    def turn_of(self, node: str) -> None:
        """Press Ctrl+Tab until it is a node's turn."""
        for _ in self.studio.teaching.nodes:
            if self.studio.teaching.node != node:
                self.key(Qt.Key.Key_Tab, CONTROL)
        assert self.studio.teaching.node == node

    def pick_at(self, name: str, entity: int) -> None:
        """Pick a behavior with a slot, and click in the world what the slot is to be."""
        choice = next(c for c in self.page.choices if c.name == name and c.slots)
        self.key(Qt.Key(ord(choice.key)))
        (slot,) = choice.slots
        assert self.studio.teaching.choosing.wanted == slot
        self.act(lambda: self.click_entity(entity))
        assert not self.studio.teaching.choosing.is_busy, self.said

    def until(self, tick: int) -> None:
        """Hold the key that passes single ticks up to *tick*."""
        self.hold(tick - self.snapshot.tick)
