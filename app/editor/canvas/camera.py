"""Where the canvas looks: from places in the world to pixels of the view and back; no Qt."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

#: Numbers, or arrays of them.
Places = TypeVar("Places", float, NDArray[np.float64])

#: How far one can go from the scale that fits, outward and inward.
OUT, IN = 1 / 16, 400.0


@dataclass(frozen=True, slots=True)
class Extent:
    """A rectangle of the world, in its units."""

    left: float
    bottom: float
    right: float
    top: float

    @property
    def width(self) -> float:
        """From left to right."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """From bottom to top."""
        return self.top - self.bottom

    def united(self, other: Extent) -> Extent:
        """The smallest rectangle around both."""
        return Extent(
            min(self.left, other.left),
            min(self.bottom, other.bottom),
            max(self.right, other.right),
            max(self.top, other.top),
        )


@dataclass(frozen=True, slots=True)
class Margins:
    """Pixels at the edges of the view in which nothing of the world has to be."""

    left: float = 16.0
    top: float = 16.0
    right: float = 16.0
    bottom: float = 16.0


@dataclass(frozen=True, slots=True)
class Camera:
    """Looks straight down, y upward in the world and downward in the view.

    Attributes:
        x, y: Place in the world that is in the middle of the view, units.
        scale: Pixels to a unit.
        width, height: Of the view, pixels.
    """

    x: float = 0.0
    y: float = 0.0
    scale: float = 1.0
    width: float = 1.0
    height: float = 1.0

    def to_view(self, x: Places, y: Places) -> tuple[Places, Places]:
        """Pixels of places in the world."""
        return self.width / 2 + (x - self.x) * self.scale, self.height / 2 - (y - self.y) * self.scale

    def to_world(self, x: float, y: float) -> tuple[float, float]:
        """The place in the world of a pixel."""
        return self.x + (x - self.width / 2) / self.scale, self.y - (y - self.height / 2) / self.scale

    def shown(self) -> Extent:
        """What of the world is in view."""
        left, bottom = self.to_world(0.0, self.height)
        right, top = self.to_world(self.width, 0.0)
        return Extent(left, bottom, right, top)

    def resized(self, width: float, height: float) -> Camera:
        """The same place in the middle of a view of another size."""
        return replace(self, width=max(width, 1.0), height=max(height, 1.0))

    def moved(self, dx: float, dy: float) -> Camera:
        """The world shifted by pixels."""
        return replace(self, x=self.x - dx / self.scale, y=self.y + dy / self.scale)

    def centered(self, x: float, y: float) -> Camera:
        """Another place in the middle."""
        return replace(self, x=x, y=y)

    def zoomed(self, factor: float, x: float, y: float, fitting: float) -> Camera:
        """Larger by *factor*; what is at a pixel stays there.

        Args:
            fitting: The scale at which the world fits the view; limits are around it.
        """
        scale = min(max(self.scale * factor, fitting * OUT), fitting * IN)
        before = self.to_world(x, y)
        after = replace(self, scale=scale).to_world(x, y)
        return replace(self, scale=scale, x=self.x + before[0] - after[0], y=self.y + before[1] - after[1])

    def fitted(self, extent: Extent, margins: Margins = Margins()) -> Camera:
        """All of *extent* in view, as large as it can be between the margins."""
        across = max(self.width - margins.left - margins.right, 1.0)
        down = max(self.height - margins.top - margins.bottom, 1.0)
        scale = min(across / max(extent.width, 1e-9), down / max(extent.height, 1e-9))
        x, y = (extent.left + extent.right) / 2, (extent.bottom + extent.top) / 2
        aside = (margins.right - margins.left) / 2 / scale, (margins.top - margins.bottom) / 2 / scale
        return replace(self, scale=scale, x=x + aside[0], y=y + aside[1])
