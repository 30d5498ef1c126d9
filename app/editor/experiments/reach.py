"""How much of the height of curves and their bands is shown."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

#: Of the height that the lines take, bands are shown so far above and below them: of two runs, a band may be ten times
#: as high as the lines, which could not be told apart then.
BEYOND = 0.5

Line = NDArray[np.float64]


def reach(means: Sequence[Line], bands: Sequence[Line]) -> tuple[tuple[float, float], bool]:
    """From where to where curves are shown, and whether bands go on beyond that.

    Args:
        bands: Half the width of each; not a number where there is only one run.
    """
    middle, half = np.stack(means), np.nan_to_num(np.stack(bands))
    low, high = float(middle.min()), float(middle.max())
    lowest, highest = float((middle - half).min()), float((middle + half).max())
    room = BEYOND * (high - low) or 1.0
    bottom, top = max(lowest, low - room), min(highest, high + room)
    return (bottom, top if top > bottom else bottom + 1.0), lowest < bottom or highest > top
