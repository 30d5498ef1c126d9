"""The parameters of a scenario as a form: units, ranges and docs, and which values are set here or come from elsewhere."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import Field, dataclass
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QGridLayout,
    QLabel,
    QLineEdit,
    QScrollArea,
    QSpinBox,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ...core.amounts import exact
from ...core.project import Value
from ...sim.parameters import default
from ..icons import icon
from ..number_box import RealBox, roomy
from ..searching import has_words, words_in
from .buttons import stand_back

if TYPE_CHECKING:
    from ..theme import Theme

Editor = QCheckBox | QComboBox | QDoubleSpinBox | QSpinBox
#: Where a parameter has no bound of its own.
MOST, MOST_WHOLE = 1e9, 2**31 - 1


@dataclass(frozen=True, slots=True)
class _Row:
    label: QLabel
    editor: Editor
    clear: QToolButton


class ParameterForm(QWidget):
    """One row a parameter; the rows are made when somebody looks at them first, since that takes a while.

    Attributes:
        filter: Words that a parameter's name or doc has to have.

    Signals:
        changed: The user set a parameter: its name, and the value or None for "as elsewhere".
        settled: The user has let go of it.
    """

    changed = Signal(str, object)
    settled = Signal()

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self._fields: Mapping[str, Field[Any]] = {}
        self._rows: dict[str, _Row] = {}
        self._own: Mapping[str, Value] = {}
        self._elsewhere: Mapping[str, Value] = {}
        self._is_late = False
        self.filter = QLineEdit()
        self.filter.setPlaceholderText("Filter parameters")
        self.filter.setAccessibleName("Filter parameters")
        self.filter.setClearButtonEnabled(True)
        self.filter.textChanged.connect(self._filtered)
        self._area = QScrollArea()
        self._area.setWidgetResizable(True)
        self._area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.filter)
        column.addWidget(self._area, 1)
        theme.changed.connect(self._dress)

    def show_parameters(
        self, fields: Mapping[str, Field[Any]], own: Mapping[str, Value], elsewhere: Mapping[str, Value]
    ) -> None:
        """Show these parameters.

        Args:
            own: The values that are set here.
            elsewhere: The values that hold where none is set here.
        """
        if dict(fields) != dict(self._fields):
            self._fields, self._rows = fields, {}
        self._own, self._elsewhere = own, elsewhere
        self._is_late = not self.isVisible()
        if not self._is_late:
            self._show()

    def showEvent(self, event: QShowEvent) -> None:
        """Show what has come since it was seen last."""
        super().showEvent(event)
        if self._is_late:
            self._is_late = False
            self._show()

    def _show(self) -> None:
        if not self._rows:
            self._build()
        fields, own, elsewhere = self._fields, self._own, self._elsewhere
        for name, row in self._rows.items():
            _put(row.editor, own.get(name, elsewhere.get(name, default(fields[name]))))
            here = name in own
            font = row.label.font()
            font.setBold(here)
            row.label.setFont(font)
            row.clear.setEnabled(here)
            came = elsewhere.get(name, default(fields[name]))
            row.clear.setToolTip(f"Back to {came}, as it is elsewhere" if here else "As it is elsewhere")

    def editor(self, name: str) -> Editor:
        """The field of a parameter."""
        return self._rows[name].editor

    def clear_button(self, name: str) -> QToolButton:
        """The button that takes a value back."""
        return self._rows[name].clear

    # ------------------------------------------------------------------------------------------ building

    def _build(self) -> None:
        inside = QWidget()
        grid = QGridLayout(inside)
        grid.setColumnStretch(1, 1)
        grid.setVerticalSpacing(6)
        self._rows = {}
        for at, (name, declared) in enumerate(self._fields.items()):
            row = self._made(name, declared)
            for column, part in enumerate((row.label, row.editor, row.clear)):
                grid.addWidget(part, at, column)
            self._rows[name] = row
        grid.setRowStretch(len(self._rows), 1)
        self._area.setWidget(inside)
        self._dress()
        self._filtered()

    def _made(self, name: str, declared: Field[Any]) -> _Row:
        unit = declared.metadata["unit"]
        label = QLabel(f"{name}, {unit}" if unit else name)
        editor = self._editor(name, declared)
        tip = explained(declared)
        label.setToolTip(tip)
        editor.setToolTip(tip)
        editor.setAccessibleName(name)
        clear = QToolButton()
        clear.setProperty("flat", "true")
        clear.setAccessibleName(f"Take {name} from elsewhere")
        clear.clicked.connect(lambda: self.changed.emit(name, None))
        stand_back(clear)
        return _Row(label, editor, clear)

    def _editor(self, name: str, declared: Field[Any]) -> Editor:
        low, high = declared.metadata["low"], declared.metadata["high"]
        if choices := declared.metadata["choices"]:
            box = QComboBox()
            box.addItems(choices)
            box.activated.connect(lambda: self._set(name, box.currentText()))
            return box
        if isinstance(declared.default, bool):
            check = QCheckBox()
            check.clicked.connect(lambda on: self._set(name, on))
            return check
        if isinstance(declared.default, int):
            whole = roomy(QSpinBox())
            whole.setRange(
                -MOST_WHOLE if low is None else max(-MOST_WHOLE, int(low)),
                MOST_WHOLE if high is None else min(MOST_WHOLE, int(high)),
            )
            self._connect(name, whole)
            return whole
        real = roomy(RealBox(decimals=4))
        real.setRange(-MOST if low is None else low, MOST if high is None else high)
        real.setStepType(QDoubleSpinBox.StepType.AdaptiveDecimalStepType)
        self._connect(name, real)
        return real

    def _connect(self, name: str, box: QSpinBox | QDoubleSpinBox) -> None:
        box.setKeyboardTracking(False)
        box.valueChanged.connect(lambda value: self._set(name, value))
        box.editingFinished.connect(self.settled)
        box.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def _set(self, name: str, value: Value) -> None:
        self.changed.emit(name, value)

    def _dress(self) -> None:
        for row in self._rows.values():
            row.clear.setIcon(icon("restore", self._theme))

    def _filtered(self) -> None:
        wanted = words_in(self.filter.text())
        for name, row in self._rows.items():
            found = has_words(wanted, name.replace("_", " "), name, self._fields[name].metadata["doc"])
            for part in (row.label, row.editor, row.clear):
                part.setVisible(found)


def said(value: Value) -> str:
    """A value of a parameter, for people."""
    return str(value) if isinstance(value, bool | str) else exact(value)


def explained(declared: Field[Any]) -> str:
    """The doc of a parameter, with its range and default."""
    low, high, unit = (declared.metadata[key] for key in ("low", "high", "unit"))
    words = [declared.metadata["doc"]]
    if low is not None and high is not None:
        words.append(f"allowed: {exact(low)} to {exact(high)} {unit}".strip())
    elif low is not None or high is not None:
        bound = f"from {exact(low)}" if low is not None else f"up to {exact(high)}"
        words.append(f"allowed: {bound} {unit}".strip())
    words.append(f"by default {said(default(declared))}")
    return "\n".join(word for word in words if word)


def _put(editor: Editor, value: Value) -> None:
    """Show a value without telling anybody."""
    editor.blockSignals(True)
    match editor:
        case QCheckBox():
            editor.setChecked(bool(value))
        case QComboBox():
            editor.setCurrentText(str(value))
        case QSpinBox():
            editor.setValue(int(value))
        case QDoubleSpinBox():
            editor.setValue(float(value))
    editor.blockSignals(False)
