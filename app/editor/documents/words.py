"""Times, counts and owners as the user reads them."""

import platform
from datetime import datetime

from .claims import Owner


def clock(at: datetime, now: datetime | None = None) -> str:
    """A time of today as 20:41, otherwise with its day: "3 May, 20:41"."""
    today = (now or datetime.now().astimezone()).date()
    hours = f"{at:%H:%M}"
    if at.date() == today:
        return hours
    year = f" {at.year}" if at.year != today.year else ""
    return f"{at.day} {at:%B}{year}, {hours}"


def whose(owner: Owner) -> str:
    """Where another window is, and since when."""
    try:
        since = f" since {clock(datetime.fromisoformat(owner.since))}"
    except ValueError:
        since = ""
    if owner.host == platform.node():
        return f"in process {owner.pid} on this machine{since}"
    return f"on {owner.host}, in process {owner.pid}{since}"
