"""Which engine steps a run: the compiled one where it can, otherwise the reference, with the same results."""

from collections.abc import Callable
from functools import cache
from importlib.util import find_spec

from ..core.errors import ScenarioError, UncompilableError
from ..core.machine import Classifiers, Leaving, stored_classifiers
from . import portable
from .engine import Engine, Start
from .reference import ReferenceEngine
from .scenario import Scenario

#: Told in a few words what takes time.
Notice = Callable[[str], None]

AUTO, REFERENCE, COMPILED = "auto", "reference", "compiled"
KINDS = (AUTO, REFERENCE, COMPILED)


def make_engine(
    start: Start,
    leaving: Leaving | None = None,
    classifiers: Classifiers = stored_classifiers,
    kind: str = AUTO,
    notice: Notice | None = None,
) -> Engine:
    """An engine for a run.

    Args:
        leaving: Told of every change of state at the top of a node, in ticks whose control listens.
        kind: ``auto`` takes the compiled engine wherever that gives the same results, ``reference`` the plain one;
            ``compiled`` insists on the compiled one.
        notice: Told in a few words what takes long, and why a run cannot be compiled.

    Raises:
        ScenarioError: There is no such kind, the scenario cannot be compiled though that was insisted on, or its reset
            failed.
    """
    if kind not in KINDS:
        raise ScenarioError(f"there is no engine {kind!r}; there are: {', '.join(KINDS)}")
    if kind == REFERENCE:
        return ReferenceEngine(start, leaving, classifiers)
    try:
        refuse_uncompilable(start.scenario)
        from .kernel import KernelEngine  # noqa: PLC0415 - numba takes half a second to import

        return KernelEngine(start, leaving, classifiers, notice)
    except UncompilableError as error:
        if kind == COMPILED:
            raise
        engine = ReferenceEngine(start, leaving, classifiers)
        engine.obstacle = f"{error}; it runs uncompiled, which is slower"
        if notice is not None:
            notice(engine.obstacle)
        return engine


def refuse_uncompilable(scenario: Scenario) -> None:
    """Raise an `UncompilableError` if compiling a scenario is impossible or would change what it does."""
    if find_spec("numba") is None:
        raise UncompilableError("numba is not installed, so nothing can be compiled")
    if found := _faults(scenario):
        raise UncompilableError(found[0])


@cache
def _faults(scenario: Scenario) -> list[str]:
    return portable.faults(scenario)
