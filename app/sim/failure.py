"""What a scenario's function did wrong, told so that its author finds the place."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from ..core.errors import ScenarioError


def failed(scenario: str, what: str, function: Callable[..., Any], error: Exception) -> ScenarioError:
    """The error for a function that raised: what it raised, and in which function and line of the scenario's file.

    Args:
        what: What the function is declared as, e.g. ``feature 'DistanceTo'``.
    """
    code = function.__code__
    name, line = place_in(code.co_filename, error)
    if line == 0:  # it could not even be called
        name, line = code.co_name, code.co_firstlineno
    return _error(scenario, what, (name, code.co_filename, line), f"{type(error).__name__}: {error}")


def broke(scenario: str, what: str, function: Callable[..., Any], how: str) -> ScenarioError:
    """The error for a function that broke the contract."""
    code = function.__code__
    return _error(scenario, what, (code.co_name, code.co_filename, code.co_firstlineno), how)


def place_in(file: str, error: BaseException) -> tuple[str, int]:
    """The innermost function and line of *file* that was running: what is called elsewhere is not where to look.

    Line 0 if nothing of that file was running.
    """
    place, trace = ("", 0), error.__traceback__
    while trace is not None:
        code = trace.tb_frame.f_code
        if code.co_filename == file:
            place = code.co_name, trace.tb_lineno
        trace = trace.tb_next
    return place


def _error(scenario: str, what: str, place: tuple[str, str, int], how: str) -> ScenarioError:
    function, file, line = place
    return ScenarioError(
        f"scenario {scenario!r}, {what}, {function} in {Path(file).name}, line {line}: {how}"
    )
