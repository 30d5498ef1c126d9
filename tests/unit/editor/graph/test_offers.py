"""Forms offer what exists, and nothing else; problems are shown where they are."""

from dataclasses import replace

from app.core.automaton import START, Nested, Rule, State
from app.core.check.scope import Scope, scopes
from app.core.conditions import AtMost, Equals, InArc
from app.core.edits import author_learned
from app.core.features import FlagUp, Ground, Operation, Parameter, Sense, Statistic, TicksInState
from app.core.library import Library
from app.editor.graph.labels import label_of, tip_of
from app.editor.graph.offers import automata, bindings, first_test, flags, sources
from app.editor.graph.problems import problems_of, spots
from tests.graphs import graph_of
from tests.samples import AGENT, GROUP, control, fetch, forage, goto, project, vocabulary, wander


def scope(type_name: str) -> Scope:
    made = project()
    return scopes(made.types_with(vocabulary()), vocabulary())[type_name]


def test_a_state_can_hold_any_automaton_that_does_not_hold_its_own() -> None:
    assert [name for name, _ in automata(scope(AGENT), "fetch")] == ["goto(target)", "wander"]
    assert [name for name, _ in automata(scope(AGENT), "forage")] == ["fetch", "goto(target)", "wander"]


def test_flags_of_agents_are_no_flags_to_raise() -> None:
    assert "finished" not in [name for name, _ in flags(scope(AGENT))]


def test_slots_can_be_bound_to_parameters_and_to_targets_of_the_level() -> None:
    offered = [value for _, value in bindings(scope(AGENT), goto())]
    assert offered == [Parameter("target"), Ground("nearest-box"), Ground("deposit")]
    assert Ground("closest-attached-agent") in [value for _, value in bindings(scope(GROUP), control())]


def test_what_can_be_tested_is_all_that_is_not_a_feature_yet() -> None:
    offered = [value for _, value in sources(scope(AGENT), goto())]
    assert Sense("DistanceTo", {"target": Ground("deposit")}) in offered
    assert Sense("DistanceTo", {"target": Parameter("target")}) not in offered
    assert {Sense("SeesABox").feature, "Ground"} <= {s.feature for s in offered if isinstance(s, Sense)}
    assert FlagUp("done") in offered
    assert TicksInState() in offered
    assert not any(isinstance(source, Statistic) for source in offered)


def test_controllers_can_test_what_is_summed_up_of_those_below() -> None:
    offered = [value for _, value in sources(scope(GROUP), control())]
    assert Statistic(Operation.ALL, Sense("IsAttached")) in offered
    assert Statistic(Operation.ANY, Sense("IsAttached")) not in offered  # it is a feature already


def test_every_kind_of_feature_begins_with_a_test_of_its_kind() -> None:
    kinds = {
        "DistanceTo": AtMost,
        "DirectionTo": InArc,
        "SeesABox": Equals,
        "Ground": Equals,
    }
    made = {name: first_test("f", Sense(name), vocabulary()).test for name in kinds}
    assert {name: type(test) for name, test in made.items()} == kinds


def test_a_problem_is_shown_at_its_state_or_its_edge() -> None:
    broken = replace(
        forage(),
        states=(*forage().states, State("lost", Nested("goto"), "lost")),
        rules=(*forage().rules, Rule("9", START, (), "fetch")),
    )
    found = spots(broken, problems_of(scope(AGENT), broken, ()))
    assert any("open" in problem.message for problem in found[("lost",)])
    assert any("never used" in problem.message for problem in found[START, "fetch"])


def test_an_edge_says_when_and_how_sure() -> None:
    graph = graph_of(goto(), Library({}), vocabulary())
    labels = {(edge.source, edge.target): label_of(edge) for edge in graph.edges}
    assert labels[START, "done"].how == "2 of 2 · p 1.0"
    assert labels[START, "forward"].when.endswith("or 1 more")
    assert labels[START, "forward"].how == "4 examples"
    rules = {(e.source, e.target): label_of(e) for e in graph_of(wander(), Library({}), vocabulary()).edges}
    assert rules["forward", "right"].how == "rule 2"
    assert rules["forward", "right"].when == "by chance, 5%"


def test_where_rules_decide_an_edge_does_not_count_what_was_learned_below_them() -> None:
    before = author_learned(project(), AGENT, "goto", START)
    graph = graph_of(before.library(AGENT).get("goto"), Library({}), vocabulary())
    for edge in graph.edges:
        if edge.source == START:
            rules = len(edge.rules)
            assert label_of(edge).when.endswith(f"or {rules - 1} more") == (rules > 1)


def test_a_tip_tells_every_way_with_its_numbers() -> None:
    graph = graph_of(fetch(), Library({}), vocabulary())
    edge = next(edge for edge in graph.edges if edge.source == "grab")
    tip = tip_of(edge, fetch(), ("grab", "home"))
    assert "<b>grab → home</b>" in tip
    assert "TicksInState &gt; 1.0" in tip
