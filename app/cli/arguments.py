"""What several verbs take, as it is typed, and the examples below their help."""

import re
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
    """Reads a whole number, thousands apart or not, and says what is allowed and what was found."""

    def parsed(typed: str | int) -> int:  # a default comes as it is
        try:
            value = int(_without_commas(typed) if isinstance(typed, str) else typed)
        except ValueError:
            raise typer.BadParameter(f"it must be a whole number, but it is {typed!r}") from None
        if value < least:
            raise typer.BadParameter(f"it must be {least:,} or more, but it is {value:,}")
        if most is not None and value > most:
            raise typer.BadParameter(f"it must be {most:,} or less, but it is {value:,}")
        return value

    return parsed


def _without_commas(typed: str) -> str:
    """*typed* as Python reads it, if it is a whole number as our own messages write it: 1,000,000."""
    return typed.replace(",", "") if re.fullmatch(r"[+-]?\d{1,3}(,\d{3})+", typed) else typed


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
