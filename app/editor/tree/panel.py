"""The decision tree of the state that is shown."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, QSignalBlocker, Qt, Signal
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import (
    QComboBox,
    QHBoxLayout,
    QLabel,
    QMenu,
    QSpinBox,
    QStackedLayout,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ...core.automaton import Cut, Refit
from ...core.conditions import AtMost, InArc
from ...core.cuts import with_cuts
from ...core.phrasing import number
from ...engine.snapshots import WatchedLevel
from ...learner.registry import METHODS
from ..number_box import roomy
from ..soon import Later, Soon
from .menus import node_menu
from .previewing import Previewing
from .pruning import Pruning
from .rows import tree_rows
from .rules import RuleList
from .scene import TreeScene
from .shape import Key, lit
from .subject import Subject
from .subjects import Subjects
from .tools import Tools
from .view import TreeView
from .words import treeless_words

if TYPE_CHECKING:
    from ..studio import Studio

#: Milliseconds between two looks at what the selected node sees.
LIVE = 33
#: Pixels that the tree keeps whatever is open below it.
LOWEST = 104


class TreePanel(QWidget):
    """The decision tree of the state that is shown.

    Attributes:
        subject: What is shown; None without a behavior.
        scene, view: The tree, and what it is seen through.
        which: Chooses a tree of a forest.

    Signals:
        title_changed: The dock is to be called otherwise.
        refreshed: What is shown is up to date.
    """

    title_changed = Signal(str)
    refreshed = Signal()

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self.studio = studio
        self.subject: Subject | None = None
        self._shown: tuple[object, ...] = ()
        self._place: tuple[object, ...] = ()
        self._subjects = Subjects(studio)
        self.scene = TreeScene(studio.theme)
        self.view = TreeView(self.scene, studio.theme)
        self.view.setMinimumHeight(LOWEST)
        self.rules = RuleList(studio)
        self.tools = Tools(studio)
        self.pruning = Pruning(studio)
        self.previewing = Previewing(studio, self.tools.confidence, self.pruning)
        self.menu: QMenu | None = None
        self._soon = Soon(self, self.refresh)
        self._live = Later(self, self._follow, LIVE)
        studio.actions.add(tree_rows(self))
        self._build()
        self._connect()

    @property
    def message(self) -> str:
        """What is said where there is no tree."""
        return self._message.text()

    def _build(self) -> None:
        self._states = QComboBox()
        self._states.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self._states.setMinimumContentsLength(8)
        self._states.setAccessibleName("State whose decisions are shown")
        self._states.setToolTip("The state whose decisions are shown")
        self.which = roomy(QSpinBox())
        self.which.setPrefix("tree ")
        self.which.setAccessibleName("Tree of the forest")
        self.which.setToolTip("Which tree of the forest is shown")
        top = QHBoxLayout()
        top.setContentsMargins(8, 4, 8, 0)
        top.addWidget(QLabel("from"))
        top.addWidget(self._states, 1)
        top.addWidget(self.which)
        fit = QToolButton()
        fit.setProperty("flat", "true")
        fit.setDefaultAction(self.studio.actions["tree.fit"])
        fit.setAccessibleName(self.studio.actions.rows["tree.fit"].text)
        top.addWidget(fit)
        self._message = QLabel()
        self._message.setProperty("role", "empty")
        self._message.setWordWrap(True)
        self._message.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._message.setContentsMargins(10, 10, 10, 10)
        self._pages = QStackedLayout()
        self._pages.addWidget(self._message)
        self._pages.addWidget(self.view)
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(4)
        self._column.addLayout(top)
        self._column.addWidget(self.rules)
        self._column.addLayout(self._pages, 1)
        self._column.addWidget(self.tools)
        self.setFocusProxy(self.view)

    def _connect(self) -> None:
        studio = self.studio
        for signal in (studio.opened, studio.colors.changed, studio.theme.changed):
            signal.connect(self._dress)
        studio.document.project_changed.connect(lambda *_: self.touch())
        studio.selection.behavior_changed.connect(self.touch)
        studio.selection.state_changed.connect(self.touch)
        studio.selection.nodes_changed.connect(self._live_soon)
        studio.bridge.snapshot_changed.connect(self._live_soon)
        self._states.activated.connect(
            lambda place: studio.selection.select_state(self._states.itemData(place))
        )
        self.which.valueChanged.connect(lambda _: self.touch())
        self.view.chosen.connect(self.choose)
        self.view.toggled.connect(self._toggle)
        self.view.removed.connect(self.prune)
        self.view.menu_wanted.connect(self._menu)
        self.tools.opened.connect(self._show_tools)
        cut = self.tools.cut
        cut.dragged.connect(self._cut_dragged)
        cut.dropped.connect(self._cut_dropped)
        cut.cancelled.connect(self._dress)
        cut.settled.connect(studio.document.end_gesture)
        self.previewing.changed.connect(self._show_tree)

    # ------------------------------------------------------------------------------------------- what is shown

    def touch(self) -> None:
        """Something that is shown has changed."""
        if self.isVisible():
            self._soon.ask()

    def _dress(self) -> None:
        self._shown = ()
        self.touch()

    def showEvent(self, event: QShowEvent) -> None:
        """Catch up with what happened meanwhile."""
        super().showEvent(event)
        self._soon.ask()

    def refresh(self) -> None:
        """Show everything as it is now."""
        made_of = (*self._subjects.made_of(), self.which.value())
        if len(made_of) == len(self._shown) and all(
            _same(a, b) for a, b in zip(made_of, self._shown, strict=True)
        ):
            return
        other = made_of[:2] != self._place
        self._shown, self._place = made_of, made_of[:2]
        self._show(self._subject(), other=other)

    def _subject(self) -> Subject | None:
        with QSignalBlocker(self.which):
            self.which.setRange(1, self._subjects.trees())
        return self._subjects.selected(self.which.value())

    def _show(self, subject: Subject | None, *, other: bool) -> None:
        self.subject = subject
        if other:
            self.previewing.forget()
            self.scene.forget_opened()
            self.view.is_fitted = True
        self._show_states(subject)
        self.which.setVisible(subject is not None and subject.trees > 1)
        self.rules.show_subject(subject)
        self.scene.build(self.previewing.shown(subject))
        self._show_tools()
        self._message.setText(self._explanation())
        self._pages.setCurrentIndex(1 if subject is not None and subject.tree is not None else 0)
        title = "Decision tree" if subject is None else f"Decision tree · from {subject.name(subject.state)}"
        self.title_changed.emit(title)
        self._follow()
        self.view.changed()
        self.studio.touch()
        self.refreshed.emit()

    def _show_states(self, subject: Subject | None) -> None:
        with QSignalBlocker(self._states):
            self._states.clear()
            if subject is not None:
                for state in subject.automaton.states:
                    self._states.addItem(subject.name(state.id), state.id)
            self._states.setCurrentIndex(self._states.findData(self.studio.selection.state))

    def _explanation(self) -> str:
        """Why there is no tree, what to do, and what a model without one says now."""
        subject = self.subject
        told = treeless_words(subject)
        if subject is not None and isinstance(subject.model, Refit):
            return f"{told} {self._outcome_now()}".strip()
        return told

    # -------------------------------------------------------------------------------------------------- live

    def _live_soon(self, _snapshot: object = None) -> None:
        if self.isVisible():
            self._live.ask()

    def _level_now(self) -> WatchedLevel | None:
        """The selected node's run of the automaton that is shown, if it is in the state that is shown."""
        snapshot, subject = self.studio.snapshot, self.subject
        watched = None if snapshot is None else snapshot.watched.get(self.studio.selection.node)
        if watched is None or subject is None:
            return None
        for level in watched.levels:
            if (level.type, level.automaton, level.state) == (
                subject.type,
                subject.automaton.id,
                subject.state,
            ):
                return level
        return None

    def _follow(self) -> None:
        level, subject = self._level_now(), self.subject
        if subject is None or subject.tree is None:
            if subject is not None and isinstance(subject.model, Refit):
                self._message.setText(self._explanation())
            return
        keys: tuple[Key, ...] = ()
        if level is not None:
            try:
                keys = lit(subject.tree, level.values.__getitem__)
            except KeyError:  # a feature that cannot be told now, or that the world does not know yet
                keys = ()
        self.scene.light(keys)

    def _outcome_now(self) -> str:
        level = self._level_now()
        subject = self.subject
        if level is None or subject is None or not level.outcome:
            return "Select an agent that is in this state to see what it says."
        said = ", ".join(f"{subject.name(state)} {number(100 * p)}%" for state, p in level.outcome)
        return f"Now it says: {said}."

    # ------------------------------------------------------------------------------------------------ choosing

    def choose(self, key: Key) -> None:
        """Select a node, and with it the examples that reach it."""
        self.scene.choose(key)
        if self.subject is not None and key:
            self.studio.selection.select_examples(self.subject.examples(key))
        self._show_tools()
        self.studio.touch()

    def _show_tree(self) -> None:
        """The tree alone has changed: a preview came, or is not wanted any more."""
        self.scene.build(self.previewing.shown(self.subject))
        self._follow()
        self.view.changed()

    def _toggle(self, key: Key) -> None:
        self.scene.toggle(key)
        self._follow()
        self.view.changed()

    def hideEvent(self, event: QHideEvent) -> None:
        """Nobody looks: nothing is learned to be looked at."""
        super().hideEvent(event)
        self._soon.forget()
        self._live.forget()
        self.previewing.close()
        self.studio.touch()

    # ------------------------------------------------------------------------------------------------ pruning

    def prune(self) -> None:
        """Prune the leaf or the subtree that is selected."""
        if self.subject is not None and self.scene.chosen:
            self.pruning.below(self.subject, self.scene.chosen)

    def take_back(self) -> None:
        """Take back the prunes at the node that is selected."""
        if self.subject is not None and self.scene.chosen:
            self.pruning.take_back(self.subject, self.scene.chosen)

    def _menu(self, at: QPoint) -> None:
        if self.subject is not None and self.scene.chosen:
            self.menu = node_menu(self, self.subject, self.scene.chosen)
            self.menu.popup(at)

    # ------------------------------------------------------------------------------------- below the tree

    def _show_tools(self) -> None:
        subject = self.subject
        self.tools.prunes.show_subject(subject)
        self.tools.count_prunes()
        settings = subject.automaton.settings if subject is not None else None
        prunes = settings is not None and _can_prune(settings.classifier)
        confidence = settings.pruning_confidence if settings is not None else None
        self.tools.confidence.show_confidence(confidence, possible=prunes)
        found = (
            subject.histogram(self.scene.chosen) if subject is not None and self.tools.page == "cut" else None
        )
        if found is None or subject is None:
            treeless = subject is None or subject.tree is None
            self.tools.cut.show_test(None, None, None, None, treeless=treeless)
        else:
            self.tools.cut.show_test(subject, *found, subject.feature_of(found[1]))

    def _cut_dragged(self, test: AtMost | InArc) -> None:
        """Show the tree as it would be; the project does not know of it yet."""
        subject, key = self.subject, self.scene.chosen
        if subject is not None and subject.tree is not None:
            tree = with_cuts(subject.tree, [Cut("", subject.state, subject.path(key), test)])
            self.scene.build(replace(subject, tree=tree))
            self._follow()

    def _cut_dropped(self, test: AtMost | InArc) -> None:
        if self.subject is not None and self.scene.chosen:
            key = self.scene.chosen
            gesture = "" if not self.tools.cut.hasFocus() else f"cut {self.subject.state} {key}"
            self.pruning.cut(self.subject, key, test, gesture)


def _same(a: object, b: object) -> bool:
    """Whether two parts are one and the same; small ones are compared."""
    return a is b or (not isinstance(a, tuple) and a.__class__ in (str, int) and a == b)


def _can_prune(classifier: str) -> bool:
    return classifier in METHODS and METHODS[classifier].prunes
