"""The rules of a transition in a small form that only allows what exists."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QToolButton, QVBoxLayout, QWidget

from ...core.automaton import Automaton, Rule
from ...core.conditions import Condition, Equals, Guard
from ...core.edits import add_feature, add_rule, describe, order_rules, remove_rule, replace_rule
from ...core.errors import UnderstudyError
from ...core.features import FeatureUse, Source
from ...core.vocabulary import Vocabulary
from ...core.wording import condition_words, feature_of, state_words
from ..forms.parts import caption
from ..forms.tab_order import tab_through
from . import offers
from .condition_row import ConditionRow
from .number_field import NumberField
from .scoping import Scoping

if TYPE_CHECKING:
    from ..studio import Studio

#: Type, automaton, source and target.
Place = tuple[str, str, str, str]


class RuleForm(QWidget):
    """Shows and changes the rules from one state to another.

    Attributes:
        place: Which ones; None while nothing is shown.
        title: The same in words.
    """

    def __init__(self, studio: Studio, scoping: Scoping) -> None:
        super().__init__()
        self._studio, self._scoping = studio, scoping
        self.place: Place | None = None
        self.title = ""
        self.blocks: list[RuleBlock] = []
        self._keys_go = "", ""  # the rule and the part that they go to after the next change
        self._features: tuple[FeatureUse, ...] = ()
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(10, 4, 10, 8)
        self._column.setSpacing(6)
        self._learned = caption("")
        self.more = QPushButton("Add a rule")
        self.more.setToolTip("Add another rule from and to the same states, tried after the others")
        self.more.clicked.connect(self._add)
        self._column.addWidget(self._learned)
        self._column.addWidget(self.more)
        self._column.addStretch(1)

    def show_place(self, place: Place | None, learned: str = "") -> None:
        """Show the rules between two states; *learned* says what was learned between them."""
        automaton = None if place is None else self._scoping.automaton(*place[:2])
        if place is None or automaton is None or not all(automaton.has_state(state) for state in place[2:]):
            self.place = None
            self._fill([])
            return
        library = self._studio.document.project.library(place[0])
        names = [state_words(automaton, state, library) for state in place[2:]]
        self.title = f"{names[0]} → {names[1]}"
        self._learned.setText(learned)
        self._learned.setVisible(bool(learned))
        ordered = automaton.rules_of(place[2])
        shown = [(rule, order) for order, rule in enumerate(ordered, 1) if rule.target == place[3]]
        as_shown = [
            (block.rule.id, block.rule.guard, block.rule.probability, block.order) for block in self.blocks
        ]
        wanted = [(rule.id, rule.guard, rule.probability, order) for rule, order in shown]
        if place == self.place and as_shown == wanted and self._features == automaton.features:
            return
        self.place, self._features = place, automaton.features
        self._fill([RuleBlock(self, rule, order, len(ordered), automaton) for rule, order in shown])

    def _fill(self, blocks: list[RuleBlock]) -> None:
        """Other blocks; where the keys were in one of those before, they stay in the form."""
        had_keys = any(block.isAncestorOf(self.window().focusWidget()) for block in self.blocks)
        for block in self.blocks:
            self._column.removeWidget(block)
            block.hide()
            block.deleteLater()
        self.blocks = blocks
        for number, block in enumerate(blocks):
            self._column.insertWidget(1 + number, block)
        tab_through(self, [*blocks, self.more])
        if had_keys:
            self._put_keys(*self._keys_go)
        self._keys_go = "", ""

    def _put_keys(self, rule: str, part: str) -> None:
        """Let the keys go to what follows upon the last change: to the new test, or to the button that was pressed."""
        block = next((block for block in self.blocks if rule in ("", block.rule.id)), None)
        field = self.more if block is None else block.part(part)
        field.setFocus(Qt.FocusReason.OtherFocusReason)

    # -------------------------------------------------------------------------------------------- changing

    def _add(self) -> None:
        if self.place is not None:
            self._studio.document.attempt(add_rule, *self.place)

    def change(self, rule: Rule, *, gesture: str = "", **fields: Any) -> None:
        """Change a rule."""
        if self.place is not None:
            self._studio.document.attempt(replace_rule, *self.place[:2], rule.id, gesture=gesture, **fields)

    def keys_to(self, rule: Rule, part: str) -> None:
        """After the next change, let the keys go to a part of a rule."""
        self._keys_go = rule.id, part

    def end_gesture(self) -> None:
        """The hand let go."""
        self._studio.document.end_gesture()

    def remove(self, rule: Rule) -> None:
        """No such rule any more."""
        self._keys_go = "", "add"
        if self.place is not None:
            self._studio.document.attempt(remove_rule, *self.place[:2], rule.id)

    def reorder(self, rule: Rule, by: int) -> None:
        """Try a rule earlier or later."""
        if self.place is None:
            return
        automaton = self._scoping.automaton(*self.place[:2])
        order = [other.id for other in automaton.rules_of(rule.source)] if automaton is not None else []
        place = order.index(rule.id)
        if 0 <= place + by < len(order):
            order.insert(place + by, order.pop(place))
            self.keys_to(rule, "earlier" if by < 0 else "later")
            self._studio.document.attempt(order_rules, *self.place[:2], rule.source, order)

    def test_something(self, rule: Rule, guard: Guard, place: int, what: str | Source) -> None:
        """Test a feature, or a source that becomes a feature in the same step, at a place of the guard."""
        if self.place is None:
            return
        document, where = self._studio.document, self.place[:2]
        project = document.project
        try:
            if not isinstance(what, str):
                project, feature_id = add_feature(project, *where, what)
            else:
                feature_id = what
            use = feature_of(project.library(where[0]).get(where[1]), feature_id)
            condition = offers.first_test(feature_id, use.source, document.scenario.vocabulary)
            new = (*guard[:place], condition, *guard[place + 1 :])
            text = describe(replace_rule, project, *where, rule.id, guard=new)
            self.keys_to(rule, f"test {place}")
            document.push(text, replace_rule(project, *where, rule.id, guard=new))
        except UnderstudyError as error:
            self._studio.warn(str(error))

    @property
    def vocabulary(self) -> Vocabulary:
        """The scenario's."""
        return self._studio.document.scenario.vocabulary

    def choices(self, automaton: Automaton) -> tuple[list[offers.Choice], list[offers.Choice]]:
        """What can be tested: features that there are, and what can become one."""
        scope = None if self.place is None else self._scoping.scope(self.place[0])
        uses = [(use.shown, use.id) for use in automaton.features]
        return uses, [] if scope is None else offers.sources(scope, automaton)


class RuleBlock(QWidget):
    """One rule: its place, its probability, and its tests.

    Attributes:
        rule, order: What is shown.
        rows: Its tests.
    """

    def __init__(self, form: RuleForm, rule: Rule, order: int, of: int, automaton: Automaton) -> None:
        super().__init__()
        self._form, self.rule, self.order = form, rule, order
        self.rows: list[ConditionRow] = []
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        column.addLayout(self._head(order, of))
        uses, others = form.choices(automaton)
        for number, condition in enumerate(rule.guard):
            column.addWidget(self._row(number, condition, automaton, uses, others))
        self.add = QPushButton("and a test" if rule.guard else "Only when …")
        self.add.setToolTip("Add a test: the rule applies where all its tests are met")
        self.add.setEnabled(bool(uses or others))
        self.add.clicked.connect(lambda: self._add_test(uses, others))
        column.addWidget(self.add)

    def _head(self, order: int, of: int) -> QHBoxLayout:
        head = QHBoxLayout()
        head.setSpacing(4)
        head.addWidget(QLabel(f"Rule {order} of {of}"))
        self.earlier = self._button("▲", "Try this rule earlier", lambda: self._form.reorder(self.rule, -1))
        self.later = self._button("▼", "Try this rule later", lambda: self._form.reorder(self.rule, 1))
        self.earlier.setEnabled(order > 1)
        self.later.setEnabled(order < of)
        self.probability = NumberField("Probability of the rule", 0.0, 100.0, "%")
        self.probability.setToolTip(
            "How probable it is, each tick, that the rule is followed where it applies"
        )
        self.probability.setValue(100.0 * self.rule.probability)
        self.probability.valueChanged.connect(self._probability_changed)
        self.probability.editingFinished.connect(self._form.end_gesture)
        self.removal = self._button("✕", "Remove this rule", lambda: self._form.remove(self.rule))
        for widget in (self.earlier, self.later):
            head.addWidget(widget)
        head.addStretch(1)
        named = QLabel("probability")
        named.setProperty("role", "caption")
        head.addWidget(named)
        head.addWidget(self.probability, 1)
        head.addWidget(self.removal)
        return head

    def part(self, name: str) -> QWidget:
        """A part that takes keys: "test 0" is what the first test tests; where there is no such part, what adds a test."""
        tests = {f"test {number}": row.what for number, row in enumerate(self.rows)}
        parts: dict[str, QWidget] = {"earlier": self.earlier, "later": self.later, **tests}
        found = parts.get(name, self.add)
        if not found.isEnabled():  # at an end of the order, the other way is the one that is left
            found = self.later if found is self.earlier else self.earlier
        return found

    def _button(self, text: str, tip: str, act: Callable[[], object]) -> QToolButton:
        button = QToolButton()
        button.setText(text)
        button.setProperty("flat", "true")
        button.setToolTip(tip)
        button.setAccessibleName(tip)
        button.clicked.connect(lambda _checked: act())
        return button

    def _row(
        self,
        number: int,
        condition: Condition,
        automaton: Automaton,
        uses: list[offers.Choice],
        others: list[offers.Choice],
    ) -> ConditionRow:
        use = feature_of(automaton, condition.test.feature)
        known = any(value == use.id for _, value in uses)
        feature = offers.kind_of(use, self._form.vocabulary)
        true, false = Condition(Equals(use.id, 1.0)), Condition(Equals(use.id, 1.0), wanted=False)
        vocabulary = self._form.vocabulary
        words = condition_words(true, automaton, vocabulary), condition_words(false, automaton, vocabulary)
        offered = uses if known else [(use.shown, use.id), *uses]
        row = ConditionRow(condition, use, feature, words, offered, others)
        row.changed.connect(lambda still: self._guard_changed(still=still))
        row.settled.connect(self._form.end_gesture)
        row.resourced.connect(
            lambda what: self._form.test_something(self.rule, self.rule.guard, number, what)
        )
        row.removed.connect(lambda: self._without(number))
        self.rows.append(row)
        return row

    def _probability_changed(self, percent: float) -> None:
        self._change(gesture=f"probability {self.rule.id}", probability=round(percent / 100.0, 8))

    def _guard_changed(self, *, still: bool) -> None:
        guard = tuple(row.condition for row in self.rows)
        self._change(gesture=f"guard {self.rule.id}" if still else "", guard=guard)

    def _change(self, *, gesture: str, **fields: Any) -> None:
        """Change the rule; what the form shows is then the rule as it is, so that it need not be made anew."""
        old = self.rule
        self.rule = Rule(
            old.id,
            old.source,
            fields.get("guard", old.guard),
            old.target,
            fields.get("probability", old.probability),
        )
        self._form.change(old, gesture=gesture, **fields)

    def _without(self, number: int) -> None:
        self._form.keys_to(self.rule, "add")
        self._form.change(self.rule, guard=(*self.rule.guard[:number], *self.rule.guard[number + 1 :]))

    def _add_test(self, uses: list[offers.Choice], others: list[offers.Choice]) -> None:
        tested = {condition.test.feature for condition in self.rule.guard}
        free = [value for _, value in uses if value not in tested] or [value for _, value in (*uses, *others)]
        self._form.test_something(self.rule, self.rule.guard, len(self.rule.guard), free[0])
