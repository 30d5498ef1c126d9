"""Boxes for numbers."""

from typing import TypeVar

from PySide6.QtWidgets import QAbstractSpinBox, QDoubleSpinBox

#: Pixels before the number: those of a text field, which a style sheet cannot give to a spin box.
ROOM = 7

Box = TypeVar("Box", bound=QAbstractSpinBox)


class RealBox(QDoubleSpinBox):
    """A number that is shown with as few digits as say it."""

    def textFromValue(self, value: float) -> str:
        """See above."""
        text, point = super().textFromValue(value), self.locale().decimalPoint()
        return text.rstrip("0").removesuffix(point) if point in text else text


def roomy(box: Box) -> Box:
    """The same box, its number as far from the edge as the words of other fields."""
    box.lineEdit().setTextMargins(ROOM, 0, 0, 0)
    return box
