"""What several verbs take, as it is typed, and the examples below their help."""

from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import typer


def examples(*lines: str) -> str:
    """What stands below the help of a verb."""
    return "\n".join(("Examples:\n", *lines))


#: The longest run, and the most runs, that can be asked for: more than anybody waits for.
MOST_TICKS = 1_000_000_000
MOST_RUNS = 1_000_000


def between(least: int, most: int | None = None) -> Callable[[int | None], int | None]:
    """A check of a whole number, if there is one, that says what is allowed and what was found."""

    def checked(value: int | None) -> int | None:
        if value is not None and value < least:
            raise typer.BadParameter(f"it must be {least} or more, but it is {value}")
        if value is not None and most is not None and value > most:
            raise typer.BadParameter(f"it must be {most} or less, but it is {value}")
        return value

    return checked


ProjectFolder = Annotated[Path, typer.Argument(metavar="PROJECT", help="The project's folder.")]
Behaviors = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="BEHAVIOR", help="Names, such as Goto or agent/Goto; all behaviors if there are none."
    ),
]
Json = Annotated[
    bool, typer.Option("--json", help="Print one JSON document on stdout, and nothing else there.")
]
Trust = Annotated[bool, typer.Option("--trust", help="Run the Python code that the project carries.")]
Picture = Annotated[
    Path | None, typer.Option(metavar="FILE", help="Draw the result: .png, .svg or .pdf.", dir_okay=False)
]
Dark = Annotated[bool, typer.Option("--dark", help="Draw it on a dark ground.")]
Seed = Annotated[
    int, typer.Option(callback=between(0), help="Settles chance; further runs take the seeds after it.")
]
Jobs = Annotated[
    int | None,
    typer.Option(
        callback=between(1),
        help="Runs at a time.",
        show_default="one a core",
    ),
]
