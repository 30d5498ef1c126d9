"""One test of a rule as a row of the form: the feature, how it is compared, and with what."""

from dataclasses import replace
from math import degrees, radians

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QToolButton, QVBoxLayout, QWidget

from ...core.conditions import AtMost, Condition, Equals, InArc
from ...core.features import FeatureUse, Source
from ...core.phrasing import in_degrees, unit_of
from ...core.vocabulary import Feature, FeatureKind
from ..forms.list_choice import ListChoice
from .number_field import NumberField
from .offers import Choice

FARTHEST = 1e9
#: Pixels of a name that has room for the comparison beside it, in the narrowest window.
MOST_BESIDE = 88


class ConditionRow(QWidget):
    """Shows and changes one test.

    Signals:
        changed: The test is another one now; whether the hand is still on it.
        resourced: Another thing is to be tested: the id of a feature, or a source that is not a feature yet.
        removed: The test is not wanted.
        settled: The hand let go.
    """

    changed = Signal(object)
    resourced = Signal(object)
    removed = Signal()
    settled = Signal()

    def __init__(
        self,
        condition: Condition,
        use: FeatureUse,
        feature: Feature,
        words: tuple[str, str],
        uses: list[Choice],
        others: list[Choice],
    ) -> None:
        """Show a test.

        Args:
            words: What is said where a boolean feature is true, and where it is not.
            uses: Ids of features by their names.
            others: Sources that are no features yet.
        """
        super().__init__()
        self._condition, self._feature, self._words = condition, feature, words
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        first, self._layout = QHBoxLayout(), QHBoxLayout()
        column.addLayout(first)
        self.what = ListChoice()
        self.what.setAccessibleName("What is tested")
        self.what.setToolTip("What is tested; below the line is what the automaton does not look at yet")
        self._offer(uses, others, use)
        first.addWidget(self.what, 2)
        self.how = ListChoice()
        self.how.setAccessibleName("Comparison")
        self.how.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.how.setMinimumContentsLength(6)
        self._layout.addWidget(self.how, 2)
        self.numbers: list[NumberField] = []
        self._fill()
        if isinstance(condition.test, InArc) or self._is_long(use.shown):  # too much for one line
            self._layout.setContentsMargins(24, 0, 0, 0)
            column.addLayout(self._layout)
        else:
            first.addLayout(self._layout, 3)
        first.addWidget(self._remove_button())
        self.what.activated.connect(self._what_chosen)

    def _remove_button(self) -> QToolButton:
        remove = QToolButton()
        remove.setText("✕")
        remove.setProperty("flat", "true")
        remove.setToolTip("Remove this test")
        remove.setAccessibleName("Remove this test")
        remove.clicked.connect(self.removed)
        return remove

    def _is_long(self, name: str) -> bool:
        """Whether what is tested would be cut off beside the comparison."""
        return self.fontMetrics().horizontalAdvance(name) > MOST_BESIDE

    def _offer(self, uses: list[Choice], others: list[Choice], use: FeatureUse) -> None:
        for name, value in uses:
            self.what.addItem(name, value)
        if others:
            self.what.insertSeparator(self.what.count())
        for name, value in others:
            self.what.addItem(name, value)
        self.what.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.what.setMinimumContentsLength(8)
        self.what.setMaxVisibleItems(18)
        self.what.setCurrentIndex(max(0, [value for _, value in uses].index(use.id)))

    def _what_chosen(self, place: int) -> None:
        chosen: str | Source | None = self.what.itemData(place)
        if chosen is not None and chosen != self._condition.test.feature:
            self.resourced.emit(chosen)

    # -------------------------------------------------------------------------------------- kinds of feature

    def _fill(self) -> None:
        test, wanted = self._condition.test, self._condition.wanted
        match test:
            case Equals(_, value) if self._feature.kind is FeatureKind.CATEGORICAL:
                self._choose([("is", True), ("is not", False)], wanted)
                self._categories(value)
            case Equals(_, value):
                is_true = (value != 0.0) == wanted
                self._choose([(self._words[0], True), (self._words[1], False)], is_true)
            case AtMost(_, threshold):
                self._choose([("at most", True), ("more than", False)], wanted)
                self._number(threshold)
            case InArc(_, start, end):
                self._choose([("between", True), ("not between", False)], wanted)
                self._number(start, "From, counterclockwise")
                self._layout.addWidget(QLabel("and"))
                self._number(end, "To, counterclockwise")
        self.how.activated.connect(lambda _: self._said(still=False))

    def _choose(self, choices: list[tuple[str, bool]], chosen: bool) -> None:  # noqa: FBT001 - a value, not a switch
        for name, value in choices:
            self.how.addItem(name, value)
        self.how.setCurrentIndex([value for _, value in choices].index(chosen))

    def _categories(self, value: float) -> None:
        self.category = ListChoice()
        self.category.setAccessibleName("Category")
        for number, name in enumerate(self._feature.categories):
            self.category.addItem(name, float(number))
        self.category.setCurrentIndex(self.category.findData(value))
        self.category.activated.connect(lambda _: self._said(still=False))
        self._layout.addWidget(self.category, 1)

    def _number(self, value: float, name: str = "Threshold") -> None:
        field = NumberField(name, *self._range())
        field.setValue(degrees(value) if in_degrees(self._feature) else value)
        self._name_unit(field)
        field.valueChanged.connect(lambda _: self._name_unit(field))
        field.valueChanged.connect(lambda _: self._said(still=True))
        field.editingFinished.connect(self.settled)
        self._layout.addWidget(field, 2)
        self.numbers.append(field)

    def _name_unit(self, field: NumberField) -> None:
        """Say the unit after the number: 1 unit, 2 units."""
        unit = unit_of(self._feature, field.textFromValue(field.value()))
        field.setSuffix("°" if in_degrees(self._feature) else f" {unit}" if unit else "")

    def _range(self) -> tuple[float, float]:
        if self._feature.kind is not FeatureKind.TOROIDAL:
            return -FARTHEST, FARTHEST
        half = self._feature.period / 2
        return (-180.0, 180.0) if in_degrees(self._feature) else (-half, half)

    # ----------------------------------------------------------------------------------------------- saying it

    @property
    def condition(self) -> Condition:
        """The test as it stands in the row."""
        test, said = self._condition.test, bool(self.how.currentData())
        match test:
            case Equals() if self._feature.kind is FeatureKind.CATEGORICAL:
                return Condition(replace(test, value=float(self.category.currentData())), said)
            case Equals():
                return Condition(replace(test, value=1.0), said)
            case AtMost():
                return Condition(replace(test, threshold=self._value(0, test.threshold)), said)
        start, end = self._value(0, test.start), self._value(1, test.end)
        half = self._feature.period / 2
        return Condition(replace(test, start=start, end=-half if end >= half else end), said)

    def _value(self, number: int, before: float) -> float:
        """What a field says; what it cannot show more exactly stays as it was."""
        field = self.numbers[number]
        shown = degrees(before) if in_degrees(self._feature) else before
        if field.is_still(shown):
            return before
        return radians(field.value()) if in_degrees(self._feature) else field.value()

    def _said(self, *, still: bool) -> None:
        if self.condition != self._condition:
            self._condition = self.condition
            self.changed.emit(still)
