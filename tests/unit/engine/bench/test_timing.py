"""Timings: the least counts, rivals take turns, making ready is not timed."""

from collections.abc import Callable
from itertools import cycle

import pytest

from app.engine.bench.timing import least, ratio, side_by_side, taking_turns


class Watch:
    """A clock that only work moves."""

    def __init__(self) -> None:
        self.now = 0.0
        self.did: list[str] = []

    def __call__(self) -> float:
        return self.now

    def work(self, name: str, *seconds: float) -> Callable[[], None]:
        """Work that takes so long, each time in turn."""
        takes = cycle(seconds)

        def do() -> None:
            self.did.append(name)
            self.now += next(takes)

        return do


def test_the_shortest_of_several_times_counts() -> None:
    watch = Watch()
    work = watch.work("a", 5.0, 3.0, 4.0)
    assert least(lambda: work, 3, watch) == 3.0


def test_of_each_piece_the_shortest_time_counts() -> None:
    watch = Watch()
    work = watch.work("a", 5.0, 1.0, 2.0, 9.0)
    assert least(lambda: work, 2, watch, pieces=2) == 2.0 + 1.0


def test_making_ready_is_not_timed() -> None:
    watch = Watch()
    work = watch.work("a", 1.0)

    def prepare() -> Callable[[], None]:
        watch.now += 100.0
        return work

    assert least(prepare, 2, watch) == 1.0


def test_rivals_take_turns() -> None:
    watch = Watch()
    a, b = watch.work("a", 4.0, 6.0), watch.work("b", 3.0, 2.0)
    assert taking_turns([lambda: a, lambda: b], 2, watch) == [4.0, 2.0]
    assert watch.did == ["a", "b", "a", "b"]


def test_a_ratio_is_of_sums_of_the_shortest_times() -> None:
    watch = Watch()
    first = [watch.work("a", 4.0), watch.work("b", 8.0)]
    second = [watch.work("c", 1.0), watch.work("d", 3.0)]
    found = ratio([lambda w=w: w for w in first], [lambda w=w: w for w in second], 2, watch)  # type: ignore[misc]  # mypy gives no type to lambdas with defaults
    assert found == 3.0


@pytest.mark.parametrize("pairs", [3, 5])
def test_side_by_side_the_median_counts_and_who_begins_takes_turns(pairs: int) -> None:
    watch = Watch()
    a, b = watch.work("a", 2.0, 2.0, 50.0), watch.work("b", 1.0)
    assert side_by_side(a, b, pairs, watch) == 2.0
    assert watch.did[:6] == ["a", "b", "b", "a", "a", "b"]
