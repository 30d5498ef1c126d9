"""What each declaration of a scenario has to keep to: plain functions of the right arguments, names given once."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from inspect import signature
from types import FunctionType
from typing import Any

from ..core.errors import ScenarioError


@contextmanager
def blaming(scenario: str) -> Iterator[None]:
    """Say in which scenario a declaration went wrong."""
    try:
        yield
    except ScenarioError as error:
        raise ScenarioError(f"scenario {scenario!r}: {error}") from error


def promise(function: Callable[..., Any]) -> str:
    """What the first line of a function's docstring says; empty if it has none."""
    return (function.__doc__ or "").strip().split("\n")[0]


def refuse_bad_function(what: str, function: Callable[..., Any], arguments: int) -> None:
    """Raise a `ScenarioError` if *function* is no plain one, or cannot be called with so many arguments."""
    if not isinstance(function, FunctionType) or function.__name__ == "<lambda>":
        raise ScenarioError(f"{what} has to be a plain function, not {function!r}")
    try:
        signature(function).bind(*[None] * arguments)
    except TypeError:
        found = ", ".join(signature(function).parameters) or "none"
        raise ScenarioError(
            f"{what} is called with {arguments} arguments, but {function.__name__} takes: {found}"
        ) from None


def refuse_twice(what: str, parameters: Iterable[str]) -> None:
    """Raise a `ScenarioError` if *parameters* have a name twice."""
    seen: set[str] = set()
    for parameter in parameters:
        if parameter in seen:
            raise ScenarioError(f"{what} names the parameter {parameter!r} twice")
        seen.add(parameter)
