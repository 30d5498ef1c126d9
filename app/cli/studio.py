"""No verb, and no screen for the studio: a demonstration in numbers instead."""

import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from ..core.check import refuse
from ..core.errors import ParameterError
from ..core.project import Arm, Project
from ..engine.runs import RunResult, treatment
from .console import PROGRAM, progress, say, show, show_table
from .demonstrate import play
from .exits import DONE, FELL_SHORT, INTERRUPTED
from .opening import Opened, open_project
from .pictures import Shown, figure_of_runs, structure
from .places import FIRST_PROJECT, shipped_project
from .plans import Bench, Plan
from .probes import writable
from .run import draw_picture, refuse_picture
from .wording import counted, number
from .worlds import Ran, run_plans

PICTURE = Path("understudy-demonstration.png")
#: A project's first arms are shown: in the shipped project, agents alone and under one and two levels of controllers.
MOST_ARMS = 3
#: They are shown in this world if the project has it, by this measure if the scenario has that: with boxes of two sizes
#: and by the weight of what was delivered, one level of controllers can be told from two.
SHOWN_WORLD, SHOWN_MEASURE = "two sizes", "weight"


@dataclass(frozen=True, slots=True)
class Taught:
    """A project whose behaviors were learned from its demonstrations just now.

    Attributes:
        same: Whether just what is stored came out again.
    """

    opened: Opened
    demonstrations: int
    examples: int
    seconds: float
    same: bool


def show_demonstration(
    project: Path | None,
    picture: Path | None,
    *,
    dark: bool,
    ticks: int,
    seed: int,
    trust: bool,
    headless: bool,
) -> int:
    """Show what Understudy does without a window; *headless* if that was asked for."""
    why = "" if headless else "there is no display for a window: "
    say(f"{why}here is the demonstration in numbers")
    return demonstration(project, picture, dark=dark, ticks=ticks, seed=seed, trust=trust)


def demonstration(
    project: Path | None, picture: Path | None, *, dark: bool, ticks: int, seed: int, trust: bool
) -> int:
    """Learn a project's behaviors anew, run its arms, and end with numbers and a picture."""
    if picture is not None:
        refuse_picture(picture)
    opened = open_project(project or shipped_project(FIRST_PROJECT), trust=trust)
    if not opened.project.arms:
        raise ParameterError(f"project {opened.project.name!r} has no arms, so there is nothing to show")
    taught = teach(opened)
    show(story(taught))
    return show_arms(taught, picture, dark=dark, ticks=ticks, seed=seed, trust=trust)


def teach(opened: Opened) -> Taught:
    """Record all examples and learn all behaviors anew, in memory: the stored project stays as it is."""
    before = opened.project
    began = time.perf_counter()
    after = play(opened) if before.demonstrations else before
    seconds = time.perf_counter() - began
    return Taught(
        replace(opened, project=after),
        len(after.demonstrations),
        examples_in(after),
        seconds,
        after == before,
    )


def examples_in(project: Project) -> int:
    """How many examples there are."""
    return sum(len(examples) for by_id in project.examples.values() for examples in by_id.values())


def story(taught: Taught) -> str:
    """What was learned, in a sentence."""
    project = taught.opened.project
    if not taught.demonstrations:
        return f"{project.name}: no demonstrations to learn from, so its behaviors run as they are stored"
    outcome = "just what is stored" if taught.same else "not quite what is stored"
    learned = sum(
        bool(a.learned) for library in project.libraries.values() for a in library.automata.values()
    )
    return (
        f"{project.name}: {counted(learned, 'behavior')} learned again from {counted(taught.examples, 'example')} of "
        f"{counted(taught.demonstrations, 'demonstration')} in {taught.seconds:.1f} s: {outcome}"
    )


def show_arms(taught: Taught, picture: Path | None, *, dark: bool, ticks: int, seed: int, trust: bool) -> int:
    """Run each arm once, and end with numbers and a picture."""
    project = taught.opened.project
    arms = shown_arms(project)
    for arm in arms:
        refuse(project, taught.opened.scenario.vocabulary, arm.name)
    ran = run_arms(taught.opened, arms, ticks=ticks, seed=seed, trust=trust)
    done = [(arm, result) for arm, result in zip(arms, ran.results, strict=True) if result is not None]
    if done:
        show()
        show_table(("", "", *done[0][1].measures, "stalled"), rows(done), words=2)
        total = sum(len(arm.forest().agents()) * result.ticks for arm, result in done)
        show(
            f"\none run of {counted(ticks, 'tick')} each (seed {seed}): {ran.seconds:.1f} s, "
            f"{total / ran.seconds:,.0f} agent ticks a second"
        )
    if ran.interrupted:
        return INTERRUPTED
    drawn = bool(done) and _draw(taught, done, picture, dark=dark)
    return DONE if drawn and len(done) == len(arms) else FELL_SHORT


def shown_arms(project: Project) -> tuple[Arm, ...]:
    """The arms to show, where they are to be seen."""
    arms = project.arms[:MOST_ARMS]
    return tuple(replace(arm, world=SHOWN_WORLD) for arm in arms) if SHOWN_WORLD in project.worlds else arms


def run_arms(opened: Opened, arms: Sequence[Arm], *, ticks: int, seed: int, trust: bool) -> Ran:
    """One run of each arm."""
    plans = [Plan(arm, seed, ticks) for arm in arms]
    with progress(f"Running {counted(len(arms), 'arm')}", ticks * len(arms)) as advance:
        return run_plans(Bench(opened.project, opened.folder, trust), plans, None, advance)


def rows(done: Sequence[tuple[Arm, RunResult]]) -> list[list[str]]:
    """A row an arm."""
    return [
        [
            arm.name,
            structure(arm),
            *(number(v) for v in result.measures.values()),
            "yes" if result.stalled else "",
        ]
        for arm, result in done
    ]


def _draw(taught: Taught, done: Sequence[tuple[Arm, RunResult]], picture: Path | None, *, dark: bool) -> bool:
    """Draw where the user wants it; by default in the current folder, or a temporary one if nothing can be put there."""
    opened, result = taught.opened, done[0][1]
    agents = counted(len(done[0][0].forest().agents()), "agent")
    title = f"{opened.scenario.title} with {agents}"
    learned = (
        f"behaviors learned from {counted(taught.examples, 'example')} · " if taught.demonstrations else ""
    )
    place = f" · world: {done[0][0].world}" if done[0][0].world else ""
    subtitle = f"{learned}one run of {counted(result.ticks, 'tick')} each, seed {result.seed}{place}"
    shown = [Shown(arm, _parameters(opened, arm), (one,)) for arm, one in done]
    figure = figure_of_runs(title, subtitle[0].upper() + subtitle[1:], opened.scenario, shown, SHOWN_MEASURE)
    if picture is None and not writable(Path.cwd()):
        picture = Path(tempfile.mkdtemp(prefix=f"{PROGRAM}-")) / PICTURE
        say(f"the current folder cannot be written to, so the picture goes to {picture.parent}")
    return draw_picture(figure, picture or PICTURE, dark=dark)


def _parameters(opened: Opened, arm: Arm) -> dict[str, float | int | str | bool]:
    return dict(treatment(opened.project, opened.scenario, arm).parameters)
