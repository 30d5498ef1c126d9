"""What is wrong with the project, and what can be done about it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QModelIndex, QPoint, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QKeyEvent, QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QLabel, QMenu, QTreeView, QVBoxLayout, QWidget

from ...core.check.fixes import Fix
from ...core.errors import UnderstudyError
from ..actions import ActionRow, needs
from ..context_menus import menu_place
from ..letters import plain
from ..selection import BehaviorKey
from .findings import Finding, Findings
from .model import FIX, PLACE, WHAT, ProblemsModel

if TYPE_CHECKING:
    from ..studio import Studio

NONE = "No problems: everything is bound, can be reached, and has something to decide by."
#: Pixels that columns get in any case, if they need them, and their share of a wide list; problems get the rest.
GRANTED = {PLACE: 170, FIX: 190}
SHARE = 0.25
#: Rows below those in sight that a column is made wide enough for: there may be thousands.
MEASURED = 50


class ProblemsPanel(QWidget):
    """What is wrong with the project, and what can be done about it.

    Attributes:
        model, list: The problems.

    Signals:
        title_changed: The dock's title, with how many there are.
    """

    title_changed = Signal(str)

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self.findings = Findings(studio.document, self)
        self.model = ProblemsModel(studio.theme)
        self.list = ProblemList()
        self.list.setModel(self.model)
        self.empty = QLabel(NONE)
        self.empty.setProperty("role", "empty")
        self.empty.setContentsMargins(10, 8, 10, 8)
        self.empty.setWordWrap(True)
        self.more = QLabel()
        self.more.setProperty("role", "caption")
        self.more.setContentsMargins(10, 2, 10, 4)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.empty)
        column.addWidget(self.list, 1)
        column.addWidget(self.more)
        self.setFocusProxy(self.list)
        self.list.prepare_columns()
        studio.actions.add(problem_rows(self))
        self.findings.changed.connect(self._show)
        studio.closing.connect(self.findings.close)
        studio.opened.connect(self._show)
        self.list.activated.connect(self.jump)
        self.list.clicked.connect(self._clicked)
        self.list.selectionModel().currentChanged.connect(lambda *_: studio.touch())
        self.list.fix_wanted.connect(self.fix)
        self.list.menu_wanted.connect(lambda spot: self.menu().popup(spot))
        self._show()

    def _show(self) -> None:
        found = self.findings.found
        row = self.list.currentIndex().row()
        self.model.show(found.findings if self._studio.is_open else ())
        count = len(self.model.findings) + found.more
        if count:
            self.list.setCurrentIndex(self.model.index(min(max(row, 0), self.model.rowCount() - 1), WHAT))
        self.empty.setVisible(not count and self._studio.is_open)
        self.list.setVisible(bool(count))
        self.list.fit_columns()
        self.more.setText(f"and {found.more} more" if found.more else "")
        self.more.setVisible(bool(found.more))
        self.title_changed.emit(f"Problems {count}" if count else "Problems")
        self._studio.touch()

    @property
    def current(self) -> Finding | None:
        """The problem that is chosen."""
        return self.model.finding(self.list.currentIndex())

    # ------------------------------------------------------------------------------------------- acting

    def next(self) -> None:
        """Choose the next problem, and show its place."""
        count = self.model.rowCount()
        if count:
            self._studio.show_panel.emit("problems")
            at = (self.list.currentIndex().row() + 1) % count
            self.list.setCurrentIndex(self.model.index(at, WHAT))
            self.jump()

    def jump(self, _index: QModelIndex | None = None) -> None:
        """Show what the chosen problem is about."""
        finding = self.current
        if finding is None:
            return
        studio, spot = self._studio, finding.spot
        if spot.automaton and studio.document.automaton(spot.type, spot.automaton) is not None:
            state = {"state": spot.state} if spot.state else {}
            studio.selection.select_behavior(BehaviorKey(spot.type, spot.automaton), **state)
            if spot.example:
                studio.selection.select_examples([spot.example])
                studio.show_panel.emit("examples")
            elif spot.state or not spot.part:
                studio.show_panel.emit("graph")
            else:
                self._trigger("behavior.settings")
        elif spot.arm or spot.node_type:
            self._show_arm(spot.arm, spot.node)
        else:
            studio.say(
                f"this is about {finding.problem.file or 'the project'}: {finding.problem.where or 'all of it'}"
            )

    def _show_arm(self, arm: str, node: str) -> None:
        """A node is shown in the forest, if its arm is the one that is shown; all else in the arms' dialog."""
        shown = self._studio.arm
        if node and shown is not None and shown.name == arm:
            self._studio.selection.select_nodes([node])
            self._studio.show_panel.emit("agents")
        else:
            self._trigger("arm.settings")

    def _trigger(self, action: str) -> None:
        if action in self._studio.actions.rows:
            self._studio.actions.refresh()
            self._studio.actions[action].trigger()

    def _clicked(self, index: QModelIndex) -> None:
        if index.column() == FIX:
            self.fix()

    def fix(self) -> None:
        """Mend the chosen problem, or offer the ways where there are several."""
        finding = self.current
        if finding is None:
            return
        if finding.relearns:
            self._studio.relearning.learn()
        elif len(finding.fixes) == 1:
            self.mend(finding.fixes[0])
        elif finding.fixes:
            rect = self.list.visualRect(self.model.index(self.list.currentIndex().row(), FIX))
            self.menu(only_fixes=True).popup(self.list.viewport().mapToGlobal(rect.bottomLeft()))

    def mend(self, fix: Fix) -> None:
        """Do what a fix says, as one step."""
        document = self._studio.document
        try:
            project = fix.mend(document.project)
        except (UnderstudyError, KeyError) as error:  # the project may have changed since it was found
            self._studio.warn(f"this could not be done: {error}")
            return
        document.push(fix.text[:1].upper() + fix.text[1:], project)

    def menu(self, *, only_fixes: bool = False) -> QMenu:
        """What can be done with the chosen problem."""
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        finding = self.current
        for fix in finding.fixes if finding is not None else ():
            words = fix.text[:1].upper() + fix.text[1:]
            menu.addAction(plain(words)).triggered.connect(lambda _=False, fix=fix: self.mend(fix))
        if finding is not None and finding.relearns:
            menu.addAction(plain(finding.fix_words)).triggered.connect(self._studio.relearning.learn)
        if not only_fixes:
            menu.addSeparator()
            menu.addAction("Show the place").triggered.connect(self.jump)
        return menu


class ProblemList(QTreeView):
    """The table of problems.

    Signals:
        fix_wanted: By Ctrl+Enter.
        menu_wanted: The context menu is wanted at this place of the screen.
    """

    fix_wanted = Signal()
    menu_wanted = Signal(QPoint)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("problem-list")
        self.setAccessibleName("Problems")
        self.setRootIsDecorated(False)
        self.setUniformRowHeights(True)
        self.setMouseTracking(True)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)

    def prepare_columns(self) -> None:
        """Once the model is there, let problems have what room is left."""
        header = self.header()
        header.setResizeContentsPrecision(MEASURED)
        header.setStretchLastSection(False)
        header.setSectionResizeMode(WHAT, QHeaderView.ResizeMode.Stretch)
        for column in GRANTED:
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.Interactive)

    def fit_columns(self) -> None:
        """No column wider than what stands in it: what is wrong takes more words than where it is, and what mends it."""
        for column, granted in GRANTED.items():
            needed = max(self.header().sectionSizeHint(column), self.sizeHintForColumn(column))
            self.header().resizeSection(column, min(needed, max(granted, int(SHARE * self.width()))))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """In another width, columns may have other widths."""
        super().resizeEvent(event)
        self.fit_columns()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter shows the place, Ctrl+Enter mends."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            event.accept()
            if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
                self.fix_wanted.emit()
            else:
                self.activated.emit(self.currentIndex())
        else:
            super().keyPressEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """By the right button or the menu key."""
        self.menu_wanted.emit(menu_place(self, event))


def problem_rows(panel: ProblemsPanel) -> tuple[ActionRow, ...]:
    """The actions that concern problems."""

    @needs("there are no problems")
    def has_problems(_studio: Studio) -> bool:
        return panel.model.rowCount() > 0

    @needs("choose a problem in the panel Problems that can be mended by itself")
    def can_mend(_studio: Studio) -> bool:
        return panel.current is not None and panel.current.mendable

    return (
        ActionRow(
            "problems.next",
            "Next problem",
            "Behavior",
            lambda _: panel.next(),
            "problems",
            "F8",
            "Choose the next problem, and show what it is about",
            "alert-outline",
            has_problems,
        ),
        ActionRow(
            "problems.fix",
            "Fix problem",
            "Behavior",
            lambda _: panel.fix(),
            "problems",
            "Shift+F8",
            "Mend the chosen problem (Ctrl+Enter in the list)",
            "auto-fix",
            can_mend,
        ),
    )
