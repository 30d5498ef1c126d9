"""Who works beside the window does so one at a time."""

from collections.abc import Callable
from threading import Event, Thread

import pytest

from app.engine.turns import Turns

PATIENCE = 60.0


def never() -> bool:
    return False


def begun(work: Callable[[], object]) -> Thread:
    thread = Thread(target=work)
    thread.start()
    return thread


def test_who_asks_for_the_turn_waits_until_the_other_has_ended() -> None:
    turns, order = Turns(PATIENCE), list[str]()
    working, may_end = Event(), Event()

    def first(_question: str, _cancelled: Callable[[], bool]) -> None:
        working.set()
        assert may_end.wait(PATIENCE)
        order.append("first")

    def second(question: str, _cancelled: Callable[[], bool]) -> str:
        order.append("second")
        return question

    one = begun(lambda: turns.taken(first)("", never))
    assert working.wait(PATIENCE)
    other = begun(lambda: turns.taken(second)("", never))
    may_end.set()
    one.join(PATIENCE)
    other.join(PATIENCE)
    assert order == ["first", "second"]


def test_who_has_waited_long_goes_on_all_the_same() -> None:
    turns = Turns(0.0)

    def inner(question: int, _cancelled: Callable[[], bool]) -> int:
        return question + 1

    def outer(question: int, cancelled: Callable[[], bool]) -> int:
        return 2 * turns.taken(inner)(question, cancelled)

    assert turns.taken(outer)(1, never) == 4
    assert turns.taken(outer)(2, never) == 6  # who had no turn has given none away


def test_who_is_cancelled_waits_no_longer() -> None:
    turns = Turns(PATIENCE)
    given_up = Event()

    def waiting(_question: str, cancelled: Callable[[], bool]) -> bool:
        return cancelled()

    def working(_question: str, _cancelled: Callable[[], bool]) -> list[bool]:
        found = list[bool]()
        other = begun(lambda: found.append(turns.taken(waiting)("", given_up.is_set)))
        given_up.set()
        other.join(PATIENCE / 2)
        return found

    assert turns.taken(working)("", never) == [True]


def test_the_turn_is_given_back_by_work_that_breaks_down() -> None:
    turns = Turns(PATIENCE)

    def broken(_question: str, _cancelled: Callable[[], bool]) -> None:
        raise ZeroDivisionError

    for _ in range(2):
        with pytest.raises(ZeroDivisionError):
            turns.taken(broken)("", never)
