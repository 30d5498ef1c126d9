"""The preferences: every change holds at once and is kept."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QSpinBox,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from ..actions import ActionRow
from ..forms.parts import caption
from ..forms.word_list import WordList
from ..number_box import roomy
from ..room import resize_within
from ..size import size_in_force, sizes_that_fit
from ..theme import ThemeMode
from .keys import KeysPage

if TYPE_CHECKING:
    from ..studio import Studio

MOST_SECONDS = 3600
_THEMES = {
    ThemeMode.SYSTEM: "As the system has it",
    ThemeMode.LIGHT: "Light",
    ThemeMode.DARK: "Dark",
}


class Preferences(QDialog):
    """The dialog.

    Attributes:
        controls: The control of each setting by the setting's name, "keys" included.
    """

    def __init__(self, studio: Studio, window: QWidget) -> None:
        super().__init__(window)
        self._studio = studio
        self.setWindowTitle("Preferences")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        resize_within(self, 620, 560)
        self.theme = WordList()
        for mode, text in _THEMES.items():
            self.theme.addItem(text, mode)
        self.size_of_all = WordList()
        now, chosen = size_in_force(), studio.settings.size_percent
        for percent in sizes_that_fit(self.screen().availableSize().width(), now, chosen):
            self.size_of_all.addItem(f"{percent}%", percent)
        self.autosave = roomy(QSpinBox())
        self.learns = QCheckBox("Learn by itself")
        self.keys = KeysPage(studio)
        self.controls: dict[str, QWidget] = {
            "theme": self.theme,
            "size_percent": self.size_of_all,
            "autosave_seconds": self.autosave,
            "learns_by_itself": self.learns,
            "keys": self.keys,
        }
        self.pages = QTabWidget()
        self.pages.setDocumentMode(True)
        self.pages.addTab(self._general(), "General")
        self.pages.addTab(self.keys, "Keys")
        box = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        box.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 12, 16, 14)
        layout.addWidget(self.pages, 1)
        layout.addWidget(box)
        studio.settings.changed.connect(self._show)
        self._show()
        self.theme.activated.connect(self._set_theme)
        self.size_of_all.activated.connect(self._set_size)
        self.autosave.valueChanged.connect(self._set_autosave)
        self.learns.toggled.connect(self._set_learns)

    def _general(self) -> QWidget:
        page = QWidget()
        form = QFormLayout(page)
        form.setContentsMargins(4, 16, 4, 4)
        form.setHorizontalSpacing(20)
        form.setVerticalSpacing(12)
        self.theme.setAccessibleName("Theme")
        self.theme.setToolTip("Light or dark colors")
        form.addRow("Theme", self.theme)
        self.size_of_all.setAccessibleName("Size of text and controls")
        self.size_of_all.setToolTip("How large everything in the window is")
        form.addRow("Size", self.size_of_all)
        form.addRow(
            "",
            caption(
                "Of text and controls; from the next start on. What the screen has no room for is not offered."
            ),
        )
        self.autosave.setRange(0, MOST_SECONDS)
        self.autosave.setSingleStep(5)
        self.autosave.setSuffix(" s")
        self.autosave.setSpecialValueText("never")
        self.autosave.setAccessibleName("Autosave interval")
        self.autosave.setToolTip("How often unsaved work is kept for the case of a crash")
        form.addRow("Autosave every", self.autosave)
        form.addRow(
            "",
            caption(
                "What was kept is offered after a crash; the project's own files are only written when you save."
            ),
        )
        self.learns.setToolTip("Learn in the background from every change of an example")
        form.addRow("Learning", self.learns)
        form.addRow(
            "", caption("Otherwise behaviors are learned when they are tested, or when you ask for it.")
        )
        return page

    def show_setting(self, name: str) -> None:
        """Go to a setting."""
        control = self.controls[name]
        self.pages.setCurrentIndex(1 if name == "keys" else 0)
        target = self.keys.filter if name == "keys" else control
        target.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def _show(self) -> None:
        settings = self._studio.settings
        for control in (self.autosave, self.learns):
            control.blockSignals(True)
        self.theme.setCurrentIndex(list(_THEMES).index(settings.theme))
        self.size_of_all.setCurrentIndex(max(0, self.size_of_all.findData(settings.size_percent)))
        self.autosave.setValue(settings.autosave_seconds)
        self.learns.setChecked(settings.learns_by_itself)
        for control in (self.autosave, self.learns):
            control.blockSignals(False)

    def _set_theme(self) -> None:
        self._studio.settings.theme = ThemeMode(self.theme.currentData())

    def _set_size(self) -> None:
        self._studio.settings.size_percent = self.size_of_all.currentData()

    def _set_autosave(self, seconds: int) -> None:
        self._studio.settings.autosave_seconds = seconds

    def _set_learns(self, on: bool) -> None:  # noqa: FBT001 - Qt's signal gives a bare boolean
        self._studio.settings.learns_by_itself = on


#: The settings as the command palette lists them: name, what it is called, and what it is about.
SETTINGS = (
    ("theme", "Theme", "light, dark, or as the system has it"),
    ("size_percent", "Size", "how large text and controls are"),
    ("autosave_seconds", "Autosave interval", "how often unsaved work is kept"),
    ("learns_by_itself", "Learn by itself", "learning from every change of an example"),
    ("keys", "Keys", "the shortcuts of all actions"),
)


def open_preferences(studio: Studio, window: QWidget, setting: str = "theme") -> Preferences:
    """Show the preferences at a setting; those that are open already come to the front."""
    dialog = window.findChild(Preferences)
    if dialog is None:
        dialog = Preferences(studio, window)
    dialog.show()
    dialog.raise_()
    dialog.activateWindow()
    dialog.show_setting(setting)
    return dialog


def preference_rows(window: QWidget) -> tuple[ActionRow, ...]:
    """Opening the preferences."""
    return (
        ActionRow(
            "edit.preferences",
            "Preferences…",
            "Edit",
            lambda studio: open_preferences(studio, window),
            "preferences",
            "Ctrl+,",
            "Theme, size, autosave, learning, and the keys of all actions",
            "cog-outline",
        ),
    )
