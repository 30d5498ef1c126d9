"""The pruning confidence as a slider; what it would do is shown while it is dragged."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QFocusEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSlider, QVBoxLayout, QWidget

from ..forms.parts import caption

#: The slider counts percent; 0 is off.
MOST = 50
CANNOT = "Only decision trees can be pruned, and this behavior learns otherwise."
EXPLAINED = "The smaller the confidence, the more is pruned; 25% is usual. Off keeps every test."


class ConfidencePage(QWidget):
    """Sets how strongly trees are pruned.

    Signals:
        dragged: A confidence to be previewed, None for off.
        dropped: The confidence to be kept.
        stepped: The same by keys.
        settled: The hand let go of the keys.
    """

    dragged = Signal(object)
    dropped = Signal(object)
    stepped = Signal(object)
    settled = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.slider = _Slider(self)
        self.slider.setRange(0, MOST)
        self.slider.setPageStep(5)
        self.slider.setAccessibleName("Pruning confidence in percent; 0 is off")
        self.slider.setToolTip("How strongly trees are pruned after learning; 0 keeps them whole")
        self._value = QLabel()
        self._value.setMinimumWidth(36)
        self._told = caption("")
        row = QHBoxLayout()
        row.addWidget(QLabel("Pruning confidence"))
        row.addWidget(self.slider, 1)
        row.addWidget(self._value)
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 0, 8, 4)
        column.addLayout(row)
        column.addWidget(self._told, 1)
        self.setFocusProxy(self.slider)
        self.slider.valueChanged.connect(self._changed)
        self.slider.sliderReleased.connect(lambda: self.dropped.emit(self.confidence))

    @property
    def confidence(self) -> float | None:
        """What the slider says; None for off."""
        percent = self.slider.value()
        return percent / 100.0 if percent else None

    def show_confidence(self, confidence: float | None, *, possible: bool) -> None:
        """Show what is in force, unless the hand is on the slider."""
        self.setEnabled(possible)
        if not self.slider.isSliderDown():
            with QSignalBlocker(self.slider):
                self.slider.setValue(round(100 * confidence) if confidence is not None else 0)
            self._say()
            self.tell(EXPLAINED if possible else CANNOT)

    def tell(self, text: str) -> None:
        """Say what it does or would do."""
        self._told.setText(text)

    def _say(self) -> None:
        self._value.setText(f"{self.slider.value()}%" if self.slider.value() else "off")

    def _changed(self, _percent: int) -> None:
        self._say()
        if self.slider.isSliderDown():
            self.dragged.emit(self.confidence)
        else:
            self.stepped.emit(self.confidence)


class _Slider(QSlider):
    """Tells when the keys are let go of."""

    def __init__(self, page: ConfidencePage) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self._page = page

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """What was set by keys was one step."""
        self._page.settled.emit()
        super().focusOutEvent(event)
