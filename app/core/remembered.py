"""Working things out again only where what they are made of is another value."""

from collections.abc import Callable, Collection
from typing import Generic, TypeVar

Key = TypeVar("Key")
Made = TypeVar("Made")


class Remembered(Generic[Key, Made]):
    """What was worked out for each key, as long as all that it was made of are the very same values.

    Values never change and edits share what they leave alone, so asking whether it is the very same one is enough, and
    as quick for ten thousand examples as for one.
    """

    def __init__(self) -> None:
        self._known: dict[Key, tuple[tuple[object, ...], Made]] = {}

    def of(self, key: Key, made_of: tuple[object, ...], make: Callable[[], Made]) -> Made:
        """What *make* gave for *key* when it was made of the same values; otherwise what it gives now."""
        known = self._known.get(key)
        if known is None or not _same(known[0], made_of):
            known = self._known[key] = made_of, make()
        return known[1]

    def keep(self, keys: Collection[Key]) -> None:
        """Forget all keys but these."""
        for gone in self._known.keys() - set(keys):
            del self._known[gone]


def _same(before: tuple[object, ...], now: tuple[object, ...]) -> bool:
    return len(before) == len(now) and all(old is new for old, new in zip(before, now, strict=True))
