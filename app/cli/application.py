"""From what the user typed to an exit code; every error ends here, as a message."""

import io
import os
import sys
from collections.abc import Collection, Sequence
from pathlib import Path

import typer

from ..core.errors import ParameterError, UnderstudyError
from ..core.refusals import reason
from ..core.wholes import may_be_cut_off
from ..engine.interrupts import ended_by_a_second
from .console import PROGRAM, OutputError, say, say_at_last, writing
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
        with ended_by_a_second(_end_at_once, last=arguments is None):
            code = _obey(given)
            with writing():
                sys.stdout.flush()
    except BrokenPipeError:
        code = _muted()
    except OutputError as error:
        say(str(error))
        code = _muted()
    return code


def _end_at_once() -> None:
    """End without waiting for anything but what has to be done as a whole, which takes no time."""
    if may_be_cut_off():
        say_at_last("interrupted")
        os._exit(INTERRUPTED)


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
        if isinstance(error, OSError) and (named := _named(error, given)):
            say(named)
            return WRONG_INPUT
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


def _named(error: OSError, given: Collection[str]) -> str:
    """What the system has against a place that the user named, or one on the way there; empty where it is about another."""
    if not isinstance(error.filename, str):
        return ""
    place = Path(error.filename)
    words = [Path(word.rpartition("=")[2]) for word in given]
    if not any(place in (word, word.absolute(), *word.parents, *word.absolute().parents) for word in words):
        return ""
    return f"{error.filename}: {reason(error)}"


def _usage(error: typer.TyperException) -> str:
    """What is wrong with what was typed, and where to read on."""
    context = getattr(error, "ctx", None)
    path = PROGRAM if context is None else context.command_path
    return f"{error.format_message()}\n  {path} --help says what can be given".replace(f" {STUDIO} ", " ")


def _muted() -> int:
    """Write no output from here on, at the interpreter's end neither."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return FELL_SHORT
