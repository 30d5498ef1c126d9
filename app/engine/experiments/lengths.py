"""What the files of an experiment's results are called: runs of another length than it says have files of their own."""

import re
from pathlib import Path

ENDING = ".sqlite"
_OTHER = "{name}-{ticks}-ticks"


def results_stem(name: str, other_ticks: int | None = None) -> str:
    """What the files of the experiment *name* are called without their ending.

    Args:
        other_ticks: How long its runs take, where that is not as long as it says.
    """
    return name if other_ticks is None else _OTHER.format(name=name, ticks=other_ticks)


def other_lengths(name: str, folder: Path) -> list[int]:
    """The ticks of runs that are not as long as the experiment *name* says, and of which *folder* has results."""
    pattern = _OTHER.format(name=re.escape(name), ticks="([0-9]+)")
    found = (re.fullmatch(pattern, path.stem) for path in folder.glob(f"*{ENDING}"))
    return sorted(int(match[1]) for match in found if match)
