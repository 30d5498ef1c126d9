"""What is done over a run, as pictures: each column of pixels is a moment, however many moments there are."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtGui import QColor, QImage

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ...sim.doing import BehaviorRef
    from ..record import Point

#: At most so many points are counted, and so many rows of pixels the picture of all agents has.
MOST, HIGH = 240, 32
#: From so many pixels on, something that is done has a pause after it, and from so many on it is drawn by itself.
PAUSED, WIDE = 4, 16


@dataclass(frozen=True, eq=False)
class Band:
    """What all agents do, as one picture: for each column of pixels, how large the share of each behavior is.

    Attributes:
        points: What was counted, and *behaviors* what was found.
        counts: Points x behaviors: how many agents showed each.
        picture: None where there is nothing to show yet.
    """

    points: Sequence[Point] = ()
    behaviors: Sequence[BehaviorRef] = ()
    counts: NDArray[np.int64] = field(default_factory=lambda: np.zeros((0, 0), np.int64))
    picture: QImage | None = None


def band_of(
    points: Sequence[Point],
    ends: tuple[int, int],
    width: int,
    look: Callable[[BehaviorRef], tuple[str, QColor]],
    before: Band,
) -> Band:
    """The picture of these points, *width* pixels from the first tick to the last; what was counted *before* is kept."""
    if len(points) < 2 or width < 1:
        return Band()
    some = points[:: -(-len(points) // MOST)]
    behaviors, counts = _counted(some, before)
    if not behaviors:
        return Band(some)
    upto = np.cumsum(counts / np.maximum(1, counts.sum(axis=1, keepdims=True)), axis=1)
    heights = 1.0 - (np.arange(HIGH) + 0.5) / HIGH  # the first behavior is at the bottom
    which = (heights[:, None, None] > upto[None]).sum(axis=2)
    colors = np.array([look(ref)[1].rgb() for ref in behaviors] + [0], np.uint32)
    return Band(some, behaviors, counts, _image(colors[which[:, _columns(some, ends, width)]]))


def _counted(some: Sequence[Point], before: Band) -> tuple[Sequence[BehaviorRef], NDArray[np.int64]]:
    known = {id(point): row for row, point in enumerate(before.points)}
    rows = np.array([known.get(id(point), -1) for point in some])
    new = {row: some[row].doing.counts() for row in np.flatnonzero(rows < 0).tolist()}
    behaviors = sorted({*before.behaviors, *(ref for found in new.values() for ref in found)})
    place = {ref: column for column, ref in enumerate(behaviors)}
    counts = np.zeros((len(some), len(behaviors)), np.int64)
    kept, columns = np.flatnonzero(rows >= 0), np.array([place[ref] for ref in before.behaviors], np.int64)
    counts[np.ix_(kept, columns)] = before.counts[rows[kept]]
    for row, found in new.items():
        for ref, count in found.items():
            counts[row, place[ref]] = count
    shown = np.flatnonzero(counts.any(axis=0))
    return [behaviors[column] for column in shown.tolist()], counts[:, shown]


# ------------------------------------------------------------------------------------------------------ one node


@dataclass(frozen=True, eq=False)
class Line:
    """What one node does.

    Attributes:
        picture: All that is short.
        wide: What is long enough for words: the first column of pixels, the one after the last, and the number of what is done.
    """

    picture: QImage
    wide: tuple[tuple[int, int, int], ...]


def line_of(
    points: Sequence[Point], codes: Sequence[int], ends: tuple[int, int], width: int, colors: Sequence[int]
) -> Line:
    """The picture of what one node does.

    Args:
        codes: What it does at each of the points, as a number.
        colors: Of these numbers, as Qt writes them (ARGB); 0 for what is not drawn.
    """
    columns = np.asarray(codes, np.int64)[_columns(points, ends, width)]
    starts = np.flatnonzero(np.diff(columns, prepend=-1))
    stops = np.append(starts[1:], width)
    lengths = stops - starts
    drawn = np.asarray(colors, np.uint32)
    pixels = drawn[columns]
    pixels[stops[lengths >= PAUSED] - 1] = 0
    pixels[np.repeat(lengths >= WIDE, lengths)] = 0
    wide = (lengths >= WIDE) & (drawn[columns[starts]] != 0)
    runs = zip(starts[wide].tolist(), stops[wide].tolist(), columns[starts[wide]].tolist(), strict=True)
    return Line(_image(pixels[None]), tuple(runs))


def _columns(points: Sequence[Point], ends: tuple[int, int], width: int) -> NDArray[np.int64]:
    """Which of the points each column of pixels shows."""
    ticks = np.fromiter((point.tick for point in points), np.float64, len(points))
    return np.searchsorted(ticks, np.linspace(*ends, width), side="right") - 1


def _image(pixels: NDArray[np.uint32]) -> QImage:
    kept = np.ascontiguousarray(pixels)
    high, wide = kept.shape
    return QImage(kept.tobytes(), wide, high, 4 * wide, QImage.Format.Format_ARGB32).copy()
