"""How quick the graph is: from an edit to its picture, and how long Graphviz takes beside the window."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from time import perf_counter
from typing import Self

from PySide6.QtCore import QCoreApplication, QEventLoop, QTimer
from PySide6.QtWidgets import QApplication

from ...core.automaton import START, Automaton, Basic, Rule, State
from ...core.conditions import AtMost, Condition, Guard
from ...core.edits import add_rule, add_state, move_states, rename_state, replace_rule
from ...core.features import FeatureUse, TicksInState
from ...core.library import Library
from ...core.project import Project
from ...engine.scenarios import open_scenario
from ..selection import BehaviorKey
from ..settings import Settings
from ..studio import Studio
from ..theme import Theme
from .panel import GraphPanel

KEY = BehaviorKey("agent", "large")
#: Seconds after which waiting is given up.
PATIENCE = 30.0
#: Milliseconds between two beats of the heart that tells whether the window is blocked.
BEAT = 5


@dataclass(frozen=True, slots=True)
class GraphTimes:
    """Milliseconds.

    Attributes:
        edit: From an edit to its picture, the longest of several kinds of edit.
        layout: From an edit that changes the structure until Graphviz's arrangement is shown.
        stall: The longest time in which the window did not answer while that went on.
    """

    edit: float
    layout: float
    stall: float


def large(states: int = 40, edges: int = 120) -> Project:
    """A project with one authored automaton of so many states and edges."""
    names = [START, *(f"s{number}" for number in range(1, states))]
    pairs = dict.fromkeys((k % states, (7 * k + 1 + k // states) % states) for k in range(4 * edges))
    rules = tuple(
        Rule(str(number), names[source], _guard(number), names[target])
        for number, (source, target) in enumerate(list(pairs)[:edges], 1)
    )
    held = tuple(State(name, Basic("Forward"), f"State {name}") for name in names[1:])
    automaton = Automaton("large", "Large", features=(FeatureUse("ticks", TicksInState()),), rules=rules)
    automaton = replace(automaton, states=(*automaton.states, *held))
    return Project("Large", "foraging", libraries={"agent": Library({"large": automaton})})


def _guard(number: int) -> Guard:
    return (Condition(AtMost("ticks", float(number))),)


def measure(application: QApplication, settings: Settings, states: int = 40, edges: int = 120) -> GraphTimes:
    """Edit a large automaton in a graph panel of its own, and take the times."""
    studio = Studio(Theme(application, settings.theme), settings)
    panel = GraphPanel(studio)
    try:
        project = large(states, edges)
        studio.open(project, open_scenario(project), None, saved=False)
        panel.resize(900, 700)
        panel.show()
        _wait(lambda: _settled(panel))
        return _measured(studio, panel)
    finally:
        panel.hide()
        panel.deleteLater()
        studio.shut_down()


def _measured(studio: Studio, panel: GraphPanel) -> GraphTimes:
    where, document = (KEY.type, KEY.id), studio.document
    acts: tuple[Callable[[], object], ...] = (
        lambda: document.do(rename_state, *where, "s1", "Renamed"),
        lambda: document.do(replace_rule, *where, "1", probability=0.5),
        lambda: document.do(move_states, *where, {"s2": (500.0, 500.0)}),
        lambda: document.do(add_rule, *where, "s3", "s9"),
        lambda: document.do(add_state, *where, Basic("RotateLeft"), "Another"),
    )
    edit = layout = stall = 0.0
    for act in acts:
        with _Heart() as heart:
            begun = perf_counter()
            act()
            _wait(lambda: not panel.is_pending)
            panel.view.viewport().repaint()
            edit = max(edit, perf_counter() - begun)
            _wait(lambda: _settled(panel))
            layout = max(layout, perf_counter() - begun)
        stall = max(stall, heart.longest)
    return GraphTimes(1000 * edit, 1000 * layout, 1000 * stall)


def _settled(panel: GraphPanel) -> bool:
    levels = panel.scene.levels.values()
    return bool(levels) and not panel.is_pending and all(level.is_settled for level in levels)


def _wait(until: Callable[[], bool]) -> None:
    """Let the window live until something is so."""
    end = perf_counter() + PATIENCE
    while not until() and perf_counter() < end:
        QCoreApplication.processEvents(QEventLoop.ProcessEventsFlag.AllEvents, BEAT)


class _Heart:
    """Beats, and keeps the longest pause.

    Attributes:
        longest: In seconds, beyond the time between two beats.
    """

    def __init__(self) -> None:
        self.longest = 0.0
        self._last = perf_counter()
        self._timer = QTimer(interval=BEAT)
        self._timer.timeout.connect(self._beat)

    def __enter__(self) -> Self:
        self._last = perf_counter()
        self._timer.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._beat()
        self._timer.stop()

    def _beat(self) -> None:
        now = perf_counter()
        self.longest = max(self.longest, now - self._last - BEAT / 1000)
        self._last = now
