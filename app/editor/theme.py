"""How the window looks: Fusion with our palette on every platform, light or dark, and a few lines of style."""

from enum import StrEnum
from pathlib import Path

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QColor, QFont, QPalette
from PySide6.QtWidgets import QApplication

from ..engine.shipped import shipped_folder
from .palette import DARK, LIGHT, Palette

#: Pixels of text and of captions.
TEXT, CAPTION = 13, 11
#: The layout of buttons in which the one that accepts stands last, where the eye ends, on every platform (Qt's number).
ACCEPT_LAST = 3
#: Where the arrows of boxes are.
ARROWS = Path("resources", "icons")


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
        application.setStyle("Fusion")
        application.setFont(text_font())
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

    def _apply(self) -> None:
        palette = self.palette
        self._application.setPalette(qt_palette(palette))
        self._application.setStyleSheet(style_sheet(palette))
        self.changed.emit()


def text_font(pixels: int = TEXT, *, bold: bool = False) -> QFont:
    """The font of the window."""
    font = QFont("sans-serif")
    font.setPixelSize(pixels)
    font.setWeight(QFont.Weight.DemiBold if bold else QFont.Weight.Normal)
    return font


def qt_palette(colors: Palette) -> QPalette:
    """Our colors in Qt's roles."""
    palette = QPalette()
    role = QPalette.ColorRole
    for which, color in {
        role.Window: colors.panel,
        role.WindowText: colors.text,
        role.Base: colors.raised,
        role.AlternateBase: colors.panel,
        role.Text: colors.text,
        role.PlaceholderText: colors.dim,
        role.Button: colors.raised,
        role.ButtonText: colors.text,
        role.BrightText: colors.teach,
        role.ToolTipBase: colors.raised,
        role.ToolTipText: colors.text,
        role.Highlight: colors.accent,
        role.Accent: colors.accent,
        role.HighlightedText: "#ffffff" if colors is LIGHT else "#10131a",
        role.Link: colors.accent,
        role.Mid: colors.hairline,
        role.Midlight: colors.hairline,
        role.Dark: colors.hairline,
        role.Light: colors.raised,
        role.Shadow: colors.background,
    }.items():
        palette.setColor(which, QColor(color))
    for which in (role.WindowText, role.Text, role.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, which, mixed(colors.dim, colors.panel, 0.35))
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


def chosen_ground(colors: Palette) -> QColor:
    """What lies under a row that is chosen: seen at a glance, dim text on it can still be read."""
    return mixed(colors.accent, colors.panel, 0.86)


def hovered_ground(colors: Palette) -> QColor:
    """What lies under a row that the mouse is on."""
    return mixed(colors.accent, colors.panel, 0.94)


def style_sheet(colors: Palette) -> str:
    """What a palette cannot say: hairlines instead of frames, rounded controls, flat tool bars."""
    hover = mixed(colors.accent, colors.raised, 0.86).name()
    chosen = chosen_ground(colors).name()
    handle = mixed(colors.dim, colors.panel, 0.6).name()
    off = mixed(colors.dim, colors.panel, 0.45).name()
    check = f"{shipped_folder(ARROWS).as_posix()}/check-{'light' if colors is LIGHT else 'dark'}.svg"
    arrow = f"{shipped_folder(ARROWS).as_posix()}/chevron-{{}}-{'light' if colors is LIGHT else 'dark'}.svg"
    return f"""
QMainWindow, QMenuBar, QStatusBar {{ background: {colors.background}; }}
QMenuBar {{ padding: 2px 4px; }}
QMenuBar::item {{ background: transparent; padding: 5px 8px; border-radius: 5px; }}
QMenuBar::item:selected {{ background: {chosen}; }}
QDockWidget > QWidget, QDialog {{ background: {colors.panel}; }}
QMainWindow::separator {{ background: {colors.hairline}; width: 2px; height: 2px; }}
QMainWindow::separator:hover {{ background: {colors.accent}; }}
QStatusBar::item {{ border: none; }}
QToolBar {{ background: {colors.background}; border: none; border-bottom: 1px solid {colors.hairline};
    padding: 6px 8px; spacing: 5px; }}
QToolBar::separator {{ background: {colors.hairline}; width: 1px; margin: 5px 3px; }}
QToolBar QToolButton {{ padding: 4px 7px; }}
QToolBar #qt_toolbar_ext_button {{ padding: 0; border: none; background: transparent; }}
QToolTip {{ background: {colors.raised}; color: {colors.text}; border: 1px solid {colors.hairline}; padding: 4px; }}
QPushButton, QToolButton, QComboBox, QSpinBox, QDoubleSpinBox, QLineEdit {{ border: 1px solid {colors.hairline};
    border-radius: 6px; padding: 3px 8px; background: {colors.raised}; }}
QAbstractSpinBox QLineEdit, QComboBox QLineEdit {{ border: none; padding: 0; background: transparent; }}
QListWidget QLineEdit {{ border: none; border-radius: 0; padding: 0 3px; }}
QPushButton:hover, QToolButton:hover, QComboBox:hover {{ background: {hover}; }}
QPushButton:focus, QToolButton:focus, QComboBox:focus, QSpinBox:focus, QDoubleSpinBox:focus, QLineEdit:focus {{
    border-color: {colors.accent}; }}
QPushButton:checked, QToolButton:checked {{ background: {chosen}; border-color: {colors.accent}; }}
QPushButton:disabled, QToolButton:disabled, QSpinBox:disabled, QDoubleSpinBox:disabled {{ background: {colors.panel}; }}
QSplitter::handle:horizontal {{ background: {colors.hairline}; width: 5px; margin: 0 2px; }}
QSplitter::handle:vertical {{ background: {colors.hairline}; height: 5px; margin: 2px 0; }}
QToolButton[flat="true"] {{ border: none; background: transparent; padding: 3px; }}
QToolButton[flat="true"]:hover {{ background: {hover}; }}
QComboBox QAbstractItemView, #completions {{ background: {colors.raised}; border: 1px solid {colors.hairline}; }}
QComboBox {{ selection-background-color: {chosen}; selection-color: {colors.text}; }}
QComboBoxPrivateContainer {{ border: none; }}
QInputDialog {{ min-width: 340px; }}
QDialogButtonBox {{ dialogbuttonbox-buttons-have-icons: 0; button-layout: {ACCEPT_LAST}; }}
QComboBox::drop-down {{ border: none; width: 20px; }}
QComboBox::down-arrow {{ image: url("{arrow.format("down")}"); width: 12px; height: 12px; }}
QSpinBox, QDoubleSpinBox {{ padding-right: 18px; }}
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button {{ border: none; background: transparent; width: 18px; }}
QAbstractSpinBox::up-arrow {{ image: url("{arrow.format("up")}"); width: 10px; height: 10px; }}
QAbstractSpinBox::down-arrow {{ image: url("{arrow.format("down")}"); width: 10px; height: 10px; }}
QToolButton[popupMode="2"] {{ padding-right: 18px; }}
QToolButton::menu-indicator {{ image: url("{arrow.format("down")}"); width: 10px; height: 10px;
    subcontrol-position: right center; right: 5px; }}
QTreeView {{ selection-background-color: {chosen}; selection-color: {colors.text}; }}
QTreeView::branch:has-children:closed {{ image: url("{arrow.format("right")}"); }}
QTreeView::branch:has-children:open {{ image: url("{arrow.format("down")}"); }}
QAbstractScrollArea::corner {{ background: transparent; border: none; }}
QScrollBar:vertical {{ background: transparent; width: 10px; margin: 0; }}
QScrollBar:horizontal {{ background: transparent; height: 10px; margin: 0; }}
QScrollBar::handle {{ background: {handle}; border-radius: 3px; margin: 2px; }}
QScrollBar::handle:vertical {{ min-height: 24px; }}
QScrollBar::handle:horizontal {{ min-width: 24px; }}
QScrollBar::add-line, QScrollBar::sub-line {{ width: 0; height: 0; }}
QScrollBar::add-page, QScrollBar::sub-page {{ background: transparent; }}
QMenu {{ background: {colors.raised}; border: 1px solid {colors.hairline}; padding: 4px; }}
QMenu::item {{ padding: 5px 24px 5px 10px; border-radius: 4px; }}
QMenu::item:selected {{ background: {chosen}; color: {colors.text}; }}
QMenu::item:disabled {{ color: {off}; }}
QMenu::separator {{ background: {colors.hairline}; height: 1px; margin: 4px 6px; }}
QMenu::icon {{ padding-left: 8px; }}
QTreeView, QTableView, QListView, QScrollArea, QPlainTextEdit, QTextBrowser {{ border: none;
    background: {colors.panel}; }}
QTreeView::item, QListView::item {{ padding: 3px 2px; }}
QTreeView::item:selected, QTableView::item:selected, QListView::item:selected {{ background: {chosen};
    color: {colors.text}; }}
QCheckBox::indicator, QListView::indicator, QTableView::indicator, QTreeView::indicator {{
    width: 12px; height: 12px; border: 1px solid {colors.dim}; border-radius: 4px; background: {colors.raised}; }}
QCheckBox::indicator:checked, QListView::indicator:checked, QTableView::indicator:checked, QTreeView::indicator:checked {{
    border-color: {colors.accent}; background: {colors.accent}; image: url("{check}"); }}
QCheckBox::indicator:disabled {{ border-color: {colors.hairline}; background: {colors.panel}; }}
QCheckBox::indicator:checked:disabled {{ background: {handle}; }}
QCheckBox::indicator:focus {{ border-color: {colors.accent}; }}
QHeaderView::section {{ background: {colors.panel}; color: {colors.dim}; border: none;
    border-bottom: 1px solid {colors.hairline}; padding: 4px 6px; }}
QTabBar::tab {{ background: transparent; color: {colors.dim}; padding: 6px 10px; border: none;
    border-bottom: 2px solid transparent; }}
QTabBar::tab:selected {{ color: {colors.text}; border-bottom: 2px solid {colors.accent}; }}
QTabBar::tab:hover {{ color: {colors.text}; }}
QTabBar::tab:selected:focus {{ background: {chosen}; }}
QSlider::groove:horizontal {{ height: 4px; border-radius: 2px; background: {colors.hairline}; }}
QSlider::sub-page:horizontal {{ border-radius: 2px; background: {colors.accent}; }}
QSlider::handle:horizontal {{ width: 12px; margin: -5px 0; border-radius: 7px; background: {colors.accent};
    border: 1px solid {colors.accent}; }}
QSlider::handle:horizontal:hover {{ background: {hover}; }}
QSlider::handle:horizontal:focus {{ background: {colors.raised}; border: 2px solid {colors.accent}; width: 10px; }}
QSlider::sub-page:horizontal:disabled {{ background: {handle}; }}
QSlider::handle:horizontal:disabled {{ background: {colors.panel}; border-color: {handle}; }}
QTableView, QTreeView, QListView {{ outline: none; }}
QDockWidget {{ titlebar-close-icon: none; titlebar-normal-icon: none; font-weight: 600; }}
QPlainTextEdit[role="details"] {{ background: {colors.raised}; border: 1px solid {colors.hairline};
    border-radius: 6px; padding: 4px; }}
QLabel[role="caption"] {{ color: {colors.dim}; font-size: {CAPTION}px; }}
QLabel[role="empty"] {{ color: {colors.dim}; }}
QLabel[role="title"] {{ font-weight: 600; }}
QFrame[role="hairline"] {{ background: {colors.hairline}; border: none; }}
""".strip()
