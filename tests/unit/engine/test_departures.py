"""Remembering who left which state costs little: a moment a tick, and never more of them than fit."""

from collections.abc import Sequence

import pytest

from app.core.automaton import START
from app.core.examples import Moment
from app.engine.departures import MOST_NODES, MOST_UNASKED, Departure, Departures


class Camera:
    """Takes moments that say when."""

    def __init__(self) -> None:
        self.taken = 0

    def __call__(self) -> Moment:
        self.taken += 1
        return Moment("corridor", {}, "alone", {"taken": (self.taken,)})


def at(tick: int, state: str = "up") -> Departure:
    return Departure(state, {}, tick)


def test_the_moment_is_taken_once_a_tick_however_many_leave() -> None:
    camera = Camera()
    departures = Departures(camera, 50)
    for node in range(50):
        departures.note(f"agent-{node}", at(7))
    departures.note("agent-1", at(8))
    assert camera.taken == 2


def test_nothing_is_taken_while_nobody_leaves_anything_but_start() -> None:
    camera = Camera()
    departures = Departures(camera, 50)
    departures.note("agent-1", at(3, START))
    assert (camera.taken, departures.last("agent-1")) == (0, None)


def test_leaving_start_does_not_hide_what_was_left_before() -> None:
    departures = Departures(Camera(), 50)
    departures.note("agent-1", at(3))
    departures.note("agent-1", at(4, START))
    assert departures.last("agent-1") == at(3)


def test_what_was_mended_is_not_the_last_departure_any_more_unless_that_is_undone() -> None:
    departures = Departures(Camera(), 50)
    departures.note("agent-1", at(3))
    departures.mended("agent-1")
    assert departures.last("agent-1") is None
    departures.restore("agent-1", at(3))
    assert departures.last("agent-1") == at(3)


@pytest.mark.parametrize("nodes", [1, 2, 50, 100])
def test_every_nodes_last_departure_keeps_its_moment(nodes: int) -> None:
    departures = Departures(Camera(), nodes)
    for tick in range(20 * nodes):
        departures.note(f"agent-{tick * 7 % nodes}", at(tick))
    for node in range(nodes):
        last = departures.last(f"agent-{node}")
        if last is not None:
            assert departures.moment(last) is not None


@pytest.mark.parametrize("nodes", [50, 3125, 50_000])
def test_moments_never_describe_more_nodes_than_fit(nodes: int) -> None:
    camera = Camera()
    departures = Departures(camera, nodes)
    for tick in range(1000):
        departures.note(f"agent-{tick % nodes}", at(tick))
    kept = [tick for tick in range(1000) if departures.moment(at(tick)) is not None]
    assert len(kept) * nodes <= max(MOST_NODES, nodes)
    assert kept[-1] == 999  # the newest is always there


# ------------------------------------------------------------------------------ ticks that are looked back on


class Tick:
    """A compiled tick that has passed; it counts how often it is asked."""

    def __init__(self, tick: int, *nodes: str) -> None:
        self.tick = tick
        self.nodes: Sequence[str] = nodes
        self.asked: list[str] = []

    def departure(self, node_id: str) -> Departure:
        self.asked.append(node_id)
        return at(self.tick)

    def moment(self) -> Moment:
        self.asked.append("moment")
        return Moment("corridor", {}, "alone", {"tick": (self.tick,)})


def test_what_nobody_asks_for_is_not_found_out() -> None:
    departures, tick = Departures(Camera(), 50), Tick(7, "agent-1", "agent-2")
    departures.note_unasked(tick)
    assert tick.asked == []
    for _ in range(2):
        left = departures.last("agent-2")
        assert left == at(7)
        assert departures.moment(left) == Moment("corridor", {}, "alone", {"tick": (7,)})
    assert tick.asked == ["agent-2", "moment"]


def test_what_nodes_saw_outlives_the_ticks_that_are_too_many() -> None:
    nodes = MOST_UNASKED  # so many that a single tick fits
    departures = Departures(Camera(), nodes)
    first, second = Tick(1, "agent-1", "agent-2"), Tick(2, "agent-2")
    departures.note_unasked(first)
    departures.note_unasked(second)
    assert first.asked == ["agent-1"]  # agent-2 has left again since
    assert departures.last("agent-1") == at(1)
    assert departures.last("agent-2") == at(2)


def test_the_newest_departure_counts_whichever_way_it_was_noted() -> None:
    departures = Departures(Camera(), 50)
    departures.note_unasked(Tick(1, "agent-1"))
    departures.note("agent-1", at(2))
    assert departures.last("agent-1") == at(2)
    departures.note_unasked(Tick(3, "agent-1"))
    assert departures.last("agent-1") == at(3)
