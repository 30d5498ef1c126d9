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
    return ScenarioError(
        f"scenario {scenario!r}, {what}, {_place(function, error)}: {type(error).__name__}: {error}"
    )


def broke(scenario: str, what: str, function: Callable[..., Any], how: str) -> ScenarioError:
    """The error for a function that broke the contract."""
    code = function.__code__
    place = _in(code.co_name, code.co_filename, code.co_firstlineno)
    return ScenarioError(f"scenario {scenario!r}, {what}, {place}: {how}")


def _place(function: Callable[..., Any], error: Exception) -> str:
    """The innermost place in the file of *function*: what it calls elsewhere is not where to look."""
    code = function.__code__
    place, trace = _in(code.co_name, code.co_filename, code.co_firstlineno), error.__traceback__
    while trace is not None:
        inner = trace.tb_frame.f_code
        if inner.co_filename == code.co_filename:
            place = _in(inner.co_name, inner.co_filename, trace.tb_lineno)
        trace = trace.tb_next
    return place


def _in(function: str, file: str, line: int) -> str:
    return f"{function} in {Path(file).name}, line {line}"
