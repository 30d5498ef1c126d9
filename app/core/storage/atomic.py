"""Changing several files of a folder, all or nothing.

New files are written beside the old ones under other names and brought to the disk first; a full disk or a missing
permission shows then, when nothing has changed yet. Only then are they renamed, one after the other. If a rename fails,
the ones before it are taken back. If the machine stops in between, every file is either the old or the new one, whole.
"""

import contextlib
import fcntl
import os
import re
import shutil
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from ..wholes import as_a_whole

#: A file while it is written, and an old one until all are renamed.
NEW, OLD = "new", "old"
UNFINISHED = re.compile(r"\..+\.\d+\.(new|old)~")


class WriteError(Exception):
    """The system refused; *path* is what could not be written, and nothing has changed."""

    def __init__(self, path: Path, error: OSError) -> None:
        super().__init__(f"{path}: {error}")
        self.path = path
        self.error = error


@contextlib.contextmanager
def locked(folder: Path, *, for_writing: bool) -> Iterator[None]:
    """While this is entered, no other program saves into *folder* (or loads from it, if *for_writing*)."""
    handle = os.open(folder, os.O_RDONLY)
    try:
        with contextlib.suppress(OSError):  # some network file systems know no locks
            fcntl.flock(handle, fcntl.LOCK_EX if for_writing else fcntl.LOCK_SH)
        yield
    finally:
        os.close(handle)


def clear_unfinished(folders: Iterable[Path]) -> None:
    """Remove what a save left in *folders* when the machine stopped; only while no other program saves there."""
    for folder in folders:
        for path in _unfinished(folder):
            with contextlib.suppress(OSError):
                path.unlink()


def _unfinished(folder: Path) -> list[Path]:
    try:
        return [path for path in folder.iterdir() if UNFINISHED.fullmatch(path.name)]
    except OSError:
        return []


def change_files(contents: Mapping[Path, bytes], gone: Iterable[Path]) -> None:
    """Give files their new contents, in this order, then remove those in *gone*, in theirs.

    Raises:
        WriteError: Something could not be done; the files are as they were.
    """
    change = _Change(contents, gone)
    with as_a_whole():
        try:
            change.prepare()
            change.commit()
        except BaseException:
            change.take_back()
            raise
        finally:
            change.clear()


class _Change:
    """One change of several files while it is made."""

    def __init__(self, contents: Mapping[Path, bytes], gone: Iterable[Path]) -> None:
        self._contents = contents
        self._gone = tuple(gone)
        self._folders: list[Path] = []
        self._old = {path: _beside(path, OLD) for path in (*contents, *self._gone) if os.path.lexists(path)}
        self._new = {path: _beside(path, NEW) for path in contents}
        self._touched: list[Path] = []
        self._committed = False

    def prepare(self) -> None:
        """Bring all that is to be written to the disk, without changing a file."""
        for path, data in self._contents.items():
            with _naming(path):
                self._make_folder(path.parent)
                _write(self._new[path], data, like=path)
        for path in self._contents:  # in a loop of its own, so that the disk can take many at once
            with _naming(path):
                _sync(self._new[path])
        for path, kept in self._old.items():
            with _naming(path):
                _keep(path, kept)

    def commit(self) -> None:
        """Rename and remove; bring that to the disk."""
        for path in self._contents:
            with _naming(path):
                self._touched.append(path)
                self._new[path].replace(path)
        for path in self._gone:
            with _naming(path):
                self._touched.append(path)
                path.unlink(missing_ok=True)
        for folder in sorted({path.parent for path in self._touched} | {f.parent for f in self._folders}):
            with _naming(folder):
                _sync(folder)
        self._committed = True

    def take_back(self) -> None:
        """Undo as much of the commit as was done."""
        for path in reversed(self._touched):
            with contextlib.suppress(OSError):
                if path in self._old:
                    self._old[path].replace(path)
                else:
                    path.unlink()

    def clear(self) -> None:
        """Remove all that only helped, and the folders that the removed files leave empty."""
        for path in (*self._new.values(), *self._old.values()):
            with contextlib.suppress(OSError):
                path.unlink()
        emptied = {path.parent for path in self._gone} if self._committed else set(self._folders)
        for folder in sorted(emptied, reverse=True):
            with contextlib.suppress(OSError):
                folder.rmdir()

    def _make_folder(self, folder: Path) -> None:
        missing = [above for above in (folder, *folder.parents) if not above.exists()]
        for above in reversed(missing):
            above.mkdir(exist_ok=True)
            self._folders.append(above)


@contextlib.contextmanager
def _naming(path: Path) -> Iterator[None]:
    """Says which file an error of the system was about."""
    try:
        yield
    except OSError as error:
        raise WriteError(path, error) from error


def _beside(path: Path, what: str) -> Path:
    return path.with_name(f".{path.name}.{os.getpid()}.{what}~")


def _write(path: Path, data: bytes, like: Path) -> None:
    with path.open("xb") as file:
        file.write(data)
    if like.is_file():
        path.chmod(like.stat().st_mode & 0o7777)


def _keep(path: Path, kept: Path) -> None:
    """Let the old file have a second name, which takes no room on the disk; where that cannot be, a copy."""
    try:
        os.link(path, kept, follow_symlinks=False)
    except OSError:
        shutil.copy2(path, kept, follow_symlinks=False)


def _sync(path: Path) -> None:
    """Bring the contents of a file, or the names in a folder, to the disk."""
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
