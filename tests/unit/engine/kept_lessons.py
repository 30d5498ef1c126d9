"""Lessons that a hand gave, and the demonstrations that are kept of them."""

from typing import Any

from app.core.automaton import Basic
from app.core.check import check as find_problems
from app.core.edits import (
    add_demonstration,
    replace_examples,
    set_learned,
)
from app.core.features import Ground
from app.core.project import Demonstration, Project
from app.engine.demonstrations import play
from app.learner.trainer import apply, learn
from tests.corridor import corridor
from tests.driver import Driver
from tests.samples import AGENT

SHUTTLE = (AGENT, "Shuttle")
#: No state of Shuttle holds it yet.
TOWARD = Basic("Toward", {"target": Ground("lamp")})


def lesson(nodes: str | tuple[str, ...] = "agent-1", **fields: Any) -> Driver:
    return Driver().teach(nodes, "Shuttle", demonstration="shuttle-1", **fields)


def kept(driver: Driver) -> Demonstration:
    """What was done, which nothing keeps from being played."""
    assert driver.obstacle == ""
    assert driver.demonstration is not None
    return driver.demonstration


def played(driver: Driver, where: tuple[str, str] = SHUTTLE) -> Project:
    """The project as it was before the lesson, with what playing its demonstration records."""
    untaught = replace_examples(driver.project, *where, (), {})
    untaught = set_learned(untaught, *where, {}, "")
    return play(untaught, corridor, kept(driver))


def check(driver: Driver, where: tuple[str, str] = SHUTTLE) -> None:
    again = played(driver, where)
    assert again.examples_of(*where) == driver.project.examples_of(*where)
    assert again.moments == driver.project.moments


def learned(project: Project) -> Project:
    """The project with what is learned in the background."""
    return apply(project, learn(project, corridor.vocabulary, [SHUTTLE]))


def problems(driver: Driver) -> list[str]:
    """What is wrong with the project that keeps the demonstration."""
    there = driver.project.demonstrations
    project = driver.project if there else add_demonstration(driver.project, kept(driver))[0]
    found = find_problems(project, corridor.vocabulary)
    return [problem.message for problem in found if problem.file.startswith("demonstrations/")]


def acts(driver: Driver) -> list[str]:
    return [f"{pick.tick} {pick.act} {pick.node} {pick.state}".strip() for pick in kept(driver).picks]
