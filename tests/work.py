"""How much is done, told without a clock: the same number on every machine, however busy."""

import sys
from collections.abc import Callable
from types import FrameType
from typing import Any


def calls(do: Callable[[], object]) -> int:
    """How many functions written in Python are called while *do* goes on, in this thread."""
    called = 0

    def count(_frame: FrameType, event: str, _arg: Any) -> None:
        nonlocal called
        called += event == "call"

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        do()
    finally:
        sys.setprofile(before)
    return called
