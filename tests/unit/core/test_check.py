"""What is wrong with a project, by file and place: libraries, bindings, features."""

from dataclasses import replace

import pytest

from app.core.automaton import Automaton, Basic, Nested, RaiseFlag, Start, State
from app.core.check import Problem, check
from app.core.features import (
    FeatureUse,
    FlagUp,
    Ground,
    Operation,
    Over,
    Parameter,
    Sense,
    Source,
    Statistic,
    TicksInState,
)
from app.core.library import Library
from app.core.project import Project
from tests.samples import AGENT, GROUP, SQUAD, automaton, flag, nested, project, state, vocabulary
from tests.unit.core.problems import only


def with_automata(*automata: Automaton, type_name: str = AGENT) -> Project:
    """The sample with these automata added, or in the place of those with the same ids."""
    library = {**project().library(type_name).automata, **{a.id: a for a in automata}}
    return replace(project(), libraries={**project().libraries, type_name: Library(library)})


def messages(changed: Project, severity: str = "error") -> list[str]:
    return [str(problem) for problem in check(changed, vocabulary()) if problem.severity == severity]


def test_nothing_is_wrong_with_the_sample() -> None:
    assert check(project(), vocabulary()) == ()


def test_a_problem_is_told_with_file_place_and_message() -> None:
    problem = Problem("libraries/agent/goto.json", "states[2]", "it is wrong")
    assert str(problem) == "libraries/agent/goto.json: states[2]: it is wrong"
    assert str(Problem("project.json", "", "it is wrong")) == "project.json: it is wrong"


# ------------------------------------------------------------------------------------------- libraries


def test_a_cycle_is_spelled_out() -> None:
    a, b, c = (automaton(x, nested("next", y)) for x, y in (("a", "b"), ("b", "c"), ("c", "a")))
    problem = only(with_automata(a, b, c))
    assert problem.message == "recursion is not permitted, but a holds b holds c holds a"
    assert (problem.file, problem.where) == ("libraries/agent/a.json", "states[1].content.automaton")


def test_an_automaton_that_holds_itself_is_a_cycle_and_each_knot_is_told_once() -> None:
    a, b, c = (automaton(x, nested("next", y)) for x, y in (("a", "a"), ("b", "c"), ("c", "b")))
    cycles = [m.split("but ")[1] for m in messages(with_automata(a, b, c))]
    assert sorted(cycles) == ["a holds a", "b holds c holds b"]


def test_an_automaton_that_is_held_must_exist() -> None:
    problem = only(with_automata(automaton("a", nested("go", "gotoo"))))
    assert (problem.file, problem.where) == ("libraries/agent/a.json", "states[1].content.automaton")
    assert (
        "state go of a holds the behavior with the id 'gotoo', which the library of 'agent' lacks"
        in problem.message
    )
    assert "did you mean 'goto'? there are: 'a', 'fetch', 'forage', 'goto', 'wander'" in problem.message


def test_a_basic_behavior_must_be_in_the_scenario() -> None:
    problem = only(with_automata(automaton("a", state("walk", "Foreward"))))
    assert problem.where == "states[1].content.behavior"
    assert (
        "holds 'Foreward', which is no basic behavior of the scenario; did you mean 'Forward'?"
        in problem.message
    )


def test_a_controller_directs_only_what_all_its_subsidiaries_share() -> None:
    problem = only(with_automata(automaton("lead", state("fly", "Fly")), type_name=GROUP))
    assert (
        "which is no behavior of 'group' that all its subsidiaries share by name and parameters"
        in problem.message
    )


def test_names_are_used_once_in_a_type() -> None:
    twin = replace(project().library(AGENT).get("wander"), id="stroll")
    assert sorted((p.file, p.where) for p in check(with_automata(twin), vocabulary())) == [
        ("libraries/agent/stroll.json", "name"),
        ("libraries/agent/wander.json", "name"),
    ]
    forward = replace(twin, name="Forward")
    assert "'agent' has a basic behavior called 'Forward' already" in only(with_automata(forward)).message
    unnamed = replace(twin, name=" ")
    assert "the behavior has no name" in only(with_automata(unnamed)).message


def test_a_controller_may_hide_a_behavior_that_it_directs() -> None:
    own = automaton("goto", state("search", "forage"))
    changed = with_automata(own, type_name=GROUP)
    assert messages(changed) == []
    assert any("controllers above reach only this one" in m for m in messages(changed, "warning"))


def test_ids_are_used_once() -> None:
    double = automaton("a", state("x", "Forward"), state("x", "RotateLeft"))
    assert only(with_automata(double)).where == "states[2].id"
    misfiled = replace(
        project(), libraries={AGENT: Library({**project().library(AGENT).automata, "b": automaton("a")})}
    )
    assert "the id must be 'b', but it is 'a'" in str(messages(misfiled))


def test_the_first_state_and_no_other_is_start() -> None:
    bare = Automaton("a", "a", states=(state("x", "Forward"),))
    assert (
        "the first state of a must be Start with the id 'start', but it is 'x'"
        in only(with_automata(bare)).message
    )
    assert "but it is 'none'" in only(with_automata(replace(bare, states=()))).message
    second = automaton("a", State("again", Start()))
    assert only(with_automata(second)).where == "states[1].content"
    nameless = automaton("a", State("x", RaiseFlag("")))
    assert only(with_automata(nameless)).where == "states[1].content.flag"


# -------------------------------------------------------------------------------------------- bindings


def bound(
    binding: Ground | Parameter | None, slot: str = "target", parameters: tuple[str, ...] = ()
) -> Project:
    """The sample with an automaton whose one state goes to a target."""
    held = Nested("goto", {} if binding is None else {slot: binding})
    return with_automata(automaton("a", State("x", held, "Approach"), parameters=parameters))


def test_an_open_binding_names_the_slot_and_the_state() -> None:
    problem = only(bound(None))
    assert problem.where == "states[1].content.bindings"
    assert problem.message == (
        "'target' of goto is open in state Approach of a: bind it to a target (deposit, nearest-box) or to a parameter "
        "of a (none)"
    )


def test_an_open_binding_of_a_feature_names_the_feature() -> None:
    use = FeatureUse("far", Sense("DistanceTo"), "far away")
    problem = only(with_automata(automaton("a", features=(use,))))
    assert problem.where == "features[0].source.bindings"
    assert "'target' of DistanceTo is open in feature far away of a" in problem.message


def test_a_slot_that_is_not_there_cannot_be_bound() -> None:
    held = Basic("Forward", {"target": Ground("deposit")})
    problem = only(with_automata(automaton("a", State("x", held))))
    assert problem.where == "states[1].content.bindings.target"
    assert "Forward has no such slot; it has: none" in problem.message
    assert problem.fix == "drop the binding"
    assert problem.mend is not None
    assert messages(problem.mend(with_automata(automaton("a", State("x", held))))) == []


def test_a_binding_to_a_parameter_needs_the_parameter() -> None:
    problem = only(bound(Parameter("goal"), parameters=("goals",)))
    assert (
        "is bound to parameter 'goal', which a lacks; did you mean 'goals'? it has: 'goals'"
        in problem.message
    )
    assert problem.fix == "add the parameter 'goal' to a"
    assert problem.mend is not None
    assert messages(problem.mend(bound(Parameter("goal")))) == []
    assert messages(bound(Parameter("goal"), parameters=("goal",))) == []


def test_a_target_must_be_in_the_scenario() -> None:
    problem = only(bound(Ground("depot")))
    assert (
        "is bound to 'depot', which is no target of the scenario; did you mean 'deposit'? targets"
        in problem.message
    )


def test_a_target_of_a_higher_level_cannot_be_bound() -> None:
    problem = only(bound(Ground("closest-attached-agent")))
    assert problem.where == "states[1].content.bindings.target"
    assert "which only nodes of level 1 and up can bind, and 'agent' has level 0" in problem.message
    big = Basic("goto", {"target": Ground("biggest-attached-agent")})
    assert "level 2 and up" in only(with_automata(automaton("a", State("x", big)), type_name=GROUP)).message
    assert messages(with_automata(automaton("a", State("x", big)), type_name=SQUAD)) == []


def test_parameters_have_different_names_and_are_used() -> None:
    double = replace(project().library(AGENT).get("goto"), parameters=("target", "target"))
    assert "parameter 'target' of goto stands twice" in only(with_automata(double)).message
    nameless = automaton("a", parameters=("",))
    assert "has no name" in only(with_automata(nameless)).message
    unused = only(
        with_automata(replace(project().library(AGENT).get("wander"), parameters=("p",))), "warning"
    )
    assert "nothing in wander is bound to its parameter 'p'" in unused.message
    assert unused.mend is not None
    assert check(unused.mend(with_automata(automaton("wander", parameters=("p",)))), vocabulary())


# -------------------------------------------------------------------------------------------- features


def looking(source: Source, type_name: str = AGENT) -> Project:
    """The sample with an automaton that looks at *source* only."""
    there = project().library(type_name).automata
    base = there.get("wander") or there.get("control")
    features = (FeatureUse("f", source),)
    copy = (
        automaton("a", features=features)
        if base is None
        else replace(base, id="a", name="a", features=features, rules=())
    )
    return with_automata(copy, type_name=type_name)


def warnings_of(changed: Project, part: str) -> list[str]:
    return [m for m in messages(changed, "warning") if part in m]


def test_a_feature_must_be_in_the_scenario() -> None:
    problem = only(looking(Sense("SeesBox")))
    assert problem.where == "features[0].source.feature"
    assert (
        "a looks at 'SeesBox', which is no feature of the scenario; did you mean 'SeesABox'?"
        in problem.message
    )


def test_a_controller_cannot_sense_and_is_told_to_use_a_statistic() -> None:
    problem = only(looking(Sense("SeesABox"), GROUP))
    assert "a controller has no body: use a statistic of it, such as 'any SeesABox'" in problem.message


def test_an_agent_has_no_feature_of_controllers_and_no_subsidiaries() -> None:
    assert "which only controllers have" in only(looking(Sense("SomeoneNeedsHelp"))).message
    problem = only(looking(Statistic(Operation.ANY, Sense("SeesABox"))))
    assert "is a statistic over subsidiaries, but agents have none" in problem.message


def test_ticks_in_state_are_there_for_everyone() -> None:
    assert messages(looking(TicksInState())) == []
    assert messages(looking(TicksInState(), GROUP)) == []


def test_a_statistic_is_of_what_agents_sense() -> None:
    problem = only(looking(Statistic(Operation.ANY, Sense("SomeoneNeedsHelp")), GROUP))
    assert problem.where == "features[0].source.of.feature"
    assert "sums up 'SomeoneNeedsHelp', which is no feature that agents sense" in problem.message
    unbound = only(looking(Statistic(Operation.MEAN, Sense("DistanceTo")), GROUP))
    assert unbound.where == "features[0].source.of.bindings"


def test_a_statistic_that_ranges_over_nobody_is_pointed_out() -> None:
    direct = Statistic(Operation.ANY, Sense("SeesABox"), Over.SUBSIDIARIES)
    assert not warnings_of(looking(direct, GROUP), "about nobody")
    assert warnings_of(looking(direct, SQUAD), "let it range over all agents below")
    assert not warnings_of(looking(replace(direct, over=Over.AGENTS), SQUAD), "about nobody")


def test_a_flag_that_nobody_raises_is_pointed_out() -> None:
    def up(name: str) -> list[str]:
        forage = project().library(AGENT).get("forage")
        return messages(
            with_automata(replace(forage, features=(*forage.features, FeatureUse("f", FlagUp(name))))),
            "warning",
        )

    assert any("feature done of forage is the same as feature 'done'" in m for m in up("done"))
    assert any(
        "the flag 'failed' is never up in forage: no automaton that its states hold raises it" in m
        for m in up("failed")
    )
    assert any("raised are: 'done'" in m for m in up("finished"))


def test_a_flag_that_no_node_below_shows_is_pointed_out() -> None:
    for flag_name, over, type_name, silent in (
        ("finished", Over.AGENTS, GROUP, True),
        ("done", Over.AGENTS, SQUAD, True),
        ("lost", Over.AGENTS, GROUP, False),
        ("done", Over.SUBSIDIARIES, SQUAD, False),  # the groups' own behavior raises no flag
    ):
        changed = looking(Statistic(Operation.ANY, FlagUp(flag_name), over), type_name)
        assert (warnings_of(changed, "shows that flag") == []) is silent, flag_name


@pytest.mark.parametrize("name", ["done", "failed", "lost"])
def test_flags_that_a_nested_automaton_raises_are_seen(name: str) -> None:
    inner = automaton("inner", flag("x", name))
    outer = automaton("outer", nested("in", "inner"), features=(FeatureUse("f", FlagUp(name)),))
    assert not warnings_of(with_automata(inner, outer), "is never up")
