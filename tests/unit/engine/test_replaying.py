"""Playing demonstrations again tells which examples would come out otherwise, and changes nothing."""

from dataclasses import replace
from threading import Event

import pytest

from app.core import edits
from app.core.project import Project
from app.engine.demonstrations import recreate
from app.engine.replaying import Replayer, compared
from tests.corridor import corridor
from tests.driver import Driver
from tests.samples import AGENT

SHUTTLE = (AGENT, "Shuttle")
LONG = 20.0


@pytest.fixture(scope="module")
def taught() -> Project:
    driver = Driver().teach("agent-1", "Shuttle", demonstration="shuttle-1")
    driver.pick("up").advance(5).pick("down").advance(3)
    assert driver.demonstration is not None
    return edits.add_demonstration(driver.project, driver.demonstration)[0]


def differences(project: Project) -> tuple[str, ...]:
    return compared(project, recreate(project, corridor)).differences


def test_what_comes_out_the_same_is_no_difference(taught: Project) -> None:
    assert compared(taught, recreate(taught, corridor)).examples == 4
    assert differences(taught) == ()


def test_what_was_changed_by_hand_is_told_example_by_example(taught: Project) -> None:
    changed = edits.disable_examples(taught, *SHUTTLE, ["1"])
    changed = edits.weight_examples(changed, *SHUTTLE, ["2"], 3.0)
    key, value = next(iter(taught.examples_of(*SHUTTLE)[2].values.items()))
    changed = edits.set_values(changed, *SHUTTLE, {"3": {key: value + 1}})
    changed = edits.relabel_examples(changed, *SHUTTLE, ["4"], "jump")
    lines = differences(changed)
    assert lines[0] == (
        "Shuttle: example 1 (Start → up, agent-1, tick 0, shuttle-1) would be recorded as one to learn from"
    )
    assert lines[1].endswith("would be recorded with the weight 1 instead of 3")
    assert lines[2].endswith(f"would be recorded with {key} {value:g} instead of {value + 1:g}")
    assert lines[3].startswith("Shuttle: example 4 (down → jump")
    assert lines[3].endswith("would not be recorded")
    assert lines[4].startswith("Shuttle: one more would be recorded (stay in down, agent-1, tick 5")
    assert len(lines) == 5


def test_another_order_is_a_difference_too(taught: Project) -> None:
    turned = tuple(reversed(taught.examples_of(*SHUTTLE)))
    (line,) = differences(replace(taught, examples={AGENT: {"Shuttle": turned}}))
    assert "in another order" in line


def test_it_is_played_in_the_background_with_progress_and_what_cannot_be_played_is_told(
    taught: Project,
) -> None:
    bell = Event()
    replayer = Replayer(bell.set)
    replayer.ask(taught, corridor)
    assert bell.wait(LONG)
    (answer,) = replayer.answers()
    assert (answer.differences, answer.problem) == ((), "")
    assert replayer.progress == (1.0, "done")
    bell.clear()
    shown = taught.demonstrations[0]
    elsewhere = replace(shown, picks=tuple(replace(pick, node="agent-99") for pick in shown.picks))
    replayer.ask(replace(taught, demonstrations=(elsewhere,)), corridor)
    assert bell.wait(LONG)
    (answer,) = replayer.answers()
    assert "'agent-99'" in answer.problem
    replayer.ask(taught, corridor)
    replayer.cancel()
    assert replayer.answers() == []
    replayer.close()
