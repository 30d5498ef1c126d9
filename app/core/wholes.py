"""What is done as a whole or not at all, so that nobody who ends the program at once does it halfway."""

from collections.abc import Iterator
from contextlib import contextmanager

#: What is being done as a whole just now.
_under_way: list[object] = []


@contextmanager
def as_a_whole() -> Iterator[None]:
    """What is done while this lasts takes no time, and is not to be cut off."""
    this = object()
    _under_way.append(this)
    try:
        yield
    finally:
        _under_way.remove(this)


def may_be_cut_off() -> bool:
    """Whether nothing is under way that has to be done as a whole."""
    return not _under_way
