"""The studio's figures with their goals: a window is measured in a process of its own, off screen."""

import json
import os
import subprocess
import sys
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from ..engine.bench.commands import CommandError
from ..engine.bench.figures import Better, Measure
from ..engine.bench.subject import Subject
from .places import ROOT

#: As in `bench.COMMAND`.
PYTHON = (sys.executable, "-P", "-m")
#: Starts as often; the shortest counts.
STARTS = 4
SCREEN = {"QT_QPA_PLATFORM": "offscreen"}


@dataclass
class Groups:
    """Takes figures group by group: what one process has measured is kept for the other figures of its group."""

    _taken: dict[tuple[str, int, bool], Mapping[str, float]] = field(default_factory=dict)

    def take(self, of: Subject, group: str, figure: str) -> float:
        """A figure of a group."""
        key = group, of.shrink, of.full
        if key not in self._taken:
            self._taken[key] = measured(of, group)
        return self._taken[key][figure]


def measured(of: Subject, group: str) -> Mapping[str, float]:
    """All figures of a group, measured now.

    Raises:
        CommandError: The window did not do what was to be measured.
    """
    size = "full" if of.full else "short"
    words = [*PYTHON, f"{ROOT.name}.editor.bench", group, str(of.shrink), size, str(of.folder)]
    ended = subprocess.run(words, capture_output=True, text=True, check=False, env=_environment(of))
    if ended.returncode != 0:
        last = (ended.stderr.strip().splitlines() or ["it said nothing"])[-1]
        raise CommandError(f"{group}: measuring ended with exit code {ended.returncode}: {last}")
    figures: Mapping[str, float] = json.loads(ended.stdout.splitlines()[-1])
    return figures


def seconds_to_window(of: Subject) -> float:
    """From the start of the process until the window has been painted on the screen."""
    return min(_start(of) for _ in range(of.much(STARTS)))


def _start(of: Subject) -> float:
    """One start, with settings of its own; the window is closed once it is there."""
    with TemporaryDirectory() as home:
        environment = {
            **_environment(of),
            "XDG_CONFIG_HOME": home,
            "XDG_STATE_HOME": str(Path(home) / "state"),
        }
        words = [*PYTHON, f"{ROOT.name}.cli.first_window", str(of.folder)]
        began = time.perf_counter()
        with subprocess.Popen(
            words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=environment
        ) as process:
            assert process.stdout is not None
            shown = process.stdout.readline()
            seconds = time.perf_counter() - began
            process.stdout.read()
        if not shown or process.returncode != 0:
            raise CommandError(
                f"the studio ended with exit code {process.returncode} before its window was there"
            )
        return seconds


def _environment(of: Subject) -> Mapping[str, str]:
    return {**os.environ, **of.program.environment, **SCREEN}


def studio_measures() -> tuple[Measure, ...]:
    """All of them."""
    groups = Groups()

    def of(
        name: str, group: str, figure: str, unit: str, goal: float, *, high: bool = False, long: bool = True
    ) -> Measure:
        take = partial(groups.take, group=group, figure=figure)
        return Measure(name, take, unit, goal, Better.HIGHER if high else Better.LOWER, long)

    return (
        Measure("window on screen", seconds_to_window, "s", 1.5, Better.LOWER),
        of("canvas, 3,125 agents", "frames", "frames 3,125", "frames/s", 60.0, high=True, long=False),
        of("canvas, 10,000 agents", "frames", "frames 10,000", "frames/s", 30.0, high=True, long=False),
        of("key to agent, 99 of 100 times", "picks", "key", "ms", 50.0),
        of("engine under the window", "rates", "share", "times", 0.8, high=True),
        of("longest stall of the window", "stalls", "longest", "ms", 50.0),
        of("stalls, 99 of 100 beats", "stalls", "most", "ms", 50.0),
        of("longest stall beside 1,000 runs", "runs", "longest", "ms", 50.0),
        of("stalls beside 1,000 runs, 99 of 100 beats", "runs", "most", "ms", 1000.0 / 60.0),
        of("opening 200 behaviors, 20,000 examples", "projects", "opened", "s", 3.0),
        of("slowest use of that project", "projects", "used", "ms", 100.0),
        of("arranging 40 states, 120 transitions", "graphs", "arranged", "s", 1.0),
        of("slowest edit of that automaton", "graphs", "edited", "ms", 100.0),
    )
