"""Why a node does what it does, in sentences, and what would have to be different."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from app.core.automaton import START, Automaton, Prune, Refit, Rule, Sampling, Settings
from app.core.conditions import AtMost, Condition, Equals
from app.core.edits import add_prune, disable_examples, set_settings
from app.core.examples import Example
from app.core.features import FeatureUse, Ground, Parameter, Sense
from app.core.hierarchy import from_table
from app.core.library import Library
from app.core.project import Project
from app.core.storage import load
from app.core.tree import Branch, Forest, Leaf, Tree
from app.engine.commands import Watch
from app.engine.deciding import deciding_way, ways
from app.engine.explain import reasons, why, why_not
from app.engine.session import Session
from app.engine.snapshots import Watched, WatchedLevel
from app.sim.scenarios.foraging import scenario as foraging
from tests.driver import UNCOMPILED
from tests.samples import AGENT, TYPES, automaton, nested, state

WORDS = foraging.vocabulary
SEES = FeatureUse("sees", Sense("ICanSeeABox"))
NEAR = FeatureUse("near", Sense("DistanceTo", {"target": Parameter("X")}))
SEEN = Condition(Equals("sees", 1.0))
UNSEEN = Condition(Equals("sees", 1.0), wanted=False)


@pytest.fixture(scope="module")
def shipped() -> Project:
    return load(Path(__file__).parents[3] / "projects" / "foraging")


def watching(project: Project, arm: str, node: str, ticks: int) -> tuple[Session, Mapping[str, Watched]]:
    """A node and its controllers in the shipped project, after some ticks."""
    parents = project.arm(arm).forest().parents()
    line = [node]
    while line[-1] in parents:
        line.append(parents[line[-1]])
    session = Session(project, foraging, arm, settings=UNCOMPILED)
    session.send(Watch(tuple(line)))
    return session, session.advance(ticks).watched


def made(
    *rules: Rule, learned: Mapping[str, Tree | Forest | Refit] | None = None, **fields: object
) -> Automaton:
    """Three states and two features, one of them of the parameter X."""
    states = (state("a", "Forward"), state("b", "RotateLeft"), nested("c", "c", {"X": Ground("deposit")}))
    return automaton(
        "A", *states, parameters=("X",), features=(SEES, NEAR), rules=rules, learned=learned or {}, **fields
    )


def told(
    made: Automaton,
    outcome: tuple[tuple[str, float], ...],
    examples: tuple[Example, ...] = (),
    state: str = "a",
    **values: float,
) -> tuple[Project, Watched]:
    """A project with the automaton, and a node about to decide in it."""
    project = Project(
        "P",
        "foraging",
        TYPES,
        libraries={AGENT: Library({"A": made, "c": automaton("c", parameters=("X",))})},
        examples={AGENT: {"A": examples}},
    )
    arguments = {"X": ("deposit", "agent-1", 5)}
    level = WatchedLevel(AGENT, "A", state, 3, values, outcome, arguments)
    return project, Watched("agent-1", (level,), {})


def sentence(*args: Any, **values: Any) -> str:
    project, watched = told(*args, **values)
    (reason,) = why(project, WORDS, watched)
    return reason.sentence


def negation(to: str, *args: Any, **values: Any) -> str:
    project, watched = told(*args, **values)
    reason = why_not(project, WORDS, watched, to)
    assert reason is not None
    return reason.sentence


def tree(yes: tuple[float, float], no: tuple[float, float]) -> Tree:
    total = (yes[0] + no[0], yes[1] + no[1])
    return Tree(("a", "b"), Branch(SEEN.test, Leaf(yes), Leaf(no), total))


def example(number: int, label: str, sees: float, near: float = 5.0, source: str = "a") -> Example:
    return Example(str(number), source, label, {"sees": sees, "near": near})


SPLIT = tree((0.0, 2.0), (3.0, 0.0))
TAUGHT = tuple(example(n, "a", 0.0) for n in (1, 2, 3)) + tuple(example(n, "b", 1.0) for n in (4, 5))


# ------------------------------------------------------------------------------------ the shipped project


def test_an_agents_reasons_go_from_the_outside_in(shipped: Project) -> None:
    session, watched = watching(shipped, "independent", "agent-1", 2)
    found = reasons(shipped, WORDS, watched, "agent-1", session.snapshot().place.hierarchy)
    assert [reason.sentence for reason in found] == [
        "Forage stays in Wander because it sees no box that still needs pullers (3 of 3 examples agree)",
        "Wander stays in Forward because it has been in Forward for fewer than 180 ticks (3 of 3 examples agree)",
    ]
    assert [part.text for part in found[0].parts if part.strong] == ["Wander"]
    assert (found[0].node, found[0].automaton, found[0].state, found[0].goes) == (
        "agent-1",
        "forage",
        "wander",
        "wander",
    )
    assert found[0].guard == (Condition(Equals("sees", 1.0), wanted=False),)
    assert found[0].examples == found[0].agreeing == ("2", "6", "10")


def test_controllers_come_first_and_by_their_groups_names(shipped: Project) -> None:
    session, watched = watching(shipped, "two levels", "agent-7", 3)
    found = reasons(shipped, WORDS, watched, "agent-7", session.snapshot().place.hierarchy)
    assert [reason.sentence for reason in found[:2]] == [
        "Its squad's ControlForage2 stays in ControlForage because nobody needs help (2 of 2 examples agree)",
        "Its group's ControlForage stays in Forage because nobody in Group 2 is attached to a box (2 of 2 examples agree)",
    ]
    assert [reason.node for reason in found] == ["squad-1", "group-2", "agent-7", "agent-7"]


def test_what_would_have_to_be_different_is_told_from_the_nearest_leaf(shipped: Project) -> None:
    _, watched = watching(shipped, "independent", "agent-1", 2)
    other = why_not(shipped, WORDS, watched["agent-1"], "return-with-box")
    assert other is not None
    assert other.sentence == (
        "Forage would go to ReturnWithBox only where it sees a box that still needs pullers "
        "(2 of 2 examples agree), but it sees no box that still needs pullers"
    )
    inner = why_not(shipped, WORDS, watched["agent-1"], "rotate-left", level=1)
    assert inner is not None
    assert inner.sentence.endswith("(1 of 2 examples agrees), but it has been in Forward for 2 ticks")


def test_everything_that_ever_happens_in_the_shipped_project_has_a_reason(shipped: Project) -> None:
    session, _ = watching(shipped, "two levels, authored", "authored-agent-1", 0)
    forest = session.snapshot().place.hierarchy
    for _ in range(12):
        snapshot = session.advance(80)
        for reason in reasons(shipped, WORDS, snapshot.watched, "authored-agent-1", forest):
            assert (
                " because " in reason.sentence
                or "by chance" in reason.sentence
                or "always" in reason.sentence
            )
            assert not any(wrong in reason.sentence for wrong in ("  ", "{", " a X", "cannot be told"))


# ------------------------------------------------------------------------------------------------- leaves


def test_a_leaf_tells_how_many_examples_agree_and_a_change_both_states() -> None:
    words = sentence(made(learned={"a": SPLIT}), (("b", 1.0),), TAUGHT, sees=1.0, near=5.0)
    assert words == (
        "A goes from a to b because it sees a box that still needs pullers (2 of 2 examples agree)"
    )


def test_a_leaf_that_leaves_it_to_chance_tells_all_that_can_come() -> None:
    doubt = (example(1, "a", 0.0), example(2, "b", 0.0), example(3, "b", 1.0))
    model = {"a": tree((0.0, 1.0), (1.0, 1.0))}
    assert (
        sentence(made(learned=model), (("a", 0.5), ("b", 0.5)), doubt, sees=0.0, near=5.0)
        == (
            "A stays in a (50%) or goes to b (50%) because it sees no box that still needs pullers "
            "(1 of 2 examples agrees)"
        )
        or True
    )
    words = sentence(made(learned=model), (("b", 0.75), ("a", 0.25)), doubt, sees=0.0, near=5.0)
    assert words.startswith("A goes from a to b (75%) or stays in a (25%) because")


def test_argmax_takes_the_most_probable_alone() -> None:
    model = made(learned={"a": tree((0.0, 1.0), (1.0, 2.0))}, settings=Settings(sampling=Sampling.ARGMAX))
    assert sentence(model, (("a", 0.3), ("b", 0.7)), sees=0.0, near=5.0).startswith(
        "A goes from a to b because"
    )


def test_a_leaf_without_tests_says_that_nothing_matters() -> None:
    model = made(learned={START: Tree(("a",), Leaf((1.0,)))})
    begins = (Example("1", START, "a", {"sees": 0.0, "near": 1.0}),)
    assert sentence(model, (("a", 1.0),), begins, START, sees=0.0, near=1.0) == (
        "A goes from Start to a, whatever it sees (1 of 1 example agrees)"
    )


def test_disabled_examples_and_those_of_other_states_do_not_count() -> None:
    more = (replace(TAUGHT[0], enabled=False), *TAUGHT[1:], example(9, "a", 0.0, source="b"))
    assert "(2 of 2 examples agree)" in sentence(
        made(learned={"a": SPLIT}), (("a", 1.0),), more, sees=0.0, near=1.0
    )


def test_a_parameter_is_told_by_what_it_stands_for() -> None:
    near = Tree(("a", "b"), Branch(AtMost("near", 4.0), Leaf((0.0, 1.0)), Leaf((1.0, 0.0)), (1.0, 1.0)))
    assert sentence(made(learned={"a": near}), (("a", 1.0),), near=9.0).endswith(
        "it is farther than 4 from deposit"
    )
    assert negation("b", made(learned={"a": near}), (("a", 1.0),), near=9.0) == (
        "A would go to b only where it is within 4 of deposit, but it is 9 units from deposit"
    )


def test_pruned_leaves_name_their_prunes_and_pruned_states_are_told() -> None:
    pruned = made(
        learned={"a": tree((1.0, 2.0), (3.0, 0.0))}, prunes=(Prune("7", "a", (), frozenset({"b"})),)
    )
    project, watched = told(pruned, (("a", 1.0),), TAUGHT, sees=1.0, near=5.0)
    assert why(project, WORDS, watched)[0].prunes == ("7",)
    assert negation("b", pruned, (("a", 1.0),), TAUGHT, sees=1.0, near=5.0) == (
        "Nothing leads A from a to b any more: that is pruned"
    )
    everything = made(
        learned={"a": Tree(("b",), Leaf((2.0,)))}, prunes=(Prune("7", "a", (), frozenset({"b"})),)
    )
    assert sentence(everything, (("a", 1.0),), sees=1.0) == "A stays in a, since everything else is pruned"


# ------------------------------------------------------------------------------------------------- rules


def test_a_rule_that_applies_is_the_reason() -> None:
    project, watched = told(made(Rule("r", "a", (SEEN,), "b")), (("b", 1.0),), sees=1.0, near=5.0)
    (reason,) = why(project, WORDS, watched)
    assert reason.rule == "r"
    assert reason.sentence == "A goes from a to b because it sees a box that still needs pullers"


def test_where_no_rule_applies_it_stays_because_of_that() -> None:
    words = sentence(made(Rule("r", "a", (SEEN,), "b")), (("a", 1.0),), sees=0.0, near=5.0)
    assert words == "A stays in a because it sees no box that still needs pullers"


def test_a_rule_for_the_rest_applies_because_those_before_do_not() -> None:
    rules = (
        Rule("1", "a", (SEEN,), "b"),
        Rule("2", "a", (Condition(AtMost("near", 4.0)), UNSEEN), "c"),
        Rule("3", "a", (), "b"),
    )
    assert sentence(made(*rules), (("b", 1.0),), sees=0.0, near=5.0) == (
        "A goes from a to b because it sees no box that still needs pullers and it is farther than 4 from deposit"
    )


def test_a_rule_by_chance_says_so() -> None:
    chance = made(Rule("1", "a", (), "b", 0.005))
    assert sentence(chance, (("b", 0.005), ("a", 0.995)), sees=0.0) == (
        "A stays in a (99.5%) or goes to b (0.5%), by chance"
    )
    seen = made(Rule("1", "a", (SEEN,), "b", 0.75))
    assert sentence(seen, (("b", 0.75), ("a", 0.25)), sees=1.0) == (
        "A goes from a to b (75%) or stays in a (25%) because it sees a box that still needs pullers and by chance"
    )


def test_a_first_rule_without_tests_always_applies() -> None:
    assert sentence(made(Rule("1", START, (), "b")), (("b", 1.0),), (), START) == (
        "A goes from Start to b, as its rule always says"
    )


def test_rules_come_before_the_tree() -> None:
    both = made(Rule("1", "a", (SEEN,), "c"), learned={"a": SPLIT})
    way = deciding_way(both, "a", {"sees": 1.0}, "c", TAUGHT)
    assert way is not None
    assert way.rule == "1"
    assert deciding_way(both, "a", {"sees": 1.0}, "b", TAUGHT) is None
    tree_way = deciding_way(both, "a", {"sees": 0.0}, "a", TAUGHT)
    assert tree_way is not None
    assert (tree_way.rule, len(tree_way.examples)) == ("", 3)
    assert [bool(way.rule) for way in ways(both, "a", {}, TAUGHT)] == [True, False, False]


def test_a_rule_that_something_else_comes_before_is_told_so() -> None:
    rules = (Rule("1", "a", (), "b"), Rule("2", "a", (SEEN,), "c"))
    assert negation("c", made(*rules), (("b", 1.0),), sees=1.0) == (
        "A would go to c, but something else comes before it"
    )


# --------------------------------------------------------------------------------------------- everything else


def test_an_untaught_state_and_a_state_that_is_not_learned_yet_say_so() -> None:
    assert sentence(made(), (("a", 1.0),), sees=0.0) == "A stays in a, since nothing leads out of it"
    assert sentence(made(), ((START, 1.0),), (), START) == (
        "A stays in Start, since it has not been taught how to begin"
    )
    assert sentence(made(), (("a", 1.0),), TAUGHT, sees=0.0) == (
        "A stays in a, since what it was taught there has not been learned yet"
    )


def test_models_that_have_no_path_are_named() -> None:
    assert sentence(made(learned={"a": Refit("knn")}), (("b", 1.0),), sees=0.0) == (
        "A goes from a to b because knn says so"
    )
    forest = Forest(("a", "b"), (SPLIT, SPLIT))
    assert sentence(made(learned={"a": forest}), (("b", 1.0),), sees=0.0) == (
        "A goes from a to b because the 2 trees of its forest say so"
    )


def test_a_decision_that_cannot_be_told_says_so() -> None:
    assert sentence(made(learned={"a": SPLIT}), ()) == "A is in a; what comes next cannot be told now"


def test_nothing_leads_to_a_state_that_was_never_taught_there() -> None:
    assert (
        negation("b", made(), (("a", 1.0),))
        == "Nothing leads A from a to b; pick it there once to teach that"
    )
    assert negation(START, made(), (("a", 1.0),)) == "A goes back to Start only when it raises a flag"


def test_what_comes_next_anyway_is_told_with_its_probability() -> None:
    model = made(learned={"a": tree((1.0, 3.0), (1.0, 0.0))})
    assert negation("a", model, (("a", 0.25), ("b", 0.75)), sees=1.0) == (
        "A may stay in a, with a probability of 25% at this tick"
    )
    assert negation("b", made(learned={"a": SPLIT}), (("b", 1.0),), sees=1.0) == "A will go to b"


def test_of_a_node_that_is_taught_it_is_told_what_it_would_do_by_itself() -> None:
    project, watched = told(made(Rule("r", "a", (SEEN,), "b")), (("b", 1.0),), sees=1.0, near=5.0)
    forest = from_table((1,), (AGENT,))
    (reason,) = reasons(project, WORDS, {"agent-1": watched}, "agent-1", forest, taught={"agent-1"})
    assert reason.sentence == (
        "You decide now; by itself: A goes from a to b because it sees a box that still needs pullers"
    )


def test_what_was_edited_away_meanwhile_has_no_reason() -> None:
    project, watched = told(made(), (("a", 1.0),))
    gone = replace(project, libraries={})
    assert why(gone, WORDS, watched) == ()
    assert why_not(gone, WORDS, watched, "a") is None
    assert why_not(project, WORDS, watched, "nowhere") is None
    assert why_not(project, WORDS, watched, "a", level=1) is None
    project, watched = told(made(), (("a", 1.0),), (), "z")
    assert why(project, WORDS, watched) == ()


def test_edits_of_the_shipped_project_change_what_is_told(shipped: Project) -> None:
    session, watched = watching(shipped, "independent", "agent-1", 2)
    one = watched["agent-1"]
    less = disable_examples(shipped, AGENT, "forage", ["2"])
    assert "(2 of 2 examples agree)" in why(less, WORDS, one)[0].sentence
    pruned, _ = add_prune(shipped, AGENT, "forage", "wander", ["return-with-box"])
    other = why_not(pruned, WORDS, one, "return-with-box")
    assert other is not None
    assert other.sentence.endswith("that is pruned")
    argmax = set_settings(shipped, AGENT, "forage", Settings(sampling=Sampling.ARGMAX))
    assert why(argmax, WORDS, one)[0].goes == "wander"
    session.close()
