"""Context menus of the graph."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QInputDialog, QMenu

from ...core.automaton import RaiseFlag
from ...core.project import Position
from ..letters import plain
from . import offers
from .finding import let_find

if TYPE_CHECKING:
    from .panel import GraphPanel


def context_menu(panel: GraphPanel, at: Position) -> QMenu:
    """What can be done with what is selected, or at a place of the ground."""
    menu = QMenu(panel)
    menu.setToolTipsVisible(True)
    actions = panel.studio.actions
    rows: tuple[str, ...]
    if panel.scene.edge is not None:
        rows = ("graph.edit", "graph.add_rule", "", "graph.remove", "graph.unprune")
    elif panel.scene.current is not None:
        rows = (
            *(("graph.pick", "") if panel.studio.teaching.lesson is not None else ()),
            "graph.enter",
            "graph.expand",
            "graph.edit",
            "graph.link",
            "",
            "graph.author",
            "graph.unauthor",
            "",
            "graph.copy",
            "graph.paste",
            "graph.duplicate",
            "graph.remove",
        )
    else:
        menu.addMenu(add_menu(panel, at))
        rows = ("graph.paste", "", "graph.fit", "graph.arrange")
    for row in rows:
        if row:
            menu.addAction(actions[row])
        else:
            menu.addSeparator()
    _add_fixes(panel, menu)
    actions.refresh()
    return menu


def _add_fixes(panel: GraphPanel, menu: QMenu) -> None:
    """What mends the problems of what is selected."""
    fixes = panel.badges.fixes()
    if fixes:
        menu.addSeparator()
    for problem in fixes:
        action = menu.addAction(plain(f"Fix: {problem.fix}"))
        action.setToolTip(problem.message)
        action.triggered.connect(lambda _checked, problem=problem: panel.editing.mend(problem))


def add_menu(panel: GraphPanel, at: Position | None = None) -> QMenu:
    """All that a new state can hold."""
    menu = QMenu("Add state", panel)
    menu.setToolTipsVisible(True)
    level = panel.scene.level_for_new
    scope = None if level is None else panel.scoping.scope(level.type)
    if level is None or scope is None:
        menu.setEnabled(False)
        return menu
    for title, choices in (
        ("Automata", offers.automata(scope, level.automaton.id)),
        ("Basic behaviors", offers.basics(scope)),
        ("Flags", offers.flags(scope)),
    ):
        menu.addSection(title)
        for name, content in choices:
            shown = f"⚑ {name}" if isinstance(content, RaiseFlag) else name
            menu.addAction(plain(shown)).triggered.connect(
                lambda _checked, content=content: panel.add_state(content, at)
            )
    another = menu.addAction("⚑ another flag…")
    another.triggered.connect(lambda _checked: _ask_flag(panel, at))
    let_find(menu, "Find what the state is to hold", another)
    return menu


def _ask_flag(panel: GraphPanel, at: Position | None) -> None:
    name, accepted = QInputDialog.getText(panel, "Add a flag", "Name of the flag that the state raises:")
    if accepted:
        panel.add_state(RaiseFlag(name.strip()), at)
