"""A foraging project of authored behaviors in a folder, for the command line to work on."""

from dataclasses import replace
from pathlib import Path

from app.core.automaton import Automaton
from app.core.library import Library
from app.core.project import Arm, LevelTable, Project
from app.core.storage import save
from tests.foragers import libraries
from tests.samples import AGENT, GROUP, SQUAD, TYPES

ARMS = (
    Arm("independent", LevelTable((10,), (AGENT,)), "Forage"),
    Arm("one level", LevelTable((2, 5), (GROUP, AGENT)), "ControlForage"),
    Arm("two levels", LevelTable((1, 2, 5), (SQUAD, GROUP, AGENT)), "ControlForage2"),
)


def project(arms: tuple[Arm, ...] = ARMS) -> Project:
    """Ten agents in three structures."""
    by_type = {
        name: Library({i: numbered(a) for i, a in lib.automata.items()}) for name, lib in libraries().items()
    }
    return Project("Boxes", "foraging", TYPES, libraries=by_type, arms=arms)


def numbered(automaton: Automaton) -> Automaton:
    """*automaton* with rule ids that stand once."""
    rules = tuple(replace(rule, id=str(number)) for number, rule in enumerate(automaton.rules, 1))
    return replace(automaton, rules=rules)


def stored(folder: Path, made: Project | None = None) -> Path:
    """*folder*, with a project in it."""
    save(made or project(), folder)
    return folder
