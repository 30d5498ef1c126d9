"""``understudy bench``: speed on this machine, as rates and ratios with their goals."""

import os
import sys
import time
from collections.abc import Mapping, Sequence

from ..core.errors import ParameterError
from ..engine.bench.figures import Better, Figure, Measure, document
from ..engine.bench.machine import is_busy, machine
from ..engine.bench.subject import Program, Subject, UnmeasurableError, subject
from ..engine.bench.table import MEASURES as ENGINE_MEASURES
from ..engine.cores import cores
from .console import progress, say, show, show_json, show_table
from .exits import DONE, INTERRUPTED
from .places import ROOT, shipped_bench, shipped_project
from .studio_figures import studio_measures
from .wording import counted, number, unknown

#: All that is measured: the engine's figures, then the studio's.
MEASURES = (*ENGINE_MEASURES, *studio_measures())
PROJECT, FORAGER = "foraging", "forager"
#: How the program is called in a process of its own. -P: another "app" in the folder where the user is, is not ours.
COMMAND = (sys.executable, "-P", "-m", ROOT.name)


def measure(words: Sequence[str], *, full: bool, as_json: bool) -> int:
    """Take the figures whose names contain one of *words*, or all, and print them.

    Returns:
        0 whether goals are reached or not, since that depends on the machine; 130 if the user stopped it, with the
        figures that had been taken.
    """
    chosen = choose(words, full=full)
    folders = shipped_project(PROJECT), shipped_bench(FORAGER)
    of = subject(*folders, _program(), cores(), time.perf_counter, full=full)
    on = machine(of.cores)
    if is_busy(of.cores):
        say("other programs keep this machine busy: figures will be worse than it is")
    figures, interrupted = take(chosen, of)
    if as_json:
        show_json({"machine": on, "figures": [document(figure) for figure in figures]})
    else:
        _show(on, figures)
    return INTERRUPTED if interrupted else DONE


def choose(words: Sequence[str], *, full: bool) -> list[Measure]:
    """The measures meant; one that is named may take long.

    Raises:
        ParameterError: A word is in no name.
    """
    for word in words:
        if not any(_is_named(one, word) for one in MEASURES):
            raise ParameterError(unknown("figure", word, [one.name for one in MEASURES]))
    if words:
        return [one for one in MEASURES if any(_is_named(one, word) for word in words)]
    return [one for one in MEASURES if full or not one.long]


def _is_named(one: Measure, word: str) -> bool:
    return word.lower() in one.name.lower()


def _program() -> Program:
    """As a user starts it: from the second start on, Python has kept the bytecode, unless it was told not to."""
    paths = [str(ROOT.parent), *filter(None, [os.environ.get("PYTHONPATH")])]
    return Program(COMMAND, {"PYTHONPATH": os.pathsep.join(paths), "PYTHONDONTWRITEBYTECODE": ""})


def take(chosen: Sequence[Measure], of: Subject) -> tuple[list[Figure], bool]:
    """Take the figures, showing progress; what comes second is whether the user stopped it."""
    figures: list[Figure] = []
    try:
        with progress("Measuring", len(chosen)) as advance:
            for done, one in enumerate(chosen, 1):
                if one.long:
                    say(f"measuring {one.name!r}, which takes a while")
                try:
                    figures.append(Figure(one, one.take(of)))
                except UnmeasurableError as error:
                    say(f"{one.name!r} is left out: {error}")
                advance(done)
    except KeyboardInterrupt:
        return figures, True
    return figures, False


def _show(on: Mapping[str, str | int | float], figures: Sequence[Figure]) -> None:
    show(f"{on['processor']}, {counted(int(on['cores']), 'core')}, {on['system']}, Python {on['python']}\n")
    show_table(["figure", "measured", "unit", "goal", "reached"], [_row(figure) for figure in figures])
    reached = sum(figure.holds for figure in figures)
    show(f"\n{reached} of {counted(len(figures), 'goal')} reached")


def _row(figure: Figure) -> list[str]:
    one = figure.measure
    sign = "≥" if one.better is Better.HIGHER else "≤"
    return [
        one.name,
        shown(figure.value),
        one.unit,
        f"{sign} {number(one.goal)}",
        "yes" if figure.holds else "no",
    ]


def shown(value: float) -> str:
    """*value* to three digits at least."""
    return f"{value:,.0f}" if abs(value) >= 99.95 else f"{value:#.3g}"
