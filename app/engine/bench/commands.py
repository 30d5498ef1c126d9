"""How long a user waits for the program itself: every time is that of a whole process, from its start to its end."""

import json
import os
import shutil
import subprocess
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from ...core.errors import UnderstudyError
from .subject import Subject, UnmeasurableError
from .timing import least

RUN = ("run", "--ticks", "1")
#: The two experiments of the paper, and how many arms of each are the paper's own.
EXPERIMENTS: Mapping[str, int] = {"figure3": 4, "figure4": 2}
RUNS, TICKS = 100, 100_000


class CommandError(UnderstudyError):
    """The program that was to be timed failed; the message says with which words."""


def seconds_of_help(of: Subject) -> float:
    """``understudy --help``."""
    return least(lambda: partial(_call, of, "--help"), of.much(8), of.clock)


def seconds_of_check(of: Subject) -> float:
    """``understudy check`` of the foraging project."""
    return least(lambda: partial(_call, of, "check", str(of.folder)), of.much(4), of.clock)


def seconds_to_run(of: Subject) -> float:
    """``understudy run`` of a single tick, its kernel compiled before."""
    _call(of, *RUN, str(of.folder))
    return least(lambda: partial(_call, of, *RUN, str(of.folder)), of.much(3), of.clock)


def seconds_to_compile(of: Subject) -> float:
    """``understudy run`` of a single tick where nothing has been compiled yet."""
    with TemporaryDirectory() as cache:
        elsewhere = {"XDG_CACHE_HOME": cache}
        seconds = least(lambda: partial(_call, of, *RUN, str(of.folder), elsewhere=elsewhere), 1, of.clock)
        if not any(Path(cache).iterdir()):
            raise UnmeasurableError(
                "compiled kernels are kept where this system says, so none can be missing"
            )
        return seconds


def seconds_of_evaluation(of: Subject) -> float:
    """The paper's whole evaluation on all cores: six arms of both experiments, results, claims and figures included."""
    with TemporaryDirectory() as place:
        folder = Path(place) / "project"
        shutil.copytree(of.folder, folder, ignore=shutil.ignore_patterns("results", "reports"))
        for name, arms in EXPERIMENTS.items():
            _keep_first_arms(folder / "experiments" / f"{name}.json", arms)
        return least(lambda: partial(_evaluate, of, folder), 1, of.clock)


def _evaluate(of: Subject, folder: Path) -> None:
    size = ("--runs", str(of.much(RUNS)), "--ticks", str(of.much(TICKS)))
    for name in EXPERIMENTS:
        _call(of, "experiment", str(folder), name, *size)


def _keep_first_arms(path: Path, count: int) -> None:
    """Leave the other arms out of an experiment, and the claims about them."""
    record: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    record["arms"] = record["arms"][:count]
    there = {arm["name"] for arm in record["arms"]}
    record["claims"] = [c for c in record.get("claims", ()) if {c.get("greater"), c.get("less")} <= there]
    path.write_text(json.dumps(record), encoding="utf-8")


def _call(of: Subject, *arguments: str, elsewhere: Mapping[str, str] | None = None) -> None:
    """Run the program to its end."""
    words = [*of.program.words, *arguments]
    environment = {**os.environ, **of.program.environment, **(elsewhere or {})}
    ended = subprocess.run(words, capture_output=True, text=True, check=False, env=environment)
    if ended.returncode != 0:
        last = (ended.stderr.strip().splitlines() or ["it said nothing"])[-1]
        raise CommandError(f"{' '.join(arguments)}: it ended with exit code {ended.returncode}: {last}")
