"""Results on disk: an SQLite file with one row a run, written as each run ends.

A row is there in full or not at all, whatever ends the program. A file belongs to one experiment: it holds a fingerprint
of everything that the numbers depend on, part by part, so that a refusal can say what differs.
"""

import json
import sqlite3
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ...core.errors import StorageError
from ...core.refusals import reason

#: Marks an SQLite file as ours: "UndS".
OURS = 0x556E6453
#: Of the tables; raised when they change.
VERSION = 1

#: Name of a part of an experiment -> a hash of it.
Fingerprint = Mapping[str, str]

_TABLES = """
CREATE TABLE about (part TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE runs (
    cell INTEGER NOT NULL,
    run INTEGER NOT NULL,
    seed INTEGER NOT NULL,
    measures TEXT NOT NULL,
    stalled INTEGER NOT NULL,
    curves BLOB NOT NULL,
    agent_ticks INTEGER NOT NULL,
    seconds REAL NOT NULL,
    PRIMARY KEY (cell, run)
) WITHOUT ROWID;
"""


class ResultsError(StorageError):
    """A results file is damaged, belongs to something else, or cannot be written; the message says what to do."""


@dataclass(frozen=True, slots=True)
class Row:
    """What one run came to.

    Attributes:
        curves: Measures over time, one row a measure in the order of the scenario's, one column a sample.
        seconds: How long it took; the only thing here that differs from machine to machine.
    """

    cell: int
    run: int
    seed: int
    measures: Mapping[str, float]
    stalled: bool
    curves: NDArray[np.float64]
    agent_ticks: int
    seconds: float

    def outline(self) -> "Row":
        """The same without its curves."""
        return replace(self, curves=_NO_CURVES)


_NO_CURVES = np.zeros(0)


class Results:
    """An open results file; used by one thread.

    Attributes:
        added: Told of every row once it is kept.
    """

    def __init__(self, path: Path, connection: sqlite3.Connection) -> None:
        self.path = path
        self.added: Callable[[Row], None] = lambda _: None
        self._connection = connection

    @classmethod
    def open(cls, path: Path, fingerprint: Fingerprint) -> Self:
        """The results of an experiment, made if there are none yet.

        Raises:
            ResultsError: The file is damaged, holds results of something else, is in use, or cannot be written.
        """
        with _explained(path):
            path.parent.mkdir(parents=True, exist_ok=True)
            connection = sqlite3.connect(path, isolation_level=None)
            try:
                _prepare(connection, path, fingerprint)
            except BaseException:
                connection.close()
                raise
        return cls(path, connection)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Let go of the file."""
        self._connection.close()

    def add(self, row: Row) -> None:
        """Keep what a run came to; it is on the disk when this returns.

        Raises:
            ResultsError: It could not be written; the rows before it are safe.
        """
        values = (
            row.cell,
            row.run,
            row.seed,
            json.dumps(row.measures, sort_keys=True, allow_nan=False),
            int(row.stalled),
            np.ascontiguousarray(row.curves, np.float64).tobytes(),
            row.agent_ticks,
            row.seconds,
        )
        with _explained(self.path):
            self._connection.execute("INSERT INTO runs VALUES (?, ?, ?, ?, ?, ?, ?, ?)", values)
        self.added(row)

    def has(self, cell: int, run: int) -> bool:
        """Whether a run has been made."""
        with _explained(self.path):
            found = self._connection.execute("SELECT 1 FROM runs WHERE cell = ? AND run = ?", (cell, run))
            return found.fetchone() is not None

    def count(self, cells: int, runs: int) -> int:
        """How many of the first *runs* of the first *cells* cells have been made."""
        with _explained(self.path):
            found = self._connection.execute(
                "SELECT COUNT(*) FROM runs WHERE cell < ? AND run < ?", (cells, runs)
            )
            return int(found.fetchone()[0])

    def most(self, cells: int) -> int:
        """As many runs a cell as were ever asked for of the first *cells* cells, as far as they have been made."""
        with _explained(self.path):
            found = self._connection.execute("SELECT MAX(run) FROM runs WHERE cell < ?", (cells,)).fetchone()
            return 0 if found[0] is None else int(found[0]) + 1

    def outlines(self, cells: int, runs: int) -> list[Row]:
        """The first *runs* of the first *cells* cells as far as they have been made, in order, without their curves."""
        with _explained(self.path):
            found = self._connection.execute(
                "SELECT cell, run, seed, measures, stalled, x'', agent_ticks, seconds FROM runs "
                "WHERE cell < ? AND run < ? ORDER BY cell, run",
                (cells, runs),
            )
            return [_row(self.path, values) for values in found]

    def rows(self, cell: int, runs: int) -> Iterator[Row]:
        """The first *runs* of a cell as far as they have been made, in order, one at a time."""
        with _explained(self.path), closing(self._connection.cursor()) as cursor:
            cursor.execute("SELECT * FROM runs WHERE cell = ? AND run < ? ORDER BY run", (cell, runs))
            for found in cursor:
                yield _row(self.path, found)


def _row(path: Path, found: tuple[Any, ...]) -> Row:
    try:
        measures, curves = json.loads(found[3]), np.frombuffer(found[5], np.float64)
    except (ValueError, TypeError) as error:
        raise _damaged(path, f"cell {found[0]}, run {found[1]}: {error}") from error
    cell, run, seed, _, stalled, _, agent_ticks, seconds = found
    return Row(cell, run, seed, measures, bool(stalled), curves, agent_ticks, seconds)


def _prepare(connection: sqlite3.Connection, path: Path, fingerprint: Fingerprint) -> None:
    connection.execute("PRAGMA locking_mode = EXCLUSIVE")
    connection.execute("PRAGMA synchronous = FULL")
    connection.execute("BEGIN EXCLUSIVE")
    empty = connection.execute("SELECT COUNT(*) FROM sqlite_schema").fetchone()[0] == 0
    mark = connection.execute("PRAGMA application_id").fetchone()[0]
    if empty and mark in (0, OURS):
        _begin(connection, fingerprint)
    elif mark != OURS:
        raise ResultsError(
            f"{path}: this is no results file of an experiment; give another folder with --out"
        )
    else:
        _refuse_damaged(connection, path)
        _refuse_others(connection, path, fingerprint)
    connection.execute("COMMIT")


def _begin(connection: sqlite3.Connection, fingerprint: Fingerprint) -> None:
    for statement in _TABLES.split(";"):
        connection.execute(statement)
    connection.execute(f"PRAGMA application_id = {OURS}")
    about = {"version": str(VERSION), **fingerprint}
    connection.executemany("INSERT INTO about VALUES (?, ?)", about.items())


def _refuse_damaged(connection: sqlite3.Connection, path: Path) -> None:
    found = connection.execute("PRAGMA quick_check(1)").fetchone()[0]
    if found != "ok":
        raise _damaged(path, str(found))


def _refuse_others(connection: sqlite3.Connection, path: Path, fingerprint: Fingerprint) -> None:
    about = dict(connection.execute("SELECT part, value FROM about").fetchall())
    version = about.pop("version", "")
    if version != str(VERSION):
        raise ResultsError(
            f"{path}: it is of version {version or 'unknown'}, but this program reads {VERSION}; {_INSTEAD}"
        )
    differing = [part for part in {**about, **fingerprint} if about.get(part) != fingerprint.get(part)]
    if differing:
        raise ResultsError(
            f"{path}: these are results of another experiment; what differs: {', '.join(sorted(differing))}; {_INSTEAD}"
        )


_INSTEAD = "move the file away to begin anew, or give another folder with --out"


def _damaged(path: Path, how: str) -> ResultsError:
    return ResultsError(f"{path}: the file is damaged ({how}); {_INSTEAD}")


@contextmanager
def _explained(path: Path) -> Iterator[None]:
    """Say in the user's words what SQLite or the system could not do."""
    try:
        yield
    except OSError as error:
        raise ResultsError(f"{path}: cannot be written: {reason(error)}; {_INSTEAD}") from error
    except sqlite3.Error as error:
        raise _translated(path, error) from error


def _translated(path: Path, error: sqlite3.Error) -> ResultsError:
    code = getattr(error, "sqlite_errorcode", 0) & 0xFF
    if code == sqlite3.SQLITE_FULL:
        return ResultsError(
            f"{path}: the disk is full; all finished runs are kept: make room, and give the same command again"
        )
    if code in (sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED):
        return ResultsError(f"{path}: another program is writing to it; wait for it, or give another --out")
    if code in (sqlite3.SQLITE_CANTOPEN, sqlite3.SQLITE_READONLY, sqlite3.SQLITE_PERM, sqlite3.SQLITE_IOERR):
        return ResultsError(f"{path}: cannot be written: {error}; give another folder with --out")
    return _damaged(path, str(error))
