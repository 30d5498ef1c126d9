"""The style sheet: what a palette cannot say; and the roles of the palette in which it finds our colors.

It is the same for every theme: whoever sets another sheet has Qt style each widget as often as it lies deep, in one go.
"""

from pathlib import Path

from PySide6.QtGui import QPalette

from ..engine.shipped import shipped_folder

#: The property of windows by which pictures know on what ground they are, and its value on a dark one.
GROUND, DARK_GROUND = "ground", "dark"
#: The layout of buttons in which the one that accepts stands last, where the eye ends, on every platform (Qt's number).
ACCEPT_LAST = 3
#: Where the arrows of boxes are.
ARROWS = Path("resources", "icons")
#: What is drawn by pictures, since a sheet cannot draw it: the picture and where it is.
PICTURES = {
    "chevron-down": (
        "QComboBox::down-arrow",
        "QAbstractSpinBox::down-arrow",
        "QToolButton::menu-indicator",
        "QTreeView::branch:has-children:open",
    ),
    "chevron-up": ("QAbstractSpinBox::up-arrow",),
    "chevron-right": ("QTreeView::branch:has-children:closed", "QMenu::right-arrow"),
    "check": (
        "QCheckBox::indicator:checked",
        "QListView::indicator:checked",
        "QTableView::indicator:checked",
        "QTreeView::indicator:checked",
    ),
    "tick": ("QMenu::indicator:checked",),
}
Role = QPalette.ColorRole
#: Our colors by the roles that Qt's own painting has for them, and by some that it has no use for.
PANEL_ROLE, RAISED_ROLE, WORDS_ROLE, ACCENT_ROLE = Role.Window, Role.Base, Role.WindowText, Role.Highlight
BACKGROUND_ROLE, HAIRLINE_ROLE, DIM_ROLE = Role.Shadow, Role.Mid, Role.PlaceholderText
ON_ACCENT_ROLE = Role.HighlightedText
HOVERED_ROLE, CHOSEN_ROLE, HANDLE_ROLE, OFF_ROLE = (
    Role.Midlight,
    Role.LinkVisited,
    Role.BrightText,
    Role.AlternateBase,
)


def style_sheet(caption: int) -> str:
    """Hairlines instead of frames, rounded controls, flat tool bars.

    Args:
        caption: Pixels of captions.
    """
    return "\n".join((_WINDOW, _FIELDS, _LISTS, _MENUS, _SWITCHES, _roles(caption), _pictures()))


def _in_palette(role: QPalette.ColorRole) -> str:
    """How a style sheet names a role: ``WindowText`` is ``palette(window-text)``."""
    name = "".join(f"-{letter.lower()}" if letter.isupper() else letter for letter in role.name)
    return f"palette({name.removeprefix('-')})"


PANEL, RAISED, WORDS, ACCENT = map(_in_palette, (PANEL_ROLE, RAISED_ROLE, WORDS_ROLE, ACCENT_ROLE))
BACKGROUND, HAIRLINE, DIM = map(_in_palette, (BACKGROUND_ROLE, HAIRLINE_ROLE, DIM_ROLE))
ON_ACCENT = _in_palette(ON_ACCENT_ROLE)
HOVERED, CHOSEN, HANDLE, OFF = map(_in_palette, (HOVERED_ROLE, CHOSEN_ROLE, HANDLE_ROLE, OFF_ROLE))


def _pictures() -> str:
    """Each picture twice, since a sheet cannot tint one: as it is on a light ground, and on a dark one."""
    folder = shipped_folder(ARROWS).as_posix()
    return "\n".join(
        f'{", ".join(above + place for place in places)} {{ image: url("{folder}/{name}-{ground}.svg"); }}'
        for above, ground in (("", "light"), (f'*[{GROUND}="{DARK_GROUND}"] ', "dark"))
        for name, places in PICTURES.items()
    )


#: The window, its bars, and what lies between its panels.
_WINDOW = f"""
QMainWindow, QMenuBar, QStatusBar {{ background: {BACKGROUND}; }}
QMenuBar {{ padding: 2px 4px; }}
QMenuBar::item {{ background: transparent; padding: 5px 8px; border-radius: 5px; }}
QMenuBar::item:selected {{ background: {CHOSEN}; }}
QDockWidget > QWidget, QDialog {{ background: {PANEL}; }}
QMainWindow::separator {{ background: {HAIRLINE}; width: 2px; height: 2px; }}
QMainWindow::separator:hover {{ background: {ACCENT}; }}
QStatusBar::item {{ border: none; }}
QToolBar {{ background: {BACKGROUND}; border: none; border-bottom: 1px solid {HAIRLINE};
    padding: 6px 8px; spacing: 5px; }}
QToolBar::separator {{ background: {HAIRLINE}; width: 1px; margin: 5px 3px; }}
QToolBar QToolButton {{ padding: 4px 7px; }}
QToolBar #qt_toolbar_ext_button {{ padding: 0; border: none; background: transparent; }}
QToolTip {{ background: {RAISED}; color: {WORDS}; border: 1px solid {HAIRLINE}; padding: 4px; }}
QSplitter::handle {{ background: {HAIRLINE}; width: 1px; height: 1px; }}
QSplitter::handle:hover {{ background: {ACCENT}; }}
QDockWidget {{ titlebar-close-icon: none; titlebar-normal-icon: none; font-weight: 600; }}
"""
#: Buttons and what is typed or chosen in.
_FIELDS = f"""
QPushButton, QToolButton, QComboBox, QSpinBox, QDoubleSpinBox, QLineEdit {{ border: 1px solid {HAIRLINE};
    border-radius: 6px; padding: 3px 8px; background: {RAISED}; }}
QLineEdit, QComboBox:editable {{ padding: 3px 6px; }}
QAbstractSpinBox QLineEdit, QComboBox QLineEdit {{ border: none; padding: 0; background: transparent; }}
QListWidget QLineEdit {{ border: none; border-radius: 0; padding: 0 3px; }}
QPushButton:hover, QToolButton:hover, QComboBox:hover {{ background: {HOVERED}; }}
QPushButton:focus, QToolButton:focus, QComboBox:focus, QSpinBox:focus, QDoubleSpinBox:focus, QLineEdit:focus {{
    border-color: {ACCENT}; }}
QPushButton:default {{ background: {ACCENT}; border-color: {ACCENT}; color: {ON_ACCENT}; }}
QPushButton:default:hover, QPushButton:default:focus {{ border-color: {WORDS}; }}
QPushButton:default:disabled {{ border-color: {HAIRLINE}; color: {OFF}; }}
QPushButton:checked, QToolButton:checked {{ background: {CHOSEN}; border-color: {ACCENT}; }}
QPushButton:disabled, QToolButton:disabled, QComboBox:disabled, QSpinBox:disabled, QDoubleSpinBox:disabled,
QLineEdit:disabled {{ background: {PANEL}; }}
QToolButton[flat="true"] {{ border: none; background: transparent; padding: 3px; }}
QToolButton[flat="true"]:hover {{ background: {HOVERED}; }}
QToolButton[flat="true"]:focus {{ border: 1px solid {ACCENT}; padding: 2px; }}
QComboBox QAbstractItemView, #completions, #add-behavior {{ background: {RAISED}; border: 1px solid {HAIRLINE}; }}
QComboBox {{ combobox-popup: 0; selection-background-color: {CHOSEN}; selection-color: {WORDS}; }}
QComboBoxPrivateContainer {{ border: none; }}
QInputDialog > QComboBox, QInputDialog > QLineEdit, QInputDialog > QAbstractSpinBox {{ min-width: 300px; }}
QDialogButtonBox {{ dialogbuttonbox-buttons-have-icons: 0; button-layout: {ACCEPT_LAST}; }}
QComboBox::drop-down {{ border: none; width: 20px; }}
QComboBox::down-arrow {{ width: 12px; height: 12px; }}
QSpinBox, QDoubleSpinBox {{ padding-right: 18px; }}
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button {{ border: none; background: transparent; width: 18px; }}
QAbstractSpinBox::up-arrow {{ width: 10px; height: 10px; }}
QAbstractSpinBox::down-arrow {{ width: 10px; height: 10px; }}
QToolButton[popupMode="2"] {{ padding-right: 18px; }}
QToolButton::menu-indicator {{ width: 10px; height: 10px;
    subcontrol-position: right center; right: 5px; }}
"""
#: Lists, tables, scroll bars and tabs.
_LISTS = f"""
QTreeView {{ selection-background-color: {CHOSEN}; selection-color: {WORDS}; }}
QAbstractScrollArea::corner {{ background: transparent; border: none; }}
QScrollBar:vertical {{ background: transparent; width: 10px; margin: 0; }}
QScrollBar:horizontal {{ background: transparent; height: 10px; margin: 0; }}
QScrollBar::handle {{ background: {HANDLE}; border-radius: 3px; margin: 2px; }}
QScrollBar::handle:vertical {{ min-height: 24px; }}
QScrollBar::handle:horizontal {{ min-width: 24px; }}
QScrollBar::add-line, QScrollBar::sub-line {{ width: 0; height: 0; }}
QScrollBar::add-page, QScrollBar::sub-page {{ background: transparent; }}
QTreeView, QTableView, QListView, QScrollArea, QPlainTextEdit, QTextBrowser {{ border: none;
    background: {PANEL}; }}
QTreeView::item, QListView::item {{ padding: 3px 2px; }}
QTreeView::item:selected, QTableView::item:selected, QListView::item:selected {{ background: {CHOSEN};
    color: {WORDS}; }}
QHeaderView::section {{ background: {PANEL}; color: {DIM}; border: none;
    border-bottom: 1px solid {HAIRLINE}; padding: 4px 6px; }}
QTableView QHeaderView::section {{ padding: 4px 3px; }}
QTabBar::tab {{ background: transparent; color: {DIM}; padding: 6px 10px; border: none;
    border-bottom: 2px solid transparent; }}
QTabBar::tab:selected {{ color: {WORDS}; border-bottom: 2px solid {ACCENT}; }}
QTabBar::tab:hover {{ color: {WORDS}; }}
QTabBar::tab:selected:focus {{ background: {CHOSEN}; }}
QTableView, QTreeView, QListView {{ outline: none; }}
"""
#: Menus.
_MENUS = f"""
QMenu {{ background: {RAISED}; border: 1px solid {HAIRLINE}; padding: 4px; }}
QMenu::item {{ padding: 5px 24px 5px 10px; border-radius: 4px; }}
QMenu::item:selected {{ background: {CHOSEN}; color: {WORDS}; }}
QMenu::item:disabled {{ color: {OFF}; }}
QMenu::separator {{ background: {HAIRLINE}; height: 1px; margin: 4px 6px; }}
QMenu::icon {{ padding-left: 8px; }}
QMenu::icon:checked {{ background: {CHOSEN}; border: 1px solid {ACCENT}; border-radius: 4px; }}
QMenu::indicator {{ padding-left: 6px; }}
QMenu::indicator, QMenu::right-arrow {{ width: 12px; height: 12px; }}
"""
#: Boxes that are checked, bars of progress, and sliders.
_SWITCHES = f"""
QCheckBox::indicator, QListView::indicator, QTableView::indicator, QTreeView::indicator {{
    width: 12px; height: 12px; border: 1px solid {DIM}; border-radius: 4px; background: {RAISED}; }}
QCheckBox::indicator:checked, QListView::indicator:checked, QTableView::indicator:checked, QTreeView::indicator:checked {{
    border-color: {ACCENT}; background: {ACCENT}; }}
QCheckBox::indicator:disabled {{ border-color: {HAIRLINE}; background: {PANEL}; }}
QCheckBox::indicator:checked:disabled {{ background: {HANDLE}; }}
QCheckBox::indicator:focus {{ border-color: {ACCENT}; }}
QProgressBar {{ border: none; border-radius: 3px; background: {HAIRLINE}; }}
QProgressBar::chunk {{ border-radius: 3px; background: {ACCENT}; }}
QSlider::groove:horizontal {{ height: 4px; border-radius: 2px; background: {HAIRLINE}; }}
QSlider::sub-page:horizontal {{ border-radius: 2px; background: {ACCENT}; }}
QSlider::handle:horizontal {{ width: 12px; margin: -5px 0; border-radius: 7px; background: {ACCENT};
    border: 1px solid {ACCENT}; }}
QSlider::handle:horizontal:hover {{ background: {HOVERED}; }}
QSlider::handle:horizontal:focus {{ background: {RAISED}; border: 2px solid {ACCENT}; width: 10px; }}
QSlider::sub-page:horizontal:disabled {{ background: {HANDLE}; }}
QSlider::handle:horizontal:disabled {{ background: {PANEL}; border-color: {HANDLE}; }}
"""


def _roles(caption: int) -> str:
    """What the property "role" makes of a widget."""
    return f"""
QPlainTextEdit[role="details"] {{ background: {RAISED}; border: 1px solid {HAIRLINE};
    border-radius: 6px; padding: 4px; }}
QLabel[role="caption"] {{ color: {DIM}; font-size: {caption}px; }}
QLabel[role="empty"] {{ color: {DIM}; }}
QLabel[role="title"] {{ font-weight: 600; }}
QFrame[role="hairline"] {{ background: {HAIRLINE}; border: none; }}
"""
