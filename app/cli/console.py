"""Where words go: results to stdout, everything said on the way to stderr.

With ``--json``, stdout gets one document and nothing else.
"""

import json
import os
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TextIO

PROGRAM = "understudy"
#: Seconds between lines of progress where there is no terminal to draw a bar on.
QUIET = 10.0
#: Columns of a table that goes to a file or pipe, where nothing need be cut off.
ENDLESS = 1000

#: Told how much of the work is done.
Advance = Callable[[float], None]


def say(message: str) -> None:
    """A line to the user that is no result."""
    print(f"{PROGRAM}: {message}", file=sys.stderr, flush=True)


class OutputError(Exception):
    """The result cannot be written to where stdout goes."""


@contextmanager
def writing() -> Iterator[None]:
    """Tells an output that cannot be written from all other failures of the system."""
    try:
        yield
    except BrokenPipeError:  # whoever read it has gone, which is no failure
        raise
    except OSError as error:
        raise OutputError(f"the output cannot be written: {error.strerror}") from error


def show(text: str = "") -> None:
    """A line of the result."""
    with writing():
        print(text)


def show_json(document: Any) -> None:
    """The result as one JSON document."""
    show(json.dumps(document, indent=2, allow_nan=False))


def show_table(columns: Sequence[str], rows: Sequence[Sequence[str]], words: int = 1) -> None:
    """A table of the result.

    Args:
        words: How many columns, from the left, hold words; the others hold numbers and are set flush right.
    """
    from rich.box import SIMPLE
    from rich.table import Table

    table = Table(box=SIMPLE, pad_edge=False, show_edge=False)
    for index, column in enumerate(columns):
        table.add_column(column, justify="left" if index < words else "right", overflow="fold")
    for row in rows:
        table.add_row(*row)
    with writing():
        _console(sys.stdout).print(table)


def _console(stream: TextIO) -> Any:
    from rich.console import Console

    width = None if stream.isatty() else ENDLESS
    return Console(file=stream, width=width, markup=False, emoji=False, highlight=False)


@contextmanager
def progress(title: str, total: float) -> Iterator[Advance]:
    """Show how far the work is, on stderr: a bar on a terminal, elsewhere a line now and then."""
    if sys.stderr.isatty():
        with _bar(title, total) as advance:
            yield advance
    else:
        yield _lines(title, total)


def say_at_last(message: str) -> None:
    """A line to the user before the program ends at once, though another line or a bar may be in the middle of being drawn."""
    cleared = (
        "\r\x1b[2K\x1b[?25h" if sys.stderr.isatty() else ""
    )  # the line, and the cursor, which a bar hides
    os.write(sys.stderr.fileno(), f"{cleared}{PROGRAM}: {message}\n".encode())


@contextmanager
def _bar(title: str, total: float) -> Iterator[Advance]:
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

    columns = (
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        TaskProgressColumn(),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=_console(sys.stderr), transient=True) as bars:
        task = bars.add_task(title, total=total)
        yield lambda done: bars.update(task, completed=done)


@contextmanager
def nothing_changes() -> Iterator[None]:
    """While this lasts, an interrupt leaves everything as it was, and the user hears so."""
    try:
        yield
    except KeyboardInterrupt:
        say("nothing was changed")
        raise


def _lines(title: str, total: float, clock: Callable[[], float] = time.monotonic) -> Advance:
    said = clock()

    def advance(done: float) -> None:
        nonlocal said
        if clock() - said >= QUIET:
            said = clock()
            say(f"{title}: {done / total:.0%}" if total else title)

    return advance
