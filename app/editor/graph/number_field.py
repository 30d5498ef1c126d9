"""A number that is shown as people write it, and kept as exactly as it was typed."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QDoubleSpinBox, QSizePolicy

from ..number_box import roomy

#: Decimals that are kept, and those that are shown.
KEPT, SHOWN = 12, 4


class NumberField(QDoubleSpinBox):
    """Takes a number, with its unit; it tells of it once it is typed to its end."""

    def __init__(self, name: str, low: float, high: float, suffix: str = "") -> None:
        super().__init__()
        roomy(self)
        self.setAccessibleName(name)
        self.setToolTip(name)
        self.setDecimals(KEPT)
        self.setRange(low, high)
        self.setSuffix(suffix)
        self.setStepType(QDoubleSpinBox.StepType.AdaptiveDecimalStepType)
        self.setKeyboardTracking(False)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumWidth(76)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)

    def textFromValue(self, value: float) -> str:
        """As few digits as say it."""
        text = f"{value:.{SHOWN}f}" if abs(value) >= 0.01 or value == 0.0 else f"{value:.{KEPT}f}"
        return text.rstrip("0").rstrip(".")

    def is_still(self, value: float) -> bool:
        """Whether it shows *value*, as far as it is kept."""
        return abs(self.value() - value) <= 10.0**-KEPT

    def wheelEvent(self, event: QWheelEvent) -> None:
        """The wheel scrolls the form."""
        event.ignore()
