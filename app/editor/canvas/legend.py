"""The legend: what each color and shape means, and how many there are; a click lights up those."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, QSizeF, Qt, Signal
from PySide6.QtGui import QColor, QFontMetrics, QIcon, QPainter
from PySide6.QtWidgets import QFrame, QHBoxLayout, QMenu, QToolButton, QWidget

from ..forms.buttons import opens
from ..icons import icon
from ..letters import plain
from .atlas import Look, Style, paint_agent
from .coloring import ATTACHED, RUNS, SHAPES, ColorBy, Coloring, Entry
from .looking import Looking
from .stamp import stamp

if TYPE_CHECKING:
    from ..studio import Studio

#: Pixels of a swatch, and how many entries stand side by side at most; the others are in a menu.
SWATCH, MOST = 15, 9
#: Pixels of a name at most, so that there is room for others beside it; all of it is in the tool tip.
LONGEST = 170
_SHAPE_WORDS = ("filled arrow: runs an automaton", "outlined arrow: a basic behavior only", "ring: idles")
_MENU = ("canvas.hulls", "canvas.links", "canvas.ranges", "canvas.trails", "canvas.all_trails", "canvas.grid")


class Legend(QFrame):
    """A line of entries at the bottom of the canvas.

    Signals:
        resized: It has another size now.
    """

    resized = Signal()

    def __init__(self, studio: Studio, looking: Looking, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("legend")
        self._studio = studio
        self._looking = looking
        self._shown: tuple[object, ...] = ()
        self._rows: list[tuple[Entry, int]] = []
        self._room = 10_000
        self._seen: dict[Entry, int] = {}  # which of them came first: they stand in this order
        self._attached = False
        self.buttons: dict[str, QToolButton] = {}
        self._layout = QHBoxLayout(self)
        self._layout.setContentsMargins(6, 3, 4, 3)
        self._layout.setSpacing(2)
        self.more = self._flat("More entries")
        opens(self.more, QMenu(self.more))
        self.settings = self._flat("What colors tell, and what else is shown")
        opens(self.settings, self._settings_menu())
        self._layout.addWidget(self.more)
        self._layout.addWidget(self.settings)
        self.dress()

    def _flat(self, tip: str) -> QToolButton:
        button = QToolButton(self)
        button.setProperty("flat", "true")
        button.setToolTip(tip)
        button.setAccessibleName(tip)
        return button

    def _settings_menu(self) -> QMenu:
        menu = QMenu(self.settings)
        menu.setToolTipsVisible(True)
        for by in ColorBy:
            menu.addAction(self._studio.actions[f"canvas.color_{by}"])
        menu.addSeparator()
        for name in _MENU:
            menu.addAction(self._studio.actions[name])
        return menu

    # --------------------------------------------------------------------------------------------- entries

    def begin(self) -> None:
        """Forget who was there: another world, or other colors."""
        self._seen, self._attached, self._shown = {}, False, ()

    def tell(self, coloring: Coloring, room: int) -> None:
        """Show who there is, with counts, in at most so many pixels."""
        there = list(zip(coloring.entries, coloring.counts, strict=True))
        for entry, count in there:
            if count:
                self._seen.setdefault(entry, len(self._seen))  # those of a moment ago keep their places
        rows = [(entry, count) for entry, count in there if entry in self._seen]
        rows.sort(key=lambda row: (row[0].shape, self._seen[row[0]]))
        if coloring.attached or self._attached:
            self._attached = True
            rows.append(
                (Entry(ATTACHED, _rgb(self._studio.theme.palette.text), RUNS + SHAPES), coloring.attached)
            )
        shown = (tuple(rows), room, self._looking.lit)
        if shown == self._shown:
            return
        same = self._shown and [e for e, _ in rows] == [e for e, _ in self._rows] and room == self._room
        self._shown, self._rows, self._room = shown, rows, room
        if not same:
            self._rebuild()
        self._count()

    def _rebuild(self) -> None:
        for button in self.buttons.values():
            self._layout.removeWidget(button)
            button.hide()
            button.deleteLater()
        self.buttons = {}
        used, left = 0, self._room - 90
        for entry, count in self._rows[:MOST]:
            button = self._entry(entry)
            button.setText(plain(self._label(entry, count)))
            used += button.sizeHint().width() + 2
            if used > left:
                button.hide()
                button.deleteLater()
                break
            self._layout.insertWidget(len(self.buttons), button)
            button.show()
            self.buttons[entry.words] = button
        self._fill_more(self._rows[len(self.buttons) :])

    def _entry(self, entry: Entry) -> QToolButton:
        button = self._flat(f"{entry.words}: light up these agents ({_shape_words(entry.shape)})")
        button.setCheckable(True)
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        button.setIcon(self._swatch(entry))
        button.setIconSize(QSize(SWATCH, SWATCH))
        button.toggled.connect(lambda on: self._looking.light(entry.words, on=on))
        return button

    def _count(self) -> None:
        for entry, count in self._rows:
            button = self.buttons.get(entry.words)
            if button is not None:
                button.setText(plain(self._label(entry, count)))
                button.setAccessibleName(f"{count} {entry.words}: light up")
                button.blockSignals(True)
                button.setChecked(entry.words in self._looking.lit)
                button.blockSignals(False)
        before = self.size()
        self.adjustSize()
        if self.size() != before:
            self.resized.emit()

    def _label(self, entry: Entry, count: int) -> str:
        """What stands on its button."""
        name = QFontMetrics(self.font()).elidedText(entry.words, Qt.TextElideMode.ElideRight, LONGEST)
        return _counted(name, count)

    def _fill_more(self, rows: list[tuple[Entry, int]]) -> None:
        self.more.setVisible(bool(rows))
        self.more.setText(f"+{len(rows)}")
        menu = self.more.menu()
        menu.clear()
        for entry, count in rows:
            action = menu.addAction(self._swatch(entry), plain(_counted(entry.words, count)))
            action.setCheckable(True)
            action.setChecked(entry.words in self._looking.lit)
            action.toggled.connect(lambda on, words=entry.words: self._looking.light(words, on=on))

    # ----------------------------------------------------------------------------------------------- looks

    def _swatch(self, entry: Entry) -> QIcon:
        """The shape as it is drawn in the world, pointing to the right."""
        ratio = self.devicePixelRatioF()
        colors = self._studio.theme.palette
        look, style = Look(entry.color, entry.shape), Style(11.0, ratio, colors.raised, colors.text)

        def draw(painter: QPainter) -> None:
            painter.translate(-1.5 if entry.shape >= SHAPES else 0.0, 0.0)  # the bar in front needs room
            paint_agent(painter, look, style)

        return QIcon(stamp(QSizeF(SWATCH, SWATCH), ratio, draw))

    def dress(self) -> None:
        """In the colors of the palette."""
        colors = self._studio.theme.palette
        self.setStyleSheet(
            f"#legend {{ background: {colors.raised}; border: 1px solid {colors.hairline}; border-radius: 7px; }}"
            "#legend QToolButton { font-size: 12px; padding: 2px 5px; }"
            "#legend QToolButton::menu-indicator { image: none; }"
        )
        self.settings.setIcon(icon("tune-variant", self._studio.theme, "dim"))
        self._shown, self._rows = (), []


def _shape_words(shape: int) -> str:
    words = _SHAPE_WORDS[shape % SHAPES]
    return f"{words}; a bar at its nose: attached" if shape >= SHAPES else words


def _counted(name: str, count: int) -> str:
    """The count stands apart from a name that ends in a number."""
    apart = " · " if name[-1:].isdigit() else " "
    return f"{name}{apart}{count:,}"


def _rgb(name: str) -> tuple[int, int, int]:
    color = QColor(name)
    return color.red(), color.green(), color.blue()
