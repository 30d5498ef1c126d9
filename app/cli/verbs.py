"""Everything that can be typed. Only words are here: the work is imported when a verb is obeyed."""

from pathlib import Path
from typing import Annotated

import typer

from .. import __version__
from .arguments import (
    MOST_RUNS,
    MOST_TICKS,
    WHOLE,
    Behaviors,
    Dark,
    Jobs,
    Json,
    Picture,
    ProjectFolder,
    Seed,
    Trust,
    examples,
    whole,
)
from .console import PROGRAM, show

#: The verb that is meant where none is given; it stays out of the help.
STUDIO = "studio"

verbs = typer.Typer(
    add_completion=False,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110},
    pretty_exceptions_enable=False,
)


def _version(wanted: bool) -> None:
    if wanted:
        show(f"{PROGRAM} {__version__}")
        raise typer.Exit


@verbs.callback(
    invoke_without_command=True,
    subcommand_metavar="[PROJECT | VERB ...]",
    epilog=examples(
        "understudy                          the studio, on the foraging project",
        "understudy my-project               the studio, on a project of yours",
        "understudy --headless               no window: a demonstration in numbers",
        "understudy run projects/foraging    run a project's first arm",
        "understudy train projects/foraging  learn again from stored examples",
        "understudy VERB --help              more about a verb",
        "understudy --headless --help        more about what can be given without one",
    ),
)
def program(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Say which version this is.")
    ] = False,
    debug: Annotated[bool, typer.Option("--debug", help="Should the program fail, show where.")] = False,
) -> None:
    """Teach behaviors to groups of simulated agents by showing them.

    Exit codes: 0 done, 1 the work ran and something in it fell short, 2 the input was wrong, 130 interrupted.
    """


@verbs.command(STUDIO, hidden=True)
def studio(
    project: Annotated[
        Path | None,
        typer.Argument(metavar="PROJECT", help="Its folder.", show_default="the foraging project"),
    ] = None,
    picture: Picture = None,
    dark: Dark = False,
    ticks: Annotated[
        int, typer.Option(parser=whole(1, MOST_TICKS), metavar=WHOLE, help="How long each run takes.")
    ] = 20_000,
    seed: Seed = 1,
    trust: Trust = False,
    headless: Annotated[
        bool, typer.Option("--headless", help="No window: the demonstration in numbers, and a picture.")
    ] = False,
) -> int:
    """Open the studio; without a screen, relearn a project from its demonstrations and run its arms."""
    from .places import display

    if display() and not headless:
        from .window import open_window

        return open_window(project, trust=trust)
    from .studio import show_demonstration

    return show_demonstration(
        project, picture, dark=dark, ticks=ticks, seed=seed, trust=trust, headless=headless
    )


@verbs.command(
    epilog=examples(
        "understudy new my-project --scenario foraging",
        "understudy new my-project --scenario my_world.py",
        "understudy new --list",
    )
)
def new(
    folder: Annotated[
        Path | None, typer.Argument(metavar="DIR", help="A folder that does not exist yet, or is empty.")
    ] = None,
    scenario: Annotated[
        str | None, typer.Option(help="The world that its agents live in: a name, or a FILE.py of your own.")
    ] = None,
    as_json: Json = False,
    scenarios: Annotated[bool, typer.Option("--list", help="List the scenarios instead.")] = False,
) -> int:
    """Make a new project: fifty agents in a scenario, and no behaviors yet."""
    from .new import make_project, refuse_incomplete, show_scenarios

    if scenarios:
        return show_scenarios(as_json=as_json)
    return make_project(*refuse_incomplete(folder, scenario), as_json=as_json)


@verbs.command(
    epilog=examples(
        "understudy check projects/foraging",
        "understudy check projects/foraging --json | jq .problems",
    )
)
def check(project: ProjectFolder, trust: Trust = False, as_json: Json = False) -> int:
    """Look for everything that is wrong with a project; exit code 2 if it cannot run as it is."""
    from .check import check_project

    return check_project(project, trust=trust, as_json=as_json)


@verbs.command(
    epilog=examples(
        "understudy train projects/foraging",
        "understudy train projects/foraging Goto agent/Wander --dry-run",
    )
)
def train(
    project: ProjectFolder,
    behaviors: Behaviors = None,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Report, and leave the project as it is.")
    ] = False,
    trust: Trust = False,
    as_json: Json = False,
) -> int:
    """Learn behaviors again from their stored examples, keep them, and report per state."""
    from .train import train_project

    return train_project(project, behaviors or [], dry_run=dry_run, trust=trust, as_json=as_json)


@verbs.command(
    epilog=examples(
        "understudy run projects/foraging --arm 'one level' --ticks 20000 --runs 10",
        "understudy run projects/foraging --set world.boxes=20 --set world.pullers=3 --json",
        "understudy run projects/foraging --arm 'two levels' --picture two-levels.svg",
        "understudy run forager.json --ticks 20000",
    )
)
def run(
    project: Annotated[
        Path, typer.Argument(metavar="PROJECT|FILE.json", help="A project's folder, or an exported file.")
    ],
    *,
    arm: Annotated[str | None, typer.Option(help="Which treatment.", show_default="the first")] = None,
    top: Annotated[
        str | None, typer.Option(metavar="BEHAVIOR", help="What every root runs.", show_default="the arm's")
    ] = None,
    ticks: Annotated[
        int,
        typer.Option(
            parser=whole(1, MOST_TICKS),
            metavar=WHOLE,
            help="How long a run takes; 60 ticks are a second at 1x.",
        ),
    ] = 10_000,
    seed: Seed = 1,
    runs: Annotated[int, typer.Option(parser=whole(1, MOST_RUNS), metavar=WHOLE, help="How many runs.")] = 1,
    settings: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="NAME=VALUE",
            help="Another value: world.boxes=20, or any parameter of the scenario; physics=rigid; engine=reference.",
        ),
    ] = None,
    jobs: Jobs = None,
    picture: Picture = None,
    dark: Dark = False,
    trust: Trust = False,
    as_json: Json = False,
) -> int:
    """Run an arm of a project, or an exported file, without a window, and count."""
    from .run import Request, run_project

    request = Request(project, arm, top, ticks, seed, runs, tuple(settings or ()), jobs, trust)
    return run_project(request, picture, dark=dark, as_json=as_json)


@verbs.command(
    epilog=examples(
        "understudy export projects/foraging -o forager.json",
        "understudy export projects/foraging --arm 'two levels' -o two-levels.json",
        "understudy export projects/foraging agent/Wander > wander.json",
        "understudy export projects/foraging Forage --examples -o forage.json",
    )
)
def export(
    project: ProjectFolder,
    behavior: Annotated[
        str | None,
        typer.Argument(metavar="BEHAVIOR", help="One behavior with all it uses; without it, a whole arm."),
    ] = None,
    *,
    arm: Annotated[
        str | None,
        typer.Option(help="Which arm, with its controllers and world.", show_default="the first"),
    ] = None,
    with_examples: Annotated[
        bool,
        typer.Option("--examples", help="With all examples, so that it can be taught further elsewhere."),
    ] = False,
    form: Annotated[str, typer.Option("--format", metavar="F", help="What to write: json.")] = "json",
    out: Annotated[
        Path | None,
        typer.Option("-o", "--out", metavar="FILE", help="Where to.", show_default="stdout", dir_okay=False),
    ] = None,
    trust: Trust = False,
    as_json: Json = False,
) -> int:
    """Write an arm or a behavior into one self-contained file, which `understudy run FILE.json` runs to the same results."""
    from .export import Request, export_project

    request = Request(project, behavior, arm, form, out, trust, with_examples)
    return export_project(request, as_json=as_json)


@verbs.command(
    "import",
    epilog=examples(
        "understudy import forager.json my-project",
        "understudy import two-levels.json my-project --arm --dry-run",
    ),
)
def import_(
    file: Annotated[Path, typer.Argument(metavar="FILE.json", help="An exported file.", dir_okay=False)],
    project: ProjectFolder,
    *,
    arm: Annotated[bool, typer.Option("--arm", help="Its arm as well, with hierarchy and world.")] = False,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Say what would come, and leave the project as it is.")
    ] = False,
    trust: Trust = False,
    as_json: Json = False,
) -> int:
    """Bring what was exported into a project: the behaviors with all they use, those of controllers as well.

    What the project has already is used; what only shares a name with something else comes under a new one.
    """
    from .importing import Request, import_into

    return import_into(Request(file, project, arm, dry_run, trust), as_json=as_json)


@verbs.command(
    epilog=examples(
        "understudy experiment projects/foraging",
        "understudy experiment projects/foraging figure3 --runs 10 --ticks 20000",
        "understudy experiment projects/foraging figure4 --out reports --json",
    )
)
def experiment(
    project: ProjectFolder,
    name: Annotated[
        str | None, typer.Argument(metavar="NAME", help="Which one; without it, all are listed.")
    ] = None,
    *,
    runs: Annotated[
        int | None,
        typer.Option(
            parser=whole(1),
            metavar=WHOLE,
            help="How many runs an arm.",
            show_default="the experiment's",
        ),
    ] = None,
    ticks: Annotated[
        int | None,
        typer.Option(
            parser=whole(1, MOST_TICKS),
            metavar=WHOLE,
            help="How long a run takes.",
            show_default="the experiment's",
        ),
    ] = None,
    jobs: Jobs = None,
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            help="Where results, report and figures go.",
            show_default="PROJECT/results",
            file_okay=False,
        ),
    ] = None,
    dark: Dark = False,
    trust: Trust = False,
    as_json: Json = False,
) -> int:
    """Run what an experiment compares, many times, and say which of its claims hold.

    Results are kept as each run ends: after Ctrl-C, or worse, the same command goes on where it was. An experiment is a
    file PROJECT/experiments/NAME.json.
    """
    from .experiment import Request, run_experiment

    return run_experiment(Request(project, name, runs, ticks, jobs, out, dark, trust), as_json=as_json)


@verbs.command(
    epilog=examples(
        "understudy demonstrate projects/foraging --check",
        "understudy demonstrate my-project Goto",
    )
)
def demonstrate(
    project: ProjectFolder,
    behaviors: Behaviors = None,
    only_check: Annotated[
        bool, typer.Option("--check", help="Compare with what is stored; change nothing.")
    ] = False,
    trust: Trust = False,
    as_json: Json = False,
) -> int:
    """Play a project's demonstrations again, and keep the examples that they record and what is learned from them.

    With --check, exit code 1 if a file of the project would come out different.
    """
    from .demonstrate import demonstrate_project

    return demonstrate_project(project, behaviors or [], only_check=only_check, trust=trust, as_json=as_json)


@verbs.command(
    epilog=examples(
        "understudy bench",
        "understudy bench --full --json > figures.json",
        "understudy bench threads 'by hand'",
    )
)
def bench(
    figures: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="FIGURE", help="Words in the names of figures to take; without, all that are quick."
        ),
    ] = None,
    full: Annotated[
        bool,
        typer.Option("--full", help="Those that take minutes as well, the paper's evaluation among them."),
    ] = False,
    as_json: Json = False,
) -> int:
    """Measure how fast Understudy is on this machine, and compare that with its goals.

    A missed goal is no failure: the exit code is 0 once everything has been measured. After Ctrl-C, what had been measured
    is printed. On a busy machine figures are worse than the machine is.
    """
    from .bench import measure

    return measure(figures or [], full=full, as_json=as_json)


@verbs.command(epilog=examples("understudy doctor", "understudy doctor --json"))
def doctor(as_json: Json = False) -> int:
    """Say what is installed and what is missing, with the command that mends it."""
    from .doctor import examine

    return examine(as_json=as_json)


NAMES = tuple(
    command.name or command.callback.__name__ for command in verbs.registered_commands if command.callback
)
