"""The decision tree of the state that is shown."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import (
    QLabel,
    QMenu,
    QStackedLayout,
    QVBoxLayout,
    QWidget,
)

from ...core.automaton import Cut, Refit
from ...core.conditions import AtMost, InArc
from ...core.cuts import with_cuts
from ...learner.registry import METHODS
from ..soon import Later, Soon
from .following import Following
from .header import Header
from .lighting import Lighting
from .menus import node_menu
from .previewing import Previewing
from .pruning import Pruning
from .rows import tree_rows
from .rules import RuleList
from .scene import TreeScene
from .shape import Key
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
        following: Whether the tree turns to the state that the selected node is in.
        scene, view: The tree, and what it is seen through.
        header: Chooses a state, and a tree of a forest.

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
        self._live = Later(self, self._light, LIVE)
        self.following = Following(studio, self._may_turn)
        self._lighting = Lighting(studio)
        studio.actions.add(tree_rows(self))
        self._build()
        self._connect()

    @property
    def message(self) -> str:
        """What is said where there is no tree."""
        return self._message.text()

    def _build(self) -> None:
        self.header = Header(self.studio.actions)
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
        self._column.addWidget(self.header)
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
        studio.selection.state_chosen.connect(self.following.stop)
        studio.selection.examples_changed.connect(self._examples_chosen)
        studio.selection.goal_changed.connect(self._transition_chosen)
        self.following.changed.connect(self._turned)
        studio.selection.nodes_changed.connect(self._live_soon)
        studio.bridge.snapshot_changed.connect(self._live_soon)
        self.header.chosen.connect(studio.selection.select_state)
        self.header.which.valueChanged.connect(lambda _: self.touch())
        self.view.chosen.connect(self.choose)
        self.view.toggled.connect(self._toggle)
        self.rules.taken.connect(self._stay)
        self.view.removed.connect(self.prune)
        self.view.menu_wanted.connect(self._menu)
        self.tools.opened.connect(self._opened)
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
        self.following.hurry()
        self._soon.ask()

    @property
    def state(self) -> str:
        """The state that is to be shown: the one that is followed, or else the one that is selected."""
        return self.following.state or self.studio.selection.state

    def refresh(self) -> None:
        """Show everything as it is now."""
        self.header.offer_trees(self._subjects.trees(self.state))
        made_of = (*self._subjects.made_of(self.state), self.header.which.value())
        if len(made_of) == len(self._shown) and all(
            _same(a, b) for a, b in zip(made_of, self._shown, strict=True)
        ):
            self._trace()
            return
        other = made_of[:2] != self._place
        self._shown, self._place = made_of, made_of[:2]
        self._show(self._subjects.of(self.state, self.header.which.value()), other=other)

    def _show(self, subject: Subject | None, *, other: bool) -> None:
        before, self.subject = self._possible(), subject
        if other:
            self.previewing.forget()
            self.scene.forget_opened()
            self.view.is_fitted = True
        self.header.show_subject(subject, self.state)
        self.rules.show_subject(subject)
        self.scene.build(self.previewing.shown(subject))
        self._show_tools()
        self._message.setText(self._explanation())
        self._pages.setCurrentIndex(1 if subject is not None and subject.tree is not None else 0)
        title = "Decision tree" if subject is None else f"Decision tree · from {subject.name(subject.state)}"
        self.title_changed.emit(title)
        self.view.changed()
        if not self._trace():
            self._light()
        if not other or self._possible() != before:
            self.studio.touch()
        self.refreshed.emit()

    def _possible(self) -> tuple[object, ...]:
        """What decides which actions there are, as long as the state is the same."""
        subject = self.subject
        return subject is not None, subject is not None and subject.tree is not None, self.scene.chosen

    def _explanation(self) -> str:
        """Why there is no tree, what to do, and what a model without one says now."""
        told = f"{treeless_words(self.subject)} {self._lighting.outcome_words(self.subject)}".strip()
        return f"{told}\n\n{self.following.words}." if self.following.words else told

    # -------------------------------------------------------------------------------------------------- live

    def _live_soon(self, _snapshot: object = None) -> None:
        if self.isVisible():
            self._live.ask()

    def _light(self) -> None:
        """Light the path of what was chosen elsewhere, or of what the selected node decides now, and say whose it is."""
        subject = self.subject
        if subject is not None and subject.tree is not None:
            self.scene.light(self._lighting.keys(subject, follows=self.following.on))
        elif subject is not None and isinstance(subject.model, Refit):
            self._message.setText(self._explanation())
        has_tree = subject is not None and subject.tree is not None
        self.view.tell(self.following.words or (self._lighting.words if has_tree else ""))

    def _trace(self) -> bool:
        """Where the chosen examples pass is lit, down to where they end; whether that is somewhere else now."""
        if not self._lighting.trace(self.subject):
            return False
        end = self._lighting.end(self.subject)
        if end:
            self.scene.open_to(end)
            self.view.changed()
        self._light()
        if end in self.scene.nodes:
            item = self.scene.nodes[end]
            self.view.show_item(item.mapRectToScene(item.box))
        return True

    # ------------------------------------------------------------------------------------------------ turning

    def _may_turn(self) -> bool:
        """Whether somebody looks, who is not just choosing a state."""
        return self.isVisible() and not self.header.is_choosing

    def _turned(self) -> None:
        """Another state is followed, or none any more."""
        self.studio.actions.refresh_some(["tree.follow"])
        self._message.setText(self._explanation())
        self._live_soon()
        self.touch()

    def _stay(self) -> None:
        """Something is done with the tree that is shown: it does not turn away."""
        self.following.switch(on=False)

    def _examples_chosen(self) -> None:
        """Show where they end, unless it was the tree that chose them; of its state the selection sees to it."""
        if self._lighting.has_examples:
            self.following.stop()
        self.touch()

    def _transition_chosen(self) -> None:
        """Show where the tree decides for it."""
        if self.studio.selection.goal:
            self.following.stop()
        self.touch()

    # ------------------------------------------------------------------------------------------------ choosing

    def choose(self, key: Key) -> None:
        """Select a node, and with it the examples that reach it."""
        self._stay()
        self.scene.choose(key)
        if self.subject is not None and key:
            examples = self.subject.examples(key)
            self._lighting.chose(examples)
            self.studio.selection.select_examples(examples)
        self._show_tools()
        self.studio.touch()

    def _show_tree(self) -> None:
        """The tree alone has changed: a preview came, or is not wanted any more."""
        self.scene.build(self.previewing.shown(self.subject))
        self._light()
        self.view.changed()

    def _toggle(self, key: Key) -> None:
        self._stay()
        self.scene.toggle(key)
        self._light()
        self.view.changed()

    def hideEvent(self, event: QHideEvent) -> None:
        """Nobody looks: nothing is learned to be looked at."""
        super().hideEvent(event)
        self._soon.forget()
        self._live.forget()
        self.following.rest()
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

    def _opened(self) -> None:
        if self.tools.page:
            self._stay()
        self._show_tools()

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
            self._light()

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
