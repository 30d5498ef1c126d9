"""What is wrong with transitions: rules, learned models, prunes, and what can be reached."""

from dataclasses import replace
from math import inf, nan, pi

import pytest

from app.core.automaton import START, Automaton, Model, Prune, Refit, Rule
from app.core.check import Problem, check
from app.core.conditions import AtMost, Equals, InArc, Test
from app.core.examples import Example
from app.core.features import FeatureUse, Ground, Operation, Sense, Statistic
from app.core.library import Library
from app.core.project import Project
from app.core.tree import Branch, Forest, Leaf, Tree
from tests.samples import AGENT, GROUP, automaton, flag, project, state, vocabulary, when

TO_BOX = {"target": Ground("nearest-box")}
USES = (
    FeatureUse("far", Sense("DistanceTo", TO_BOX)),
    FeatureUse("way", Sense("DirectionTo", TO_BOX)),
    FeatureUse("sees", Sense("SeesABox")),
    FeatureUse("ground", Sense("Ground")),
)
WALK = Rule("1", START, (), "walk")


def walker(*rules: Rule, **fields: object) -> Automaton:
    """Two states that are entered from Start and left again, with further rules."""
    given = {
        "rules": (WALK, Rule("2", "walk", (), "turn", 0.1), Rule("3", "turn", (), "walk", 0.1), *rules),
        **fields,
    }
    return automaton("a", state("walk", "Forward"), state("turn", "RotateLeft"), features=USES, **given)


def of(changed: Automaton, type_name: str = AGENT, examples: tuple[Example, ...] = ()) -> list[Problem]:
    """The problems of the sample with this automaton added."""
    library = Library({**project().library(type_name).automata, changed.id: changed})
    taught = {type_name: {changed.id: examples}} if examples else {}
    there: Project = replace(
        project(), libraries={**project().libraries, type_name: library}, examples=taught
    )
    return [problem for problem in check(there, vocabulary()) if problem.file.endswith("/a.json")]


def mended(changed: Automaton, problem: Problem) -> list[Problem]:
    assert problem.mend is not None
    library = Library({**project().library(AGENT).automata, changed.id: changed})
    there = replace(project(), libraries={**project().libraries, AGENT: library})
    return [p for p in check(problem.mend(there), vocabulary()) if p.file.endswith("/a.json")]


def only(changed: Automaton) -> Problem:
    found = of(changed)
    assert len(found) == 1, [str(problem) for problem in found]
    return found[0]


def test_the_walker_is_without_problems() -> None:
    assert of(walker()) == []


# --------------------------------------------------------------------------------------------- rules


@pytest.mark.parametrize(
    ("source", "target", "where", "verb"),
    [("gone", "walk", "source", "leaves"), ("walk", "gone", "target", "leads to")],
)
def test_a_rule_leads_from_a_state_to_a_state(source: str, target: str, where: str, verb: str) -> None:
    broken = walker(Rule("9", source, when(Equals("sees", 1.0)), target))
    problem = only(broken)
    assert problem.where == f"rules[3].{where}"
    assert (
        f"rule '9' of a {verb} state 'gone', which does not exist; there are: 'start', 'turn', 'walk'"
        in problem.message
    )
    assert (problem.severity, problem.fix) == ("error", "remove the rule")
    assert mended(broken, problem) == []


@pytest.mark.parametrize("probability", [-0.5, 1.01, nan])
def test_a_probability_lies_between_0_and_1(probability: float) -> None:
    problem = only(walker(Rule("9", "turn", when(Equals("sees", 1.0)), "walk", probability)))
    assert problem.where == "rules[3].probability"
    assert "allowed: 0 to 1" in problem.message


@pytest.mark.parametrize(
    ("test", "message"),
    [
        (Equals("seen", 1.0), "tests feature 'seen', which the automaton lacks; did you mean 'sees'?"),
        (
            AtMost("sees", 0.5),
            "tests 'sees', which is boolean and must be true or false, but is compared with a threshold",
        ),
        (AtMost("way", 0.5), "tests 'way', which is toroidal and must be compared with an arc"),
        (Equals("far", 0.5), "tests 'far', which is continuous and must be compared with a threshold"),
        (
            InArc("ground", 0.0, 1.0),
            "tests 'ground', which is categorical and must be compared with one of its categories",
        ),
        (Equals("ground", 3.0), "tests 'ground', which is never 3; allowed: 0 (grass), 1 (sand), 2 (rock)"),
        (Equals("ground", 0.5), "tests 'ground', which is never 0.5"),
        (Equals("sees", 2.0), "tests 'sees', which is never 2; allowed: 0 (false), 1 (true)"),
        (InArc("way", -4.0, 1.0), "tests 'way', whose arc reaches -4; allowed: -pi to pi"),
        (InArc("way", 0.0, nan), "tests 'way', whose arc reaches nan"),
        (AtMost("far", inf), "tests 'far', whose threshold is inf; it must be a finite number"),
    ],
)
def test_a_test_fits_its_feature(test: Test, message: str) -> None:
    in_rule = only(walker(Rule("9", "turn", when(Equals("sees", 1.0), test), "walk")))
    assert message in in_rule.message
    assert in_rule.where == "rules[3].guard[1]"
    in_prune = only(walker(prunes=(Prune("1", "turn", when(test), frozenset({"walk"})),)))
    assert message in in_prune.message
    assert in_prune.where == "prunes[0].guard[0]"
    leaf = Leaf((1.0,))
    in_tree = only(walker(learned={"turn": Tree(("walk",), Branch(test, leaf, leaf, (2.0,)))}))
    assert message in in_tree.message
    assert in_tree.where == "learned.turn"


def test_an_arc_may_reach_the_seam() -> None:
    assert of(walker(Rule("9", "turn", when(InArc("way", -pi, pi)), "walk"))) == []


def test_statistics_are_tested_as_what_they_give() -> None:
    lead = automaton(
        "a",
        state("search", "forage"),
        features=(
            FeatureUse("any", Statistic(Operation.ANY, Sense("SeesABox"))),
            FeatureUse("count", Statistic(Operation.COUNT, Sense("SeesABox"))),
        ),
        rules=(
            Rule("1", START, when(Equals("any", 1.0), AtMost("count", 3.0)), "search"),
            Rule("2", "search", when(AtMost("any", 0.5)), START),
            Rule("3", "search", when(Equals("count", 3.0)), START),
        ),
    )
    assert [problem.where for problem in of(lead, GROUP)] == ["rules[1].guard[0]", "rules[2].guard[0]"]


def test_rules_from_and_to_start_are_allowed() -> None:
    assert of(walker(Rule("9", "turn", (), START, 0.1))) == []


def test_a_rule_of_a_state_that_raises_a_flag_is_never_used() -> None:
    raiser = automaton(
        "a",
        flag("done"),
        state("release", "ReleaseBox"),
        rules=(
            Rule("1", START, (), "done", 0.5),
            Rule("2", START, (), "release"),
            Rule("3", "done", (), "release"),
            Rule("4", "release", (), "done"),
        ),
    )
    found = of(raiser)
    assert [(p.where, p.severity) for p in found] == [("rules[2]", "warning"), ("rules[3]", "warning")]
    assert (
        "rule '3' of a is never used: state 'done' raises a flag, so it is left for Start at once"
        in found[0].message
    )


def test_a_rule_that_others_always_come_before_is_never_used() -> None:
    problem = only(walker(Rule("9", START, (), "turn")))
    assert "rule '9' of a is never used: rule '1' before it always leaves state 'start'" in problem.message
    assert "its probability is 0" in only(walker(Rule("9", "turn", (), "walk", 0.0))).message


# -------------------------------------------------------------------------------------------- prunes


def test_a_prune_names_states_there_are() -> None:
    broken = walker(prunes=(Prune("1", "turn", (), frozenset({"walk", "gone"})),))
    problem = only(broken)
    assert problem.where == "prunes[0].forbidden"
    assert "prune '1' of a names state 'gone', which does not exist" in problem.message
    assert mended(broken, problem) == []
    assert only(walker(prunes=(Prune("1", "gone", (), frozenset({"walk"})),))).where == "prunes[0].source"


# -------------------------------------------------------------------------------------------- models


@pytest.mark.parametrize(
    ("model", "message"),
    [
        (Tree(("gone",), Leaf((1.0,))), "leads to state 'gone', which does not exist"),
        (Tree(("walk", "turn"), Leaf((1.0,))), "has 1 counts at a node, but 2 labels"),
        (Forest(("walk",), ()), "is a forest without trees"),
        (Forest(("gone",), (Tree(("gone",), Leaf((1.0,))),)), "leads to state 'gone'"),
    ],
)
def test_a_learned_model_fits_its_automaton(model: Model, message: str) -> None:
    broken = walker(learned={"turn": model})
    problem = only(broken)
    assert f"what a learned for state 'turn' {message}" in problem.message
    assert problem.fix == "forget it and learn again"
    assert mended(broken, problem) == []


def test_a_learned_model_belongs_to_a_state() -> None:
    broken = walker(learned={"gone": Refit("knn"), "turn": Refit("knn")})
    assert "belongs to no state" in only(broken).message
    assert mended(broken, only(broken)) == []


def test_a_model_of_a_state_that_raises_a_flag_is_never_used() -> None:
    raiser = automaton(
        "a",
        flag("done"),
        learned={START: Tree(("done",), Leaf((1.0,))), "done": Tree(("done",), Leaf((1.0,)))},
    )
    problem = only(raiser)
    assert (problem.severity, problem.where) == ("warning", "learned.done")


# --------------------------------------------------------------------------------------------- reach


def test_an_automaton_that_has_nothing_to_go_by_never_leaves_start() -> None:
    assert "a never leaves Start: it has no rules, and nothing to learn from" in only(automaton("a")).message
    example = Example("1", START, "walk", {})
    bare = automaton("a", state("walk", "Forward"))
    assert of(bare, examples=(example,)) == []
    assert "never leaves Start" in of(bare, examples=(replace(example, enabled=False),))[0].message


def test_start_without_a_way_out_is_pointed_out() -> None:
    stuck = walker(rules=(Rule("2", "walk", (), "turn"), Rule("3", "turn", (), "walk")))
    found = [problem.message for problem in of(stuck)]
    assert "a never leaves Start: no transition leads out of it" in found
    assert "state walk of a is never entered: no transition leads to it" in found


def test_a_state_that_is_never_entered_is_pointed_out() -> None:
    problem = only(walker(rules=(Rule("1", START, (), "walk"), Rule("2", "walk", (), START, 0.1))))
    assert (problem.severity, problem.where) == ("warning", "states[2]")
    assert "state turn of a is never entered" in problem.message


def test_a_state_that_is_never_left_is_pointed_out_unless_it_raises_a_flag() -> None:
    problem = only(walker(rules=(WALK, Rule("2", "walk", (), "turn", 0.1))))
    assert "state turn of a is never left: it has neither rules nor data" in problem.message
    raiser = automaton("a", flag("done"), rules=(Rule("1", START, (), "done"),))
    assert of(raiser) == []


def test_states_with_data_not_learned_yet_are_not_pointed_out() -> None:
    taught = walker(rules=(WALK,))
    values = {"far": 1.0, "way": 0.0, "sees": 0.0, "ground": 0.0}
    examples = (Example("1", "walk", "turn", values), Example("2", "turn", "turn", values, continuation=True))
    assert of(taught, examples=examples) == []


def test_what_was_learned_counts_as_a_way() -> None:
    tree = Tree(("walk", "turn"), Leaf((1.0, 1.0)))
    assert of(walker(rules=(WALK,), learned={"walk": tree, "turn": tree})) == []
    pruned = (Prune("1", "walk", (), frozenset({"turn"})),)
    found = of(walker(rules=(WALK,), learned={"walk": tree, "turn": tree}, prunes=pruned))
    assert "state turn of a is never entered: no transition leads to it" in [
        problem.message for problem in found
    ]
