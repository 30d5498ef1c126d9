"""Where a window keeps what is its own and not the project's: its lock, and what it saves by itself.

That is a hidden folder inside the project's, which git is told to leave alone, so that it goes where the project goes.
Where nothing can be written, and for the projects that ship with Understudy, it is a folder in the user's own state.
"""

import contextlib
import os
import tempfile
from hashlib import blake2b
from pathlib import Path

from ...engine.shipped import is_shipped

NAME = ".understudy"
IGNORE = ".gitignore"
PROJECTS, UNNAMED = "projects", "unnamed"


def private_folder(folder: Path, state: Path) -> Path:
    """Where a window that has the project in *folder* open keeps what is its own.

    Args:
        state: The user's own folder for what programs keep from one start to the next.
    """
    if writable(folder) and not is_shipped(folder):
        return folder / NAME
    key = blake2b(os.fsencode(folder.resolve()), digest_size=8).hexdigest()
    return state / PROJECTS / f"{folder.resolve().name}-{key}"


def unnamed_folder(state: Path, token: str) -> Path:
    """The same for a project that no folder holds yet."""
    return state / UNNAMED / token


def make(private: Path) -> None:
    """Make such a folder."""
    private.mkdir(parents=True, exist_ok=True)
    if private.name == NAME and not (private / IGNORE).exists():
        (private / IGNORE).write_text("*\n", encoding="utf-8")


def clear(private: Path) -> None:
    """Remove such a folder if nothing but what `make` put there is in it."""
    with contextlib.suppress(OSError):
        if {path.name for path in private.iterdir()} <= {IGNORE}:
            (private / IGNORE).unlink(missing_ok=True)
            private.rmdir()


def writable(folder: Path) -> bool:
    """Whether files can be made in *folder*; tried out, since permissions do not tell the whole."""
    try:
        with tempfile.TemporaryFile(dir=folder):
            return True
    except OSError:
        return False


def write_whole(path: Path, text: str) -> None:
    """Give a file its content at once, so that nobody ever reads half of it."""
    beside = path.with_name(f".{path.name}.{os.getpid()}~")
    beside.write_text(text, encoding="utf-8")
    beside.replace(path)
