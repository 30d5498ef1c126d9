"""What all agents do over a run, as one picture: for each column of pixels, how large the share of each behavior is."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtGui import QColor, QImage

if TYPE_CHECKING:
    from ...sim.doing import BehaviorRef
    from ..record import Point

#: At most so many points are counted, and so many rows of pixels the picture has.
MOST, HIGH = 240, 32


@dataclass(frozen=True)
class Band:
    """A picture, and what was counted for it.

    Attributes:
        counts: How many agents showed each behavior, by tick.
        picture: None where there is nothing to show yet.
    """

    counts: Mapping[int, Mapping[BehaviorRef, int]] = field(default_factory=dict)
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
    counts = {
        p.tick: found if (found := before.counts.get(p.tick)) is not None else p.doing.counts() for p in some
    }
    order = sorted({ref for found in counts.values() for ref in found})
    table = np.array([[found.get(ref, 0) for ref in order] for found in counts.values()], np.float64)
    if not order:
        return Band(counts)
    ticks = np.linspace(*ends, width)
    columns = np.searchsorted(np.fromiter(counts, np.float64), ticks, side="right") - 1
    upto = np.cumsum(table / np.maximum(1.0, table.sum(axis=1, keepdims=True)), axis=1)[columns]
    heights = 1.0 - (np.arange(HIGH) + 0.5) / HIGH  # the first behavior is at the bottom
    which = (heights[:, None, None] > upto[None]).sum(axis=2)
    colors = np.array([look(ref)[1].rgb() for ref in order] + [0], np.uint32)
    pixels = np.ascontiguousarray(colors[which])
    image = QImage(pixels.tobytes(), width, HIGH, 4 * width, QImage.Format.Format_ARGB32)
    return Band(counts, image.copy())
