"""From a key to the agent: how long it takes until a snapshot shows what the user picked."""

from time import perf_counter

from PySide6.QtCore import Qt

from ...core.project import Project
from ...engine.commands import Play
from ..selection import BehaviorKey
from .stage import Stage

TYPE, TAUGHT, NODE = "agent", "wander", "agent-0"
#: How often a key is pressed.
PRESSES = 100
#: Keys of two states, which are pressed in turn.
KEYS = (Qt.Key.Key_1, Qt.Key.Key_2)


def seconds_to_obey(stage: Stage, project: Project, presses: int = PRESSES) -> list[float]:
    """From each of several presses of a key of the teach panel until the agent's change is in a snapshot.

    Time passes at speed 1 meanwhile, so the tick that carries out the pick has to come first.
    """
    stage.open(project)
    studio = stage.studio
    studio.selection.select_behavior(BehaviorKey(TYPE, TAUGHT))
    studio.selection.select_nodes((NODE,))
    studio.teaching.teach()
    stage.wait(lambda: studio.teaching.lesson is not None, "teach")
    studio.bridge.send(Play(1.0))
    stage.settle()
    seen: list[tuple[str, float]] = []
    studio.bridge.snapshot_changed.connect(lambda _: seen.append((studio.teaching.state, perf_counter())))
    found = []
    for number in range(presses):
        before, began = studio.teaching.state, perf_counter()
        seen.clear()
        stage.press(KEYS[number % len(KEYS)])
        stage.wait(lambda: studio.teaching.state != before, "do what was picked")  # noqa: B023 - called at once
        found.append(next(at for state, at in seen if state != before) - began)
        # Presses fall anywhere between two ticks and two frames.
        stage.run(0.01 + 0.007 * (number % 5))
    return found
