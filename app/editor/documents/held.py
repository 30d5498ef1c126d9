"""What a window knows about the folder of the project that it has open."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ...core.project import Project
from .outside import Stamps


@dataclass(frozen=True, slots=True)
class Held:
    """Where an open project is kept.

    Attributes:
        folder: The project's; None if none holds it yet.
        private: Where the window keeps what is its own; see `private`.
        base: What the folder is known to hold; None if that has to be found out when saving.
        stamps: Its files as they were when they were last read or written here; None if that is unknown.
        claimed: Whether the lock is this window's.
        read_only: Whether the user wanted to look only: then saving asks for another folder.
    """

    folder: Path | None = None
    private: Path | None = None
    base: Project | None = None
    stamps: Stamps | None = None
    claimed: bool = False
    read_only: bool = False


#: Goes on once a question is answered.
Then = Callable[[], Any]
