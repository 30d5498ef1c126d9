"""Projects to begin with: agents in a scenario, and no behaviors of their own yet."""

from dataclasses import replace
from pathlib import Path

from ..core.errors import EditError, ScenarioError, StorageError
from ..core.library import NodeType
from ..core.project import Arm, LevelTable, Project
from ..core.storage import save
from ..core.vocabulary import Vocabulary
from ..sim.scenario import Scenario
from .scenarios import OWN_CODE

#: As many as in the paper.
AGENTS = 50
AGENT, GROUP = "agent", "group"
#: More nodes than this are no quick arm: a window and a machine have to bear them.
MOST_AGENTS = 100_000


def fresh_project(name: str, scenario: Scenario, agents: int = AGENTS, groups: int = 0) -> Project:
    """A project without behaviors of its own.

    Args:
        agents: How many there are altogether or, where there are *groups*, in each.
        groups: How many controllers of a group of agents each; 0 for independent agents.

    Raises:
        EditError: There would be no agents, or too many.
    """
    refuse_numbers(agents, groups)
    top = first_behavior(scenario.vocabulary)
    if not groups:
        arm = Arm("independent", LevelTable((agents,), (AGENT,)), top)
        return Project(name, scenario.name, (NodeType(AGENT),), arms=(arm,))
    arm = Arm("groups", LevelTable((groups, agents), (GROUP, AGENT)), top)
    return Project(name, scenario.name, (NodeType(AGENT), NodeType(GROUP, 1, (AGENT,))), arms=(arm,))


def refuse_numbers(agents: int, groups: int) -> None:
    """Raise an `EditError` if there would be no agents, or too many."""
    total = agents * max(groups, 1)
    if agents < 1 or groups < 0 or total > MOST_AGENTS:
        raise EditError(f"an arm has 1 to {MOST_AGENTS:,} agents, but this one would have {max(total, 0):,}")


def save_with_code(project: Project, code: Path, folder: Path) -> Project:
    """Save a new *project* that lives in the world of a file of the user's own, which it brings along; returns it so.

    Raises:
        FilesError, OSError: It cannot be written.
    """
    text = code.read_bytes()  # before anything is made
    own = replace(project, scenario=OWN_CODE)
    save(own, folder)
    (folder / OWN_CODE).write_bytes(text)
    return own


def first_behavior(vocabulary: Vocabulary) -> str:
    """The first basic behavior that agents can go on with, all by itself.

    Raises:
        ScenarioError: All of them run only once, or have a target.
    """
    for behavior in vocabulary.behaviors.values():
        if not behavior.runs_once and not behavior.parameters:
            return behavior.name
    raise ScenarioError("the scenario has no basic behavior that agents can go on with")


def refuse_folder(folder: Path) -> None:
    """Raise a `StorageError` if something is in *folder* already, or it is none."""
    if folder.exists() and not folder.is_dir():
        raise StorageError(
            f"{folder}: this is a file; a new project needs a folder that is not there yet, or is empty"
        )
    if folder.is_dir() and any(folder.iterdir()):
        raise StorageError(
            f"{folder}: something is in this folder; a new project needs one that is not there, or is empty"
        )
