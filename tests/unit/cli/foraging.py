"""A foraging project of authored behaviors in a folder, for the command line to work on."""

from dataclasses import replace
from pathlib import Path

from app.core.automaton import START, Automaton, Rule
from app.core.features import FeatureUse, Ground, Parameter, Sense
from app.core.library import Library
from app.core.project import Arm, Demonstration, LevelTable, Pick, Project
from app.core.storage import save
from tests.foragers import libraries
from tests.samples import AGENT, GROUP, SQUAD, TYPES, automaton, flag, nested, state

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


def taught() -> Project:
    """Agents that are to learn to go to the deposit from one demonstration, and have not yet."""
    goto = automaton(
        "Goto",
        state("forward", "Forward"),
        state("left", "RotateLeft"),
        flag("arrived"),
        parameters=("target",),
        features=(
            FeatureUse("distance", Sense("DistanceTo", {"target": Parameter("target")})),
            FeatureUse("direction", Sense("DirectionTo", {"target": Parameter("target")})),
        ),
    )
    home = automaton(
        "Home",
        nested("go", "Goto", {"target": Ground("deposit")}),
        rules=(Rule("1", START, (), "go"),),
    )
    picks = tuple(
        Pick(tick, "agent-1", name)
        for tick, name in ((0, "left"), (40, "forward"), (90, "left"), (120, "forward"))
    )
    shown = Demonstration(
        "goto-1", AGENT, "Goto", "independent", 1, picks, 200, arguments={"target": "deposit"}
    )
    arm = Arm("independent", LevelTable((3,), (AGENT,)), "Home")
    library = Library({"Goto": goto, "Home": home})
    return Project(
        "Homing", "foraging", TYPES[:1], libraries={AGENT: library}, arms=(arm,), demonstrations=(shown,)
    )
