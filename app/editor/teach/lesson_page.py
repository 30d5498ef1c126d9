"""During a lesson: the buttons, whose turn it is, and what was recorded."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor, QKeySequence, QShortcut
from PySide6.QtWidgets import QMenu, QToolButton, QVBoxLayout, QWidget

from ...core.amounts import counted
from ...core.automaton import Basic
from ...core.wording import example_words
from ...engine.snapshots import LessonView, Snapshot
from ..forms.buttons import opens
from ..selection import BehaviorKey
from ..soon import Soon
from .adding import AddList
from .button import BehaviorButton, Ring
from .choices import Choice, choices_of, examples_by_label, kept_in_place
from .flow import ButtonFlow, Rows
from .lesson_row import LessonRow
from .target_row import TargetRow
from .told import Told
from .turn_label import TurnLabel

if TYPE_CHECKING:
    from ..studio import Studio


#: Why what raises a flag is dim in Start.
AT_ONCE = "It is in Start now: this would end the behavior before it has done anything"


class LessonPage(QWidget):
    """What can be picked now.

    Attributes:
        buttons: Those that pick a state, by its id.
        new: Those that pick what is no state yet, by its name, which may be any state's id.
        choices: All that can be picked.
    """

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._teaching = studio.teaching
        self.choices: tuple[Choice, ...] = ()
        self.buttons: dict[str, BehaviorButton] = {}
        self.new: dict[str, BehaviorButton] = {}
        self._shortcuts: list[QShortcut] = []
        self._built_from: tuple[object, ...] = ()
        self._order: tuple[Choice, ...] = ()  # as they stand; of what is taught since the lesson began
        self._ordered_for: BehaviorKey | None = None
        self._shown_state = "", "", "", False
        self.flow = ButtonFlow()
        self.add = QToolButton()
        self.add.setText("+ add behavior")
        self.add.setFixedHeight(40)
        self.add.setToolTip("Pick a behavior or a flag that is no state yet; it becomes one")
        self.add.clicked.connect(self.open_list)
        self.list = AddList(self)
        self.list.chosen.connect(self.choose)
        self.turn = TurnLabel(studio.theme)
        self.next = self._action_button("teach.next")
        self.mend = self._action_button("teach.mend")
        self._teaching.choosing.changed.connect(self._make_room)  # before the row takes it
        self.targets = TargetRow(studio)
        self.last = Told(studio.theme)
        self.options = self._options_button()
        self.row = LessonRow(self.turn, self.next, self.targets, self.last, self.mend, self.options)
        self.badge = self.row.badge
        self._lay_out()
        self._connect()

    def _lay_out(self) -> None:
        self.rows = Rows(self.flow)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 4, 0, 0)
        layout.setSpacing(6)
        layout.addWidget(self.rows)
        layout.addWidget(self.row)
        layout.addStretch(1)

    def _connect(self) -> None:
        studio = self._studio
        # A pick changes the project, what was learned from it, and the lesson; what keys mean is known to all of them.
        soon = Soon(self, self.refresh, everywhere=True)
        studio.document.project_changed.connect(soon.ask)
        studio.colors.changed.connect(self._rebuild)
        studio.theme.changed.connect(self._rebuild)
        studio.settings.changed.connect(self._rebuild)
        studio.settings.changed.connect(self._tell_key)
        studio.bridge.mode_changed.connect(self.refresh)
        studio.bridge.snapshot_changed.connect(self._snapshot_changed)
        self._teaching.changed.connect(soon.ask)
        self._teaching.choosing.changed.connect(self._tell)
        self._dress()
        self._tell_key()

    def _tell_key(self) -> None:
        """Whoever teaches several by keys is told which one goes to the next."""
        keys, text = self._studio.actions.keys_of("teach.next"), self._studio.actions.text_of("teach.next")
        self._studio.actions["teach.next"].setIconText(f"{text} ({keys})" if keys else text)

    def _action_button(self, action: str) -> QToolButton:
        button = QToolButton()
        button.setDefaultAction(self._studio.actions[action])
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        button.setProperty("flat", "true")
        return button

    def _options_button(self) -> QToolButton:
        button = QToolButton()
        button.setText("⋯")
        button.setProperty("flat", "true")
        button.setStyleSheet("QToolButton::menu-indicator { image: none; }")
        button.setToolTip("How the lesson goes: what others do, and whether a pick steps on")
        button.setAccessibleName("Options of the lesson")
        menu = QMenu(button)
        menu.setToolTipsVisible(True)
        for action in ("teach.others", "teach.steps_on", "teach.keep", "teach.stop"):
            menu.addAction(self._studio.actions[action])
        opens(button, menu)
        return button

    # ------------------------------------------------------------------------------------------ picking

    def choose(self, choice: Choice) -> None:
        """Pick; where slots are open, ask for their targets first."""
        if choice.slots:
            self._teaching.choosing.add(choice)
        else:
            self._teaching.choosing.cancel()
            self._teaching.pick(choice.state or choice.content)

    def open_list(self) -> None:
        """Show all that can be added."""
        new = [(choice, self._color(choice)) for choice in self.choices if not choice.state]
        self.list.open(new, self.add.mapToGlobal(QPoint(0, self.add.height() + 4)))

    def answers(self, states: list[str]) -> list[BehaviorButton]:
        """Buttons of their own for some states."""
        found = {choice.state: choice for choice in self.choices if choice.state}
        return [self._button(found[state]) for state in states if state in found]

    # ------------------------------------------------------------------------------------------ showing

    def refresh(self) -> None:
        """Show what is other now."""
        automaton, key, lesson = self._teaching.automaton, self._teaching.key, self._teaching.lesson
        if automaton is None or key is None or lesson is None:
            self._leave()
            self._ordered_for = None
            return
        library, vocabulary = (
            self._studio.document.project.library(key.type),
            self._studio.document.vocabulary(key.type),
        )
        built_from = (
            key,
            automaton.states,
            [(a.id, a.name, a.parameters, a.nested()) for a in library.automata.values()],
        )
        if built_from != self._built_from:
            self._built_from = built_from
            self.choices = choices_of(automaton, library, vocabulary, self._reserved())
            if key != self._ordered_for:
                self._order, self._ordered_for = (), key
            self._build()
        self._tell()
        self._count()
        self._show_rings(self._to_show(lesson))

    def _leave(self) -> None:
        for shortcut in self._shortcuts:
            shortcut.setEnabled(False)
            shortcut.deleteLater()
        self._shortcuts, self._built_from = [], ()

    def _reserved(self) -> set[str]:
        """Keys without modifiers that are shortcuts of actions."""
        actions = self._studio.actions
        return {actions.keys_of(action_id) for action_id in actions.rows}

    def _rebuild(self, *_: object) -> None:
        self._built_from = ()
        self._dress()
        self.refresh()

    def _build(self) -> None:
        for button in (*self.buttons.values(), *self.new.values()):
            button.hide()
            button.deleteLater()
        self._leave_shortcuts()
        shown = [choice for choice in self.choices if choice.state or choice.kind != "flag"]
        self.buttons = {choice.state: self._button(choice) for choice in shown if choice.state}
        self.new = {choice.name: self._button(choice) for choice in shown if not choice.state}
        self._shortcuts += [
            self._shortcut(choice, key) for choice in self.choices for key in (choice.key, choice.also) if key
        ]
        self._order = kept_in_place(shown, self._order)
        self.flow.hold([*(self._button_of(c) for c in self._order), self.add], [*self.new.values()])

    def _leave_shortcuts(self) -> None:
        built = self._built_from
        self._leave()
        self._built_from = built

    def _button_of(self, choice: Choice) -> BehaviorButton:
        return self.buttons[choice.state] if choice.state else self.new[choice.name]

    def _button(self, choice: Choice) -> BehaviorButton:
        name = choice.name + ("…" if choice.slots else "")
        button = BehaviorButton(self._studio.theme, name, self._color(choice), choice.key)
        button.dress(ghost=not choice.state)
        button.setToolTip(_tip(choice))
        button.clicked.connect(lambda: self.choose(choice))
        return button

    def _shortcut(self, choice: Choice, key: str) -> QShortcut:
        shortcut = QShortcut(QKeySequence(key), self)
        shortcut.setAutoRepeat(False)
        shortcut.activated.connect(lambda: self.choose(choice))
        return shortcut

    def _color(self, choice: Choice) -> QColor:
        """What a controller directs has the color of the automata of that name, as on the graph."""
        key, colors = self._teaching.key, self._studio.colors
        if isinstance(choice.content, Basic):
            return colors.of_name(choice.content.behavior)
        return colors.color(key.type if key else "", choice.automaton)

    def _count(self) -> None:
        key = self._teaching.key
        if key is None:
            return
        examples = self._studio.document.project.examples_of(key.type, key.id)
        counts = examples_by_label(examples)
        in_start = self._teaching.state in ("", "start")
        for choice in self._order:
            told = counted(counts.get(choice.state, 0), "example") if choice.state else ""
            button, dimmed = self._button_of(choice), bool(choice.raises) and in_start
            button.dress(caption=told, ghost=not choice.state, dimmed=dimmed)
            button.setToolTip(f"{_tip(choice)}\n{AT_ONCE}" if dimmed else _tip(choice))
        words, tip = self._kept_words()
        recorded = counted(len(examples), "example")
        self.row.count(f"{recorded}{words}", recorded, tip)
        self.flow.arrange()

    def _kept_words(self) -> tuple[str, str]:
        """Whether the lesson is kept as a demonstration, briefly and in full."""
        keeping, filed = self._teaching.keeping, self._teaching.filed_under
        if not keeping.on:
            return "", "Lessons are not kept as demonstrations (Teach > Keep as demonstration)"
        if why := keeping.obstacle:
            learned = "What you pick is learned from like all else, but not kept as a demonstration to be played again:"
            return " · no demonstration", f"{learned}\n{why}."
        if keeping.is_kept:
            return " · kept", f"Kept as demonstration {filed!r}, which can be played again"
        return "", f"What you pick is kept as demonstration {filed!r}"

    def _tell(self) -> None:
        """What was recorded last, whose turn it is."""
        teaching, snapshot = self._teaching, self._studio.snapshot
        nodes = teaching.nodes
        if snapshot is not None:
            number = nodes.index(teaching.node) + 1 if teaching.node in nodes else 0
            self.turn.tell(snapshot.place.called(teaching.node), number, len(nodes))
        adding = teaching.choosing.adding is not None  # which needs the room
        self.turn.setVisible(not adding)
        self.next.setVisible(len(nodes) > 1 and not adding)
        self.mend.setVisible(teaching.lesson is not None and teaching.lesson.testing and not adding)
        self.badge.setVisible(not adding)
        self.last.setText(self._last_words())

    def _make_room(self) -> None:
        """Hide what is not needed while targets of a new state are chosen."""
        if self._teaching.choosing.adding is not None:
            for widget in (self.turn, self.next, self.mend, self.badge):
                widget.hide()

    def _last_words(self) -> str:
        teaching, document = self._teaching, self._studio.document
        key, automaton = teaching.key, teaching.automaton
        if teaching.last is None or key is None or automaton is None:
            return "" if teaching.lesson is None or teaching.lesson.testing else "Pick what it is to do."
        recorded = teaching.last.recorded
        if not recorded.examples:
            return "Nothing to learn from this pick: what raises a flag is not left by choice."
        said = example_words(
            recorded.examples[0],
            automaton,
            document.project.library(key.type),
            document.scenario.vocabulary,
        )
        return f"Last: {said}"

    def _snapshot_changed(self, _snapshot: Snapshot) -> None:
        lesson = self._teaching.lesson
        if lesson is None or not self.isVisible():
            return
        shown, before = self._to_show(lesson), self._shown_state
        if shown == before:
            return
        if shown[:2] != before[:2]:
            self._count()
        self._show_rings(shown)

    def _to_show(self, lesson: LessonView) -> tuple[str, str, str, bool]:
        """The node, its state, the state that was picked for it, and whether it is in training."""
        teaching = self._teaching
        taught = teaching.node in lesson.taught or not lesson.testing
        return teaching.node, teaching.state, teaching.picked, taught

    def _show_rings(self, shown: tuple[str, str, str, bool]) -> None:
        """Ring what the node does, and what it is about to do."""
        self._shown_state = shown
        _, now, picked, taught = shown
        for state, button in self.buttons.items():
            ring = Ring.NOW if state == now else Ring.NEXT if state == picked else Ring.NONE
            button.show_ring(ring, "teach" if taught else "accent")

    def _dress(self) -> None:
        colors = self._studio.theme.palette
        self.badge.setStyleSheet(
            f"#badge {{ color: {colors.dim}; font-size: 11px; border: 1px solid {colors.hairline};"
            " border-radius: 9px; padding: 1px 8px; }"
        )
        self.add.setStyleSheet(
            f"QToolButton {{ border: 1px dashed {colors.hairline}; border-radius: 8px; background: transparent;"
            f" color: {colors.dim}; padding: 0 12px; }}"
            f" QToolButton:focus, QToolButton:hover {{ border-color: {colors.accent}; color: {colors.text}; }}"
        )


def _tip(choice: Choice) -> str:
    """What it does, and the keys that pick it."""
    what = choice.doc or choice.name
    keys = " or ".join(key for key in (choice.key, choice.also) if key)
    return f"{what} ({keys})" if keys else what
