"""Icons look as their family draws them, and are drawn once for all times that they are painted."""

import pytest
import qtawesome
from PySide6.QtCore import QSize
from PySide6.QtGui import QIcon, QImage, QPainter
from PySide6.QtWidgets import QApplication

from app.editor.icons import icon
from app.editor.theme import Theme, ThemeMode, off_words

SIZE = QSize(16, 16)


@pytest.fixture
def theme(qapp: QApplication) -> Theme:
    return Theme(qapp, ThemeMode.LIGHT)


def painted(shown: QIcon, ratio: float) -> QImage:
    image = QImage(SIZE * ratio, QImage.Format.Format_ARGB32_Premultiplied)
    image.setDevicePixelRatio(ratio)
    image.fill(0)
    painter = QPainter(image)
    shown.paint(painter, 0, 0, SIZE.width(), SIZE.height())
    painter.end()
    return image


@pytest.mark.parametrize("ratio", [1.0, 2.0])
@pytest.mark.parametrize("mode", list(QIcon.Mode))
def test_an_icon_looks_as_in_its_family(theme: Theme, mode: QIcon.Mode, ratio: float) -> None:
    off = off_words(theme.palette)
    family = qtawesome.icon("mdi6.play", color=theme.color("accent"), color_disabled=off)
    ours = icon("play", theme, "accent")
    assert ours.pixmap(SIZE, ratio, mode).toImage() == family.pixmap(SIZE, ratio, mode).toImage()


@pytest.mark.parametrize("ratio", [1.0, 2.0])
def test_what_is_painted_is_the_picture_of_the_icon(theme: Theme, ratio: float) -> None:
    ours = icon("play", theme)
    assert painted(ours, ratio).convertToFormat(QImage.Format.Format_ARGB32) == ours.pixmap(
        SIZE, ratio
    ).toImage().convertToFormat(QImage.Format.Format_ARGB32)


def test_an_icon_is_drawn_once_for_each_size(theme: Theme, monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list[str] = []
    ours = icon("play", theme)
    draw = qtawesome.iconic_font.CharIconPainter.paint

    def counted(*given: object) -> None:
        drawn.append("once more")
        draw(*given)

    monkeypatch.setattr(qtawesome.iconic_font.CharIconPainter, "paint", counted)
    for _ in range(5):
        painted(ours, 1.0)
    assert len(drawn) == 1
    painted(ours, 2.0)
    assert len(drawn) == 2
