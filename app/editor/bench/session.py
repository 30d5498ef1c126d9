"""A scripted user, for as long as wanted: how late the window's heartbeat comes meanwhile."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from time import perf_counter

from PySide6.QtCore import Qt

from ...core.edits import disable_examples, enable_examples, note_project, relabel_examples
from ...core.project import Project
from ...engine.commands import Pause, Play, Reset, RunArm
from ..selection import BehaviorKey
from .heartbeat import Heartbeat
from .stage import Stage, crowded

#: Agents of the arm that is large.
CROWD = 3_125
#: Seconds between two things that the user does.
PAUSE = 0.25
#: Seconds that the window has been there before: until then, what is not needed at once is still imported.
BEFORE = 2.5
TYPE = "agent"


class Script:
    """What the user does, over and over."""

    def __init__(self, stage: Stage) -> None:
        self._stage = stage
        self._studio = stage.studio
        self._count = 0

    @property
    def acts(self) -> tuple[Callable[[], object], ...]:
        """In this order."""
        studio, send = self._studio, self._studio.bridge.send
        press = self._stage.press
        return (
            lambda: studio.use_arm("independent"),
            lambda: send(Play(1.0)),
            *(partial(self._show, panel) for panel in ("plots", "problems", "timeline")),
            *(partial(self._select, k) for k in range(4)),
            lambda: send(Play(None)),
            *(partial(self._behavior, name) for name in ("forage", "goto", "return-with-box", "wander")),
            lambda: send(Pause()),
            self._teach,
            lambda: send(Play(1.0)),
            *(partial(press, key) for key in 3 * (Qt.Key.Key_1, Qt.Key.Key_2, Qt.Key.Key_3)),
            studio.teaching.test,
            studio.undo,
            studio.undo,
            studio.redo,
            lambda: self._show("examples"),
            lambda: send(RunArm()),
            *(partial(self._edit, edit) for edit in (disable_examples, enable_examples)),
            lambda: studio.document.do(relabel_examples, TYPE, "wander", [self._first()], "forward"),
            lambda: studio.document.do(note_project, f"note {self._count}"),
            self._arrange,
            *(partial(self._option, name) for name in ("canvas.all_trails", "canvas.hulls", "canvas.links")),
            lambda: studio.use_arm("two levels"),
            lambda: send(Play(8.0)),
            lambda: self._behavior("control-forage", "group"),
            lambda: send(Reset(self._count)),
            *(partial(self._option, name) for name in ("canvas.all_trails", "canvas.hulls", "canvas.links")),
            lambda: self._show("timeline"),
            lambda: studio.use_arm("crowd"),
            lambda: send(Play(1.0)),
            *(partial(self._select, k) for k in range(3)),
            lambda: self._behavior("forage"),
            lambda: send(Play(None)),
            lambda: studio.document.do(note_project, f"crowd {self._count}"),
            studio.undo,
            lambda: send(Pause()),
        )

    def act(self) -> None:
        """Do what comes next."""
        self._count += 1
        acts = self.acts
        acts[(self._count - 1) % len(acts)]()

    def _show(self, panel: str) -> None:
        self._studio.show_panel.emit(panel)

    def _select(self, number: int) -> None:
        snapshot = self._studio.snapshot
        if snapshot is not None:
            self._studio.selection.select_nodes(snapshot.place.agents[number : number + 1])

    def _behavior(self, automaton: str, type_name: str = TYPE) -> None:
        self._studio.selection.select_behavior(BehaviorKey(type_name, automaton))

    def _teach(self) -> None:
        self._select(3)
        self._studio.teaching.teach()

    def _first(self) -> str:
        return self._studio.document.project.examples_of(TYPE, "wander")[0].id

    def _edit(self, edit: Callable[..., object]) -> None:
        self._studio.document.do(edit, TYPE, "wander", [self._first()])

    def _arrange(self) -> None:
        action = self._studio.actions["graph.arrange"]
        if action.isEnabled():
            action.trigger()

    def _option(self, name: str) -> None:
        self._studio.actions[name].trigger()


def lateness(stage: Stage, project: Project, seconds: float, crowd: int = CROWD) -> list[float]:
    """By how many seconds each beat came too late while the user of the script worked for so long."""
    stage.open(crowded(project, crowd))
    stage.studio.settings.autosave_seconds = 1
    stage.run(BEFORE)
    script, heart = Script(stage), Heartbeat()
    end = perf_counter() + seconds
    while perf_counter() < end:
        script.act()
        stage.run(PAUSE)
    heart.stop()
    return heart.late
