"""Who has a project open: a lock file that names its owner, so that two windows do not overwrite each other's work."""

import contextlib
import json
import os
import platform
from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path
from uuid import uuid4

from . import private

LOCK = "lock"


@dataclass(frozen=True, slots=True)
class Owner:
    """A window.

    Attributes:
        started: When its process began, as the system counts; "" where it does not say. It tells a process from a later
            one with the same number.
        since: When it opened the project, for the user to read.
        token: No other window has this one.
    """

    pid: int
    host: str
    started: str
    since: str
    token: str

    @property
    def lives(self) -> bool:
        """Whether the window may still be there. Of other machines nobody knows, so theirs are."""
        if self.host != platform.node():
            return True
        return _runs(self.pid) and process_start(self.pid) == self.started


def new_owner() -> Owner:
    """This process, as the owner of one more window."""
    since = datetime.now().astimezone().isoformat(timespec="seconds")
    return Owner(os.getpid(), platform.node(), process_start(os.getpid()), since, uuid4().hex)


def process_start(pid: int) -> str:
    """When a process began, in the system's own count; "" where it does not say or there is none."""
    try:
        stat = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""
    return stat.rpartition(")")[2].split()[19]  # the name before it may hold anything


def _runs(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except OSError:
        return True  # somebody else's
    return True


def claim(folder: Path, owner: Owner) -> Owner | None:
    """Say in the private folder *folder* that *owner* has the project open.

    A lock whose process is gone is taken over.

    Returns:
        Who has it already, if somebody has; nothing is changed then.

    Raises:
        OSError: The lock cannot be written.
    """
    private.make(folder)
    path = folder / LOCK
    text = json.dumps(asdict(owner))
    while True:
        try:
            with path.open("x", encoding="utf-8") as file:
                file.write(text)
            return None
        except FileExistsError:
            holder = holder_of(folder)
            if holder is not None and holder.lives and holder.token != owner.token:
                return holder
            path.unlink(missing_ok=True)


def take_over(folder: Path, owner: Owner) -> None:
    """Claim a project although somebody else has it."""
    private.make(folder)
    private.write_whole(folder / LOCK, json.dumps(asdict(owner)))


def holder_of(folder: Path) -> Owner | None:
    """Who has claimed the project; None if nobody has, or nobody can tell who."""
    return read_owner(folder / LOCK)


def read_owner(path: Path) -> Owner | None:
    """The owner whom a file names, if it does."""
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
        names = Owner.__dataclass_fields__
        return Owner(**{name: found[name] for name in names})
    except (OSError, ValueError, TypeError, KeyError):
        return None


def release(folder: Path, owner: Owner) -> None:
    """Give a project free, if *owner* still has it."""
    holder = holder_of(folder)
    if holder is not None and holder.token == owner.token:
        with contextlib.suppress(OSError):
            (folder / LOCK).unlink()
    private.clear(folder)
