"""Figures of runs: what one shows, as plain values, and drawing it into a file.

Qt is only imported in the process that draws, so that a machine without its system libraries gets a message instead of
losing the program.
"""

import os
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass, field
from multiprocessing import get_context
from pathlib import Path

from ...core.errors import UnderstudyError
from ...core.storage.atomic import WriteError, change_files
from ...engine.children import clear_up_in_silence, end_with_parent
from ...engine.interrupts import deaf_processes, noted_interrupts
from .curves import Chart

#: File endings that can be drawn.
FORMATS = (".png", ".svg", ".pdf")


class FigureError(UnderstudyError):
    """A figure cannot be drawn; the message says what is missing."""


@dataclass(frozen=True, slots=True)
class Series:
    """One line of the chart.

    Attributes:
        label: Stands at the line's end; a faint line has none.
        color: Place in the color table; arms have one each.
        faint: A single run behind the mean of several.
    """

    label: str
    color: int
    x: tuple[float, ...]
    y: tuple[float, ...]
    faint: bool = False


@dataclass(frozen=True, slots=True)
class Body:
    """Something in the world besides agents, drawn true to scale.

    Attributes:
        got, needed: Agents that hold it and that it needs; 0 and 0 where that means nothing.
        place: It is a place, not a thing: it gets a cross.
    """

    x: float
    y: float
    radius: float
    got: int = 0
    needed: int = 0
    place: bool = False


@dataclass(frozen=True, slots=True)
class Walker:
    """An agent; *heading* in radians, counterclockwise from the x axis; *busy* is one that holds something."""

    x: float
    y: float
    heading: float
    busy: bool = False


@dataclass(frozen=True, slots=True)
class WorldView:
    """A world at one moment, seen from above, y upward."""

    title: str
    caption: str
    color: int
    left: float
    bottom: float
    width: float
    height: float
    walkers: tuple[Walker, ...]
    bodies: tuple[Body, ...]


@dataclass(frozen=True, slots=True)
class Figure:
    """A chart of a measure over time, and worlds below it.

    Attributes:
        legend: What the marks in the worlds mean, by mark: "agent", "busy", "body", "full", "place".
    """

    title: str
    subtitle: str
    x_title: str
    y_title: str
    series: tuple[Series, ...]
    worlds: tuple[WorldView, ...] = ()
    legend: Mapping[str, str] = field(default_factory=dict)


def refuse_format(path: Path) -> None:
    """Raise a `FigureError` unless figures can be drawn into files that end like *path*."""
    if path.suffix.lower() not in FORMATS:
        raise FigureError(f"{path}: pictures end in {', '.join(FORMATS)}")


def draw(figure: Figure | Chart, path: Path, *, dark: bool = False) -> None:
    """Draw *figure* into the file at *path*; its ending chooses the format.

    Raises:
        FigureError: The ending is unknown, Qt cannot be loaded, or the file cannot be written.
    """
    refuse_format(path)
    try:
        change_files({path: _painted(figure, path.suffix.lower(), dark=dark)}, ())
    except WriteError as error:
        raise FigureError(f"{path}: cannot be written: {error.error.strerror or error.error}") from error


def _painted(figure: Figure | Chart, ending: str, *, dark: bool) -> bytes:
    """The content of the file, made in a process of its own: Qt ends the process that it cannot start in."""
    clear_up_in_silence()
    with (
        noted_interrupts() as interrupts,
        ProcessPoolExecutor(1, get_context("spawn"), end_with_parent) as process,
    ):
        try:
            with deaf_processes():
                painting = process.submit(_paint, figure, ending, dark)
            content, problem = painting.result()
        except BrokenProcessPool:
            content, problem = b"", "Qt could not start"
    if interrupts.came:
        raise KeyboardInterrupt
    if problem:
        raise FigureError(f"no picture: {problem}; `understudy doctor` says how to mend it")
    return content


def _paint(figure: Figure | Chart, ending: str, dark: bool) -> tuple[bytes, str]:  # noqa: FBT001 - by position
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    try:
        if isinstance(figure, Chart):
            from .curve_painting import painted as charted  # noqa: PLC0415 - see the module's docstring

            return charted(figure, ending, dark=dark), ""
        from .painting import painted  # noqa: PLC0415 - see the module's docstring
    except ImportError as error:
        return b"", f"Qt cannot be loaded ({error})"
    return painted(figure, ending, dark=dark), ""
