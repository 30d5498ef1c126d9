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
#: What stands for a whole number in the help.
WHOLE = "N"


def whole(least: int, most: int | None = None) -> Callable[[str], int]:
    """Reads a whole number, and says what is allowed and what was found."""

    def parsed(typed: str) -> int:
        try:
            value = int(typed)
        except ValueError:
            raise typer.BadParameter(f"it must be a whole number, but it is {typed!r}") from None
        if value < least:
            raise typer.BadParameter(f"it must be {least} or more, but it is {value}")
        if most is not None and value > most:
            raise typer.BadParameter(f"it must be {most} or less, but it is {value}")
        return value

    return parsed


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
    int,
    typer.Option(
        parser=whole(0), metavar=WHOLE, help="Settles chance; further runs take the seeds after it."
    ),
]
Jobs = Annotated[
    int | None,
    typer.Option(
        parser=whole(1),
        metavar=WHOLE,
        help="Runs at a time.",
        show_default="one a core",
    ),
]
