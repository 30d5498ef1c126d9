"""How the window looks: Fusion with our palette on every platform, light or dark, and a few lines of style."""

from enum import StrEnum
from functools import cache

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QColor, QFont, QPalette
from PySide6.QtWidgets import QApplication, QWidget

from .palette import DARK, LIGHT, Palette
from .restyling import Restyling
from .style_sheet import (
    CHOSEN_ROLE,
    DARK_GROUND,
    GROUND,
    HANDLE_ROLE,
    HOVERED_ROLE,
    OFF_ROLE,
    style_sheet,
)

#: Pixels of text and of captions.
TEXT, CAPTION = 13, 11


class ThemeMode(StrEnum):
    """What the user asked for."""

    SYSTEM = "system"
    LIGHT = "light"
    DARK = "dark"


class Theme(QObject):
    """The palette that is in force.

    Attributes:
        mode: What the user asked for.

    Signals:
        changed: Whoever paints by hand has to paint again.
    """

    changed = Signal()

    def __init__(self, application: QApplication, mode: ThemeMode = ThemeMode.SYSTEM) -> None:
        super().__init__()
        self._application = application
        self.mode = mode
        self._restyling = Restyling(self)
        if not application.styleSheet():  # otherwise another window has it already
            application.setStyle("Fusion")
            application.setFont(text_font())
            application.setStyleSheet(style_sheet(CAPTION))
        application.styleHints().colorSchemeChanged.connect(self._system_changed)
        self._apply()

    @property
    def is_dark(self) -> bool:
        """Whether the palette is the dark one."""
        if self.mode is ThemeMode.SYSTEM:
            return self._application.styleHints().colorScheme() is Qt.ColorScheme.Dark
        return self.mode is ThemeMode.DARK

    @property
    def palette(self) -> Palette:
        """The colors in force."""
        return DARK if self.is_dark else LIGHT

    @property
    def is_restyling(self) -> bool:
        """Whether something that nobody sees has other colors still."""
        return self._restyling.is_under_way

    def color(self, name: str) -> QColor:
        """A color of the palette by the name of its field."""
        return QColor(getattr(self.palette, name))

    def use(self, mode: ThemeMode) -> None:
        """Look like this from now on."""
        if mode is not self.mode:
            self.mode = mode
            self._apply()

    def _system_changed(self) -> None:
        if self.mode is ThemeMode.SYSTEM:
            self._apply()

    def dress(self, window: QWidget) -> None:
        """Let what is drawn by pictures in a window, and in all that belongs to it, stand out from its ground."""
        window.setProperty(GROUND, DARK_GROUND if self.is_dark else None)

    def _apply(self) -> None:
        palette = qt_palette(self.palette)
        if palette != self._application.palette():  # all windows have one, and each has a theme
            self._application.setPalette(palette)
            for window in self._application.topLevelWidgets():
                self.dress(window)
            self._restyling.begin(self._application.allWidgets())
        self.changed.emit()


@cache
def text_font(pixels: int = TEXT, *, bold: bool = False) -> QFont:
    """The font of the window; nobody may change what comes."""
    font = QFont("sans-serif")
    font.setPixelSize(pixels)
    font.setWeight(QFont.Weight.DemiBold if bold else QFont.Weight.Normal)
    return font


def qt_palette(colors: Palette) -> QPalette:
    """Our colors in Qt's roles."""
    palette = QPalette()
    role, off = QPalette.ColorRole, off_words(colors)
    for which, color in {
        role.Window: colors.panel,
        role.WindowText: colors.text,
        role.Base: colors.raised,
        role.Text: colors.text,
        role.PlaceholderText: colors.dim,
        role.Button: colors.raised,
        role.ButtonText: colors.text,
        role.ToolTipBase: colors.raised,
        role.ToolTipText: colors.text,
        role.Highlight: colors.accent,
        role.Accent: colors.accent,
        role.HighlightedText: "#ffffff" if colors is LIGHT else "#10131a",
        role.Link: colors.accent,
        role.Mid: colors.hairline,
        role.Dark: colors.hairline,
        role.Light: colors.raised,
        role.Shadow: colors.background,
        HOVERED_ROLE: mixed(colors.accent, colors.raised, 0.9),
        CHOSEN_ROLE: chosen_ground(colors),
        HANDLE_ROLE: mixed(colors.dim, colors.panel, 0.6),
        OFF_ROLE: off,
    }.items():
        palette.setColor(which, QColor(color))
    for which in (role.WindowText, role.Text, role.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, which, off)
    for which in (role.Highlight, role.Accent):
        palette.setColor(QPalette.ColorGroup.Disabled, which, mixed(colors.dim, colors.panel, 0.6))
    return palette


def mixed(color: str, ground: str, share: float) -> QColor:
    """*color* with *share* of *ground* mixed in."""
    a, b = QColor(color), QColor(ground)
    return QColor.fromRgbF(
        a.redF() * (1 - share) + b.redF() * share,
        a.greenF() * (1 - share) + b.greenF() * share,
        a.blueF() * (1 - share) + b.blueF() * share,
    )


def off_words(colors: Palette) -> QColor:
    """Words for what is not possible now: fainter than any others, and still to be read."""
    return mixed(colors.dim, colors.panel, 0.28)


def chosen_ground(colors: Palette) -> QColor:
    """What lies under a row that is chosen: seen at a glance, dim text on it can still be read."""
    return mixed(colors.accent, colors.panel, 0.88)


def hovered_ground(colors: Palette) -> QColor:
    """What lies under a row that the mouse is on."""
    return mixed(colors.accent, colors.panel, 0.94)
