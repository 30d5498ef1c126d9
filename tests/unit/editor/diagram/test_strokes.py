"""Texts of diagrams in the room that they have."""

import pytest
from PySide6.QtWidgets import QApplication

from app.editor.diagram.strokes import text_width, wrapped
from app.editor.theme import CAPTION


@pytest.mark.parametrize("bold", [False, True])
@pytest.mark.parametrize("width", [60.0, 94.0, 130.0])
def test_wrapped_lines_fit_as_they_are_painted(qapp: QApplication, width: float, *, bold: bool) -> None:
    for line in wrapped("Goto(closest attached agent)", width, 2, CAPTION, bold=bold):
        assert text_width(line, CAPTION, bold=bold) <= width
