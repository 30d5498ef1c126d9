"""Where agents have been."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from app.editor.canvas.trails import MOST, SEEN, Trails
from tests.corridor import corridor, project
from tests.unit.editor.canvas.worlds import scene

FIRST = scene(project(), corridor, "alone")


def walked(trails: Trails, *ticks: int) -> list[float]:
    """Where the first agent has been, if it was at place 10 k in tick k."""
    for tick in ticks:
        trails.add(replace(FIRST, tick=tick, columns={**FIRST.columns, "x": np.full(3, 10.0 * tick)}))
    return [float(x) for x in trails.of(np.array([0]))[0][:, 0]]


def test_places_are_remembered_in_order() -> None:
    assert walked(Trails(), 0, 3, 4) == [0.0, 30.0, 40.0]


def test_going_back_in_time_forgets_what_came_later() -> None:
    assert walked(Trails(), 0, 3, 4, 9, 3) == [0.0, 30.0]


def test_another_world_begins_with_no_trails() -> None:
    trails = Trails()
    walked(trails, 0, 1, 2)
    trails.add(scene(project(), corridor, "alone"))
    assert len(trails.of(np.array([0]))[0]) == 1


def test_memory_is_bounded() -> None:
    assert len(walked(Trails(), *range(2 * MOST))) == MOST


def test_only_the_newest_places_can_be_asked_for_also_after_going_back_round_the_ring() -> None:
    trails = Trails()
    walked(trails, *range(MOST + 7), MOST - 3, MOST)
    x, y = trails.of(np.array([0, 0]), 3)
    assert x[:, 0].tolist() == [10.0 * (MOST - 4), 10.0 * (MOST - 3), 10.0 * MOST]
    assert x.shape == y.shape == (3, 2)


def test_who_has_been_nowhere_has_no_trail() -> None:
    assert [values.shape for values in Trails().of(np.arange(3))] == [(0, 3), (0, 3)]


def test_the_way_is_told_only_where_few_ticks_have_passed_between_two_places() -> None:
    trails = Trails()
    walked(trails, 0, SEEN, 2 * SEEN + 1, 2 * SEEN + 2)
    assert trails.are_ways().tolist() == [True, False, True]
    assert trails.are_ways(2).tolist() == [True]
    assert trails.are_ways(1).tolist() == Trails().are_ways().tolist() == []
