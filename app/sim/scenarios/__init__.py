"""The scenarios that ship with Understudy, one module each; a module added here is found by its name."""

from collections.abc import Sequence
from importlib import import_module
from pkgutil import iter_modules

from ...core.errors import ScenarioError
from ..scenario import Scenario


def names() -> Sequence[str]:
    """The names of all shipped scenarios."""
    return sorted(module.name for module in iter_modules(__path__))


def shipped(name: str) -> Scenario:
    """The shipped scenario called *name*.

    Raises:
        ScenarioError: There is none; the message names those there are.
    """
    if name not in names():
        raise ScenarioError(f"there is no scenario {name!r}; there are: {', '.join(names())}")
    found: Scenario = import_module(f".{name}", __name__).scenario
    return found
