"""From what the user typed to an exit code; every error ends here, as a message."""

import io
import os
import sys
from collections.abc import Collection, Sequence
from pathlib import Path

import typer

from ..core.errors import ParameterError, UnderstudyError
from .console import PROGRAM, OutputError, say, writing
from .exits import FELL_SHORT, INTERRUPTED, WRONG_INPUT
from .verbs import NAMES, STUDIO, verbs
from .wording import unknown

DEBUG = "--debug"
#: Options of the program itself; an option that comes first without being one of them is meant for the studio.
OWN_OPTIONS = ("-h", "--help", "--version")


def main(arguments: Sequence[str] | None = None) -> int:
    """Do what *arguments* (by default: the command line's) ask for.

    Returns:
        The exit code: 0 done, 1 the work ran and something in it fell short, 2 the input was wrong, 130 interrupted.
    """
    given = list(sys.argv[1:] if arguments is None else arguments)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")  # a name that the encoding lacks is no failure
    try:
        code = _obey(given)
        with writing():
            sys.stdout.flush()
    except BrokenPipeError:
        code = _muted()
    except OutputError as error:
        say(str(error))
        code = _muted()
    return code


def _obey(given: list[str]) -> int:
    """Have the verb obeyed; every exception becomes a message and an exit code."""
    debug = DEBUG in given
    try:
        typed = with_verb([argument for argument in given if argument != DEBUG], NAMES)
        code = int(typer.main.get_command(verbs).main(typed, PROGRAM, standalone_mode=False) or 0)
    except (KeyboardInterrupt, typer.Abort):
        code = INTERRUPTED
    except UnderstudyError as error:
        say(str(error))
        return WRONG_INPUT
    except typer.TyperException as error:
        say(_usage(error))
        return WRONG_INPUT
    except (BrokenPipeError, OutputError):
        raise
    except Exception as error:  # noqa: BLE001 - the last place where it can become a message
        from .crash import report

        report(error, given, show=debug)
        return FELL_SHORT
    if code == INTERRUPTED:
        say("interrupted")
    return code


def with_verb(given: Sequence[str], names: Collection[str]) -> list[str]:
    """*given* with the studio's verb put first where no verb is given: nothing, a path, or an option of its own.

    Raises:
        ParameterError: The first word is neither a verb nor looks like a path.
    """
    first = given[0] if given else ""
    if first in OWN_OPTIONS or first in names:
        return list(given)
    if not first or first.startswith("-") or os.sep in first or Path(first).suffix or Path(first).exists():
        return [STUDIO, *given]
    there_is = unknown("verb", first, [name for name in names if name != STUDIO])
    raise ParameterError(f"there is no folder {first!r}, and {there_is}")


def _usage(error: typer.TyperException) -> str:
    """What is wrong with what was typed, and where to read on."""
    context = getattr(error, "ctx", None)
    path = PROGRAM if context is None else context.command_path
    return f"{error.format_message()}\n  {path} --help says what can be given".replace(f" {STUDIO} ", " ")


def _muted() -> int:
    """Write no output from here on, at the interpreter's end neither."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return FELL_SHORT
