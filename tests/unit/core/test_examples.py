"""Examples: thousands of them are changed at once, and are what one by one would have made of them."""

from dataclasses import FrozenInstanceError, fields, replace
from itertools import repeat

import pytest

from app.core.examples import Example, changed

EXAMPLES = tuple(
    Example(str(k), "forward", "left", {"distance": float(k)}, enabled=k % 2 == 0, tick=k, pick=k)
    for k in range(5)
)


def test_copies_differ_in_what_was_given_and_in_nothing_else() -> None:
    weights = [1.5 + k for k in range(5)]
    copies = changed(EXAMPLES, label=repeat("right"), weight=weights)
    assert copies == tuple(
        replace(example, label="right", weight=weight)
        for example, weight in zip(EXAMPLES, weights, strict=True)
    )
    assert EXAMPLES[0].label == "left"


def test_a_copy_is_an_example_like_any_other() -> None:
    (copy,) = changed(EXAMPLES[:1])
    assert copy == EXAMPLES[0]
    assert copy is not EXAMPLES[0]
    assert {each.name for each in fields(copy)} == {each.name for each in fields(Example)}
    with pytest.raises(FrozenInstanceError):
        copy.label = "right"  # type: ignore[misc]  # that is tried


def test_of_no_examples_there_are_no_copies() -> None:
    assert changed((), enabled=()) == ()
