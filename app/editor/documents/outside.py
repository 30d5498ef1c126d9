"""Noticing what others did to a project's files while it was open, such as `git pull`."""

from collections.abc import Mapping
from dataclasses import dataclass
from hashlib import blake2b
from pathlib import Path

from ...core.storage.layout import documents, moment_files
from ...engine.scenarios import OWN_CODE

PROJECT_FILE = "project.json"


@dataclass(frozen=True, slots=True)
class Stamp:
    """What tells one content of a file from another.

    Attributes:
        changed: Nanoseconds; with the size it says quickly that nothing has happened.
        digest: Of the content.
    """

    changed: int
    size: int
    digest: bytes


#: Files of a project by their paths within its folder.
Stamps = Mapping[str, Stamp]


def stamps_of(folder: Path, known: Stamps | None = None) -> Stamps:
    """The files that make up the project in *folder*.

    Args:
        known: Earlier stamps; files that look as they did then are not read again.
    """
    names = [PROJECT_FILE, OWN_CODE, *documents(folder, lambda _path, _error: None), *moment_files(folder)]
    found = {name: _stamp(folder / name, (known or {}).get(name)) for name in names}
    return {name: stamp for name, stamp in found.items() if stamp is not None}


def _stamp(path: Path, known: Stamp | None) -> Stamp | None:
    try:
        status = path.stat()
        if known is not None and (known.changed, known.size) == (status.st_mtime_ns, status.st_size):
            return known
        digest = blake2b(path.read_bytes(), digest_size=16).digest()
    except OSError:
        return None
    return Stamp(status.st_mtime_ns, status.st_size, digest)


def changes(before: Stamps, after: Stamps) -> tuple[str, ...]:
    """Files that came, went, or have another content, in words: "changed: project.json"."""
    words = []
    for name in sorted({*before, *after}):
        if name not in after:
            words.append(f"removed: {name}")
        elif name not in before:
            words.append(f"new: {name}")
        elif before[name].digest != after[name].digest:
            words.append(f"changed: {name}")
    return tuple(words)
