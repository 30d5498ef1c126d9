"""What one click can do about problems: it mends them, on the shipped project damaged in every way that has a fix."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from app.core.automaton import Automaton, Basic, Nested, State
from app.core.check import Problem, check
from app.core.check.fixes import fixes
from app.core.check.spots import Spot, spot_of
from app.core.edits import add_feature, add_state, bind_state, set_parameters, set_world
from app.core.edits.place import change, with_automaton
from app.core.features import FeatureUse, FlagUp, Ground, Operation, Over, Sense, Statistic
from app.core.hierarchy import Hierarchy, Node
from app.core.project import Project
from app.core.storage import load
from app.engine.scenarios import open_scenario

FORAGING = Path(__file__).parents[3] / "projects" / "foraging"
WHERE = ("agent", "return-with-box")


@pytest.fixture(scope="module")
def project() -> Project:
    return load(FORAGING)


def found(project: Project) -> tuple[Problem, ...]:
    return check(project, open_scenario(project).vocabulary)


def offered(project: Project, problem: Problem) -> dict[str, Callable[[Project], Project]]:
    types = project.types_with(open_scenario(project).vocabulary)
    return {fix.text: fix.mend for fix in fixes(problem, project, types)}


def automaton(project: Project) -> Automaton:
    return project.library(WHERE[0]).get(WHERE[1])


def with_arm(project: Project, **fields: Any) -> Project:
    first = replace(project.arms[0], **fields)
    return replace(project, arms=(first, *project.arms[1:]))


def open_binding(project: Project) -> Project:
    state = next(
        s for s in automaton(project).states if s.content == Nested("goto", {"X": Ground("deposit")})
    )
    return bind_state(project, *WHERE, state.id, "X", None)


def wrong_target(project: Project) -> Project:
    state = next(s for s in automaton(project).states if isinstance(s.content, Nested))
    return bind_state(project, *WHERE, state.id, "X", Ground("the moon"))


def unreachable(project: Project) -> Project:
    return add_state(project, *WHERE, Basic("Forward"))[0]


def misspelled(project: Project) -> Project:
    states = tuple(
        replace(s, content=Basic("GrabBx")) if s.content == Basic("GrabBox") else s
        for s in automaton(project).states
    )
    return change(project, *WHERE, states=states)


def strange_feature(project: Project) -> Project:
    return change(
        project, *WHERE, features=(*automaton(project).features, FeatureUse("new", Sense("ICanSeABox")))
    )


def silent_flag(project: Project) -> Project:
    return add_feature(project, *WHERE, FlagUp("lost"))[0]


def about_nobody(project: Project) -> Project:
    source = Statistic(Operation.ANY, Sense("ICanSeeABox"), Over.SUBSIDIARIES)
    return add_feature(project, "squad", "control-forage-2", source)[0]


def same_name(project: Project) -> Project:
    twin = replace(automaton(project), id="twin")
    return with_automaton(project, "agent", twin)


def unused_parameter(project: Project) -> Project:
    return set_parameters(project, "agent", "wander", ("speed",))


def unmeasured(project: Project) -> Project:
    return add_feature(project, "agent", "goto", Sense("IAmAttachedToABox"))[0]


def no_such_top(project: Project) -> Project:
    return with_arm(project, top="Forge")


def no_such_world(project: Project) -> Project:
    return with_arm(set_world(project, "flat", {}), world="flatt")


def wrong_node(project: Project) -> Project:
    roots = (Node("a", "agent"), Node("b", "group"))
    return with_arm(project, hierarchy=Hierarchy(roots), top="Forage")


def no_such_arm(project: Project) -> Project:
    first = replace(project.demonstrations[0], arm="gone")
    return replace(project, demonstrations=(first, *project.demonstrations[1:]))


DAMAGES: dict[Callable[[Project], Project], str] = {
    open_binding: "bind 'X' to deposit",
    wrong_target: "bind 'X' to deposit",
    unreachable: "remove the state",
    misspelled: "let it hold GrabBox",
    strange_feature: "look at ICanSeeABox",
    silent_flag: "stop looking at the flag",
    about_nobody: "range over all agents below",
    same_name: "rename it to ReturnWithBox 2",
    unused_parameter: "drop the parameter",
    unmeasured: "disable the examples that lack it",
    no_such_top: "start with Forage",
    no_such_world: "take the world 'flat'",
    wrong_node: "remove the node",
    no_such_arm: "remove the demonstration",
}


@pytest.mark.parametrize(
    ("damage", "text"), DAMAGES.items(), ids=lambda value: getattr(value, "__name__", "")
)
def test_the_fix_mends_what_it_says(
    project: Project, damage: Callable[[Project], Project], text: str
) -> None:
    broken = damage(project)
    problem = next(p for p in found(broken) if text in offered(broken, p))
    mended = offered(broken, problem)[text](broken)
    assert problem not in found(mended)


@pytest.mark.parametrize("damage", DAMAGES, ids=lambda value: value.__name__)
def test_every_fix_that_is_offered_is_an_edit_that_works(
    project: Project, damage: Callable[[Project], Project]
) -> None:
    broken = damage(project)
    for problem in found(broken)[:20]:
        for mend in offered(broken, problem).values():
            assert mend(broken) is not broken


def test_a_problem_knows_the_state_it_is_about(project: Project) -> None:
    broken = unreachable(project)
    problem = found(broken)[0]
    new = automaton(broken).states[-1].id
    assert spot_of(problem, broken) == Spot("agent", "return-with-box", state=new)


def test_a_problem_of_an_arm_knows_the_arm_and_the_node(project: Project) -> None:
    broken = wrong_node(project)
    spots = [spot_of(problem, broken) for problem in found(broken)]
    assert any((spot.arm, spot.node) == ("independent", "b") for spot in spots)


def test_a_place_that_is_gone_is_about_the_behavior_alone(project: Project) -> None:
    problem = Problem("libraries/agent/goto.json", "states[99].content", "")
    assert spot_of(problem, project).automaton == "goto"
    assert not spot_of(problem, project).state
    assert spot_of(Problem("libraries/agent/none.json", "states[0]", ""), project).state == ""


def test_a_learned_model_is_about_its_state(project: Project) -> None:
    problem = Problem("libraries/agent/goto.json", 'learned["no-such"]', "")
    assert spot_of(problem, project).state == "no-such"
    assert spot_of(replace(problem, where="learned.start"), project).state == "start"


def test_nothing_is_offered_where_the_user_has_to_decide(project: Project) -> None:
    states = (automaton(project).states[0], State("loop", Nested("return-with-box")))
    looped = change(project, *WHERE, states=states, learned={}, rules=())
    problem = next(p for p in found(looped) if "recursion" in p.message)
    assert list(offered(looped, problem)) == ["remove the state"]
    type_problem = Problem("project.json", "types", "there are no node types")
    assert offered(project, type_problem) == {}
