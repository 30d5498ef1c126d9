"""What the selected node does and why: sentences first, then what it sees."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, QUrl, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QLabel, QStackedLayout, QTextBrowser, QWidget

from ..actions import ActionRow, When
from ..selection import BehaviorKey
from ..soon import Later, Soon
from .telling import LevelTold, Told, tell, tell_why_not

if TYPE_CHECKING:
    from ...engine.explain import Reason
    from ...engine.snapshots import Snapshot
    from ..studio import Studio

#: Milliseconds between two tellings while time passes: nobody reads faster.
READING = 250
#: Letters of a name that is not broken.
SHORT = 24
EMPTY = "Select an agent or a controller to see what it does, and why."


class InspectorPanel(QWidget):
    """Says why the selected node does what it does, and what would have to be different.

    Signals:
        title_changed: Whose turn it is.
    """

    title_changed = Signal(str)

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._told: Told | None = None
        self._why_not = ""
        self._html = ""
        self._empty = QLabel(EMPTY)
        self._empty.setProperty("role", "empty")
        self._empty.setWordWrap(True)
        self._empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._empty.setContentsMargins(16, 8, 16, 8)
        self.text = QTextBrowser()
        self.text.setOpenLinks(False)
        self.text.document().setDocumentMargin(10)
        self.text.setAccessibleName("why")
        self.text.anchorClicked.connect(self._follow)
        self._pages = QStackedLayout(self)
        self._pages.addWidget(self._empty)
        self._pages.addWidget(self.text)
        self.setFocusProxy(self.text)
        self._live = Later(self, self.refresh, READING)
        self._soon = Soon(self, self.refresh)
        studio.bridge.snapshot_changed.connect(self._later)
        studio.document.project_changed.connect(self._later)
        studio.bridge.mode_changed.connect(self._later)
        studio.opened.connect(self._other)
        studio.selection.nodes_changed.connect(self._other)
        studio.theme.changed.connect(self.refresh)
        studio.actions.add(inspector_rows(self))
        self.refresh()

    # ---------------------------------------------------------------------------------------------- telling

    def _later(self) -> None:
        if self.isVisible():
            told = None if self._told is None else self._told.node
            (self._live if told == (self._studio.selection.node or None) else self._soon).ask()

    def _other(self) -> None:
        self._why_not = ""
        self._soon.ask()

    def showEvent(self, event: QShowEvent) -> None:
        """Say what has happened while nobody looked."""
        super().showEvent(event)
        self._other()

    def refresh(self) -> None:
        """Say what is the case now."""
        studio, snapshot = self._studio, self._studio.snapshot
        node = studio.selection.node
        self._told = None
        if snapshot is not None and node:
            self._told = tell(studio.document.project, studio.document.scenario.vocabulary, snapshot, node)
            if self._told is None and node in snapshot.place.rows:
                return  # the next snapshot tells of it
        self._pages.setCurrentIndex(0 if self._told is None else 1)
        self.title_changed.emit("Why")
        if self._told is not None and snapshot is not None:
            self._show(self._page(self._told, snapshot))

    def _show(self, html: str) -> None:
        if html != self._html:
            self._html = html
            bar = self.text.verticalScrollBar()
            at = bar.value()
            self.text.setHtml(html)
            bar.setValue(at)

    # -------------------------------------------------------------------------------------------- the page

    def _page(self, told: Told, snapshot: Snapshot) -> str:
        colors = self._studio.theme.palette
        parts = [f"<p><b>{escape(told.title)}</b></p>"]
        parts += [self._sentence(number, reason) for number, reason in enumerate(told.reasons)]
        if not told.reasons and told.basic:
            parts.append(f"<p>It does {escape(told.basic)}, as it was told.</p>")
        parts.append(self._links(told))
        if self._why_not:
            document = self._studio.document
            scenario = document.scenario.vocabulary
            said = tell_why_not(document.project, scenario, snapshot, told.node, self._why_not)
            parts.append(f"<p>{escape(said)}.</p>" if said else "")
        parts += [self._level(number, level) for number, level in reversed(list(enumerate(told.levels)))]
        if told.flags:
            parts.append(f"<p>Flags up: {escape(', '.join(told.flags))}</p>")
        style = (
            f"<style>p {{ margin: 3px 0 5px 0; }} a {{ color: {colors.accent}; text-decoration: none; }}"
            f" td {{ padding: 1px 14px 1px 0; }} .dim {{ color: {colors.dim}; }}</style>"
        )
        return style + "".join(parts)

    def _sentence(self, number: int, reason: Reason) -> str:
        words = "".join(
            f"<b>{escape(part.text)}</b>" if part.strong else escape(part.text) for part in reason.parts
        )
        link = (
            f' <a href="examples:{number}">Show {"it" if len(reason.examples) == 1 else "them"}</a>'
            if reason.examples
            else ""
        )
        return f"<p>{words}.{link}</p>"

    def _links(self, told: Told) -> str:
        links = [
            f'<a href="whynot:{number}">Why not {escape(name)}?</a>'
            for level in told.levels[:1]
            for number, (_, name) in enumerate(level.others)
        ]
        teaching = self._studio.teaching
        if teaching.can_mend and teaching.node == told.node:
            links.append('<a href="wrong:">It should have stayed</a>')
        return f"<p>{' · '.join(links)}</p>" if links else ""

    def _level(self, number: int, level: LevelTold) -> str:
        rows = "".join(
            f'<tr><td class="dim" style="{_kept(one.name)}">{escape(one.name)}</td>'
            f'<td style="{_kept(one.value)}">{escape(one.value)}</td><td class="dim">{escape(one.words)}</td></tr>'
            for one in (*level.bindings, *level.readings)
        )
        title = f'<p><a href="open:{number}">{escape(level.title)}</a></p>'
        return f"{title}<table>{rows}</table>" if rows else title

    # -------------------------------------------------------------------------------------------- following

    def _follow(self, url: QUrl) -> None:
        if self._told is None:
            return
        verb, _, number = url.toString().partition(":")
        match verb:
            case "examples":
                self.show_examples(int(number))
            case "whynot":
                self._why_not = self._told.levels[0].others[int(number)][0]
                self.refresh()
            case "wrong":
                self._studio.teaching.should_not_have_left()
            case "open":
                level = self._told.levels[int(number)]
                self._studio.selection.select_behavior(BehaviorKey(level.type, level.automaton), level.state)

    def show_examples(self, number: int = -1) -> None:
        """Select the examples that decided at one level of the path: by default at the innermost that has any."""
        if self._told is None:
            return
        with_any = [reason for reason in self._told.reasons if reason.examples]
        reason = self._told.reasons[number] if number >= 0 else (with_any[-1] if with_any else None)
        if reason is not None:
            selection = self._studio.selection
            selection.select_behavior(BehaviorKey(reason.type, reason.automaton), reason.state)
            selection.select_examples(reason.examples)
            self._studio.show_panel.emit("examples")

    @property
    def has_examples(self) -> bool:
        """Whether examples decided what the node does."""
        return self._told is not None and any(reason.examples for reason in self._told.reasons)


def inspector_rows(panel: InspectorPanel) -> tuple[ActionRow, ...]:
    """What can be asked of the node that is selected."""
    return (
        ActionRow(
            "behavior.show_examples",
            "Show the examples that decide",
            "Behavior",
            lambda _: panel.show_examples(),
            "examples",
            "Ctrl+E",
            "Select the examples because of which the selected node does what it does",
            "format-list-bulleted",
            When(lambda _: panel.has_examples, "select a node that does what it has learned"),
        ),
    )


def _kept(words: str) -> str:
    """The style of words that stay on one line if they are short; longer ones would leave no room for what stands beside."""
    return "white-space: nowrap" if len(words) <= SHORT else ""
