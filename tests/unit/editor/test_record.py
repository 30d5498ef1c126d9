"""What is kept of a run for plotting, and the lines made of it."""

import numpy as np
import pytest

from app.core.hierarchy import Node
from app.editor.plots.series import BehaviorShares, Lines, MeasureOf, StateShares, rows_below
from app.editor.record import MOST_POINTS, Point, Record
from app.sim.doing import BehaviorRef, Doing, StateRef

REFS = (BehaviorRef("agent", "a", "A"), BehaviorRef("agent", "", "Go"))
STATES = (StateRef("agent", "a", "s"), StateRef("agent", "a", "t"))


def doing(shown: list[int], states: list[int]) -> Doing:
    """A controller c, and agents x, y and z."""
    behavior = np.array([[-1], *[[s] for s in shown]], np.int32)
    state = np.array([[-1], *[[s] for s in states]], np.int32)
    rows = {"c": 0, "x": 1, "y": 2, "z": 3}
    return Doing(REFS, STATES, behavior, state, np.zeros((4, 0), np.bool_), (), rows, 1)


def point(tick: int, boxes: float = 0.0) -> Point:
    return Point(tick, {"boxes": boxes}, doing([0, 0, 1], [0, 1, -1]))


def test_memory_stays_bounded_and_the_points_even_however_long_it_goes_on() -> None:
    record = Record()
    for tick in range(20 * MOST_POINTS):
        record.add(point(tick))
    assert len(record.points) <= MOST_POINTS
    gaps = np.diff([p.tick for p in record.points])
    assert record.points[0].tick == 0
    assert record.points[-1].tick > 19 * MOST_POINTS
    assert gaps.max() <= 4 * gaps.min()


def test_going_back_forgets_what_came_after() -> None:
    record = Record()
    for tick in (0, 10, 20, 30):
        record.add(point(tick))
    before = record.version
    record.add(point(15))
    assert [p.tick for p in record.points] == [0, 10, 15]
    assert record.version > before


def test_shares_of_behaviors_are_of_agents_alone() -> None:
    lines = Lines(BehaviorShares())
    lines.follow([point(0)], 0)
    assert {key[-1]: lines.line(key)[1].tolist() for key in lines.keys} == {
        "A": [pytest.approx(2 / 3)],
        "Go": [pytest.approx(1 / 3)],
    }


def test_shares_of_states_are_of_the_nodes_that_run_the_automaton() -> None:
    lines = Lines(StateShares("agent", "a"))
    lines.follow([point(0)], 0)
    assert {key[-1]: lines.line(key)[1].tolist() for key in lines.keys} == {"s": [0.5], "t": [0.5]}


def test_a_group_counts_only_what_is_below_it() -> None:
    group = Node("c", "group", (Node("x", "agent"),))
    lines = Lines(BehaviorShares(), rows_below(group))
    lines.follow([point(0)], 0)
    assert {key[-1]: lines.line(key)[1].tolist() for key in lines.keys} == {"A": [1.0]}


def test_lines_grow_with_the_record_and_are_made_anew_when_it_thins_out() -> None:
    record, lines = Record(), Lines(MeasureOf("boxes"))
    for tick in range(3):
        record.add(point(tick, float(tick)))
        lines.follow(record.points, record.version)
    key = ("measure", "boxes")
    assert lines.line(key)[1].tolist() == [0.0, 1.0, 2.0]
    record.add(point(1, 5.0))
    lines.follow(record.points, record.version)
    assert lines.line(key)[1].tolist()[0] == 0.0
    assert len(lines.line(key)[0]) == len(record.points)


def test_a_measure_that_is_not_there_gives_no_line() -> None:
    lines = Lines(MeasureOf("none"))
    lines.follow([point(0)], 0)
    assert not lines.keys
