"""Things are worked out again where what they are made of is another value, and not otherwise."""

from app.core.remembered import Remembered

FIRST, EQUAL, OTHER = [1], [1], [2]


def test_the_very_same_values_give_what_is_remembered() -> None:
    remembered: Remembered[str, int] = Remembered()
    assert remembered.of("a", (FIRST, OTHER), lambda: 1) == 1
    assert remembered.of("a", (FIRST, OTHER), lambda: 2) == 1
    assert remembered.of("b", (FIRST, OTHER), lambda: 3) == 3


def test_another_value_counts_even_where_it_is_equal() -> None:
    remembered: Remembered[str, int] = Remembered()
    remembered.of("a", (FIRST,), lambda: 1)
    assert remembered.of("a", (EQUAL,), lambda: 2) == 2
    assert remembered.of("a", (EQUAL, OTHER), lambda: 3) == 3
    assert remembered.of("a", (EQUAL,), lambda: 4) == 4


def test_keys_that_are_gone_are_forgotten() -> None:
    remembered: Remembered[str, int] = Remembered()
    for key in ("a", "b"):
        remembered.of(key, (FIRST,), lambda: 1)
    remembered.keep(["b", "c"])
    assert remembered.of("a", (FIRST,), lambda: 2) == 2
    assert remembered.of("b", (FIRST,), lambda: 2) == 1
