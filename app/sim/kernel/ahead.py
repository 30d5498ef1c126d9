"""Kernels built before there is a world for them, perhaps in another process."""

from pathlib import Path

from ...core.hierarchy import Hierarchy, Node
from ..scenario import Scenario
from ..world import empty_world
from . import build
from .source import Layout, layout_of


def is_kept(scenario: Scenario, folder: Path) -> bool:
    """Whether *folder* has the scenario's kernel, or the reason why it has none."""
    return build.is_kept(path_of(scenario, folder))


def path_of(scenario: Scenario, folder: Path) -> Path:
    """Where *folder* keeps the scenario's kernel."""
    return build.path_in(folder, scenario, _layout(scenario))


def load(scenario: Scenario, folder: Path) -> None:
    """Have the kernel ready in this process; it is compiled if *folder* does not have it.

    Raises:
        UncompilableError: numba cannot compile one of the scenario's functions.
    """
    build.build(scenario, _layout(scenario), folder=folder)


def move(room: Path, folder: Path) -> None:
    """Move all kernels from one folder to another, each whole at every moment: the index of a cache comes last."""
    for pattern in ("*.refused", "*.py", "__pycache__/*.nbc", "__pycache__/*.nbi"):
        for made in room.glob(pattern):
            goal = folder / made.relative_to(room)
            goal.parent.mkdir(exist_ok=True)
            made.replace(goal)


def writable(folder: Path | None) -> Path:
    """Where kernels are kept; the user's cache folder by default."""
    return build.writable(folder or build.cache_folder())


def _layout(scenario: Scenario) -> Layout:
    """That of any world of the scenario: they are all alike in this."""
    world = empty_world(scenario, scenario.settle({}), Hierarchy((Node("agent", "agent"),)))
    return layout_of(world, scenario)
