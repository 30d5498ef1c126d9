"""Times, counts and owners as the user reads them."""

import platform
from datetime import datetime
from os.path import lexists
from pathlib import Path

from .claims import Owner


def clock(at: datetime, now: datetime | None = None) -> str:
    """A time of today as 20:41, otherwise with its day: "3 May, 20:41"."""
    today = (now or datetime.now().astimezone()).date()
    hours = f"{at:%H:%M}"
    if at.date() == today:
        return hours
    year = f" {at.year}" if at.year != today.year else ""
    return f"{at.day} {at:%B}{year}, {hours}"


def unclaimed(private: Path, error: OSError) -> str:
    """Why a project could not be claimed, what that means, and how it is mended."""
    if lexists(private) and not private.is_dir():
        why = f"{private} is a file, where Understudy needs a folder of that name"
    else:
        why = f"{private} cannot be written to ({error.strerror or error})"
    return f"{why}: other windows are not told that this one has the project open. Rename or remove it, then reload."


def whose(owner: Owner) -> str:
    """Where another window is, and since when."""
    try:
        since = f" since {clock(datetime.fromisoformat(owner.since))}"
    except ValueError:
        since = ""
    if owner.host == platform.node():
        return f"in process {owner.pid} on this machine{since}"
    return f"on {owner.host}, in process {owner.pid}{since}"
