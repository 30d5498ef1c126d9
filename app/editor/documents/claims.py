"""Who has a project open: a lock file that names its owner, so that two windows do not overwrite each other's work."""

import contextlib
import errno
import fcntl
import json
import os
import platform
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path
from uuid import uuid4

from . import private

LOCK = "lock"
#: How often a folder is looked for that others make and remove.
TRIES = 1_000


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
    with _alone_in(folder, make=True):
        holder = holder_of(folder)
        if holder is not None and holder.lives and holder.token != owner.token:
            return holder
        private.write_whole(folder / LOCK, json.dumps(asdict(owner)))
        return None


@contextmanager
def _alone_in(folder: Path, *, make: bool) -> Iterator[None]:
    """While this lasts no other window claims what a private folder is of, or gives it free.

    Between looking at a lock and writing one, somebody else could do the same, and both would have the project.
    """
    there = _held(folder, make=make)
    try:
        yield
    finally:
        os.close(there)


def _held(folder: Path, *, make: bool) -> int:
    """A private folder, opened and held; it is made if need be, also where who held it before has just removed it.

    Raises:
        OSError: It is not there, or cannot be.
    """
    for _ in range(TRIES):
        with contextlib.suppress(FileExistsError, FileNotFoundError):  # it goes as others come
            if make:
                private.make(folder)
            there = os.open(folder, os.O_RDONLY)
            with contextlib.suppress(OSError):  # on a file system that cannot do it
                fcntl.flock(there, fcntl.LOCK_EX)
            if _is_still(folder, there):
                return there
            os.close(there)
    raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(folder))


def _is_still(folder: Path, there: int) -> bool:
    try:
        return os.path.samestat(os.fstat(there), folder.stat())
    except FileNotFoundError:
        return False


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
    with contextlib.suppress(OSError), _alone_in(folder, make=False):
        holder = holder_of(folder)
        if holder is not None and holder.token == owner.token:
            (folder / LOCK).unlink()
        private.clear(folder)
