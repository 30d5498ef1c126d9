"""Edits of rules, of prunes, and of what was learned."""

from itertools import product

import pytest

from app.core import edits
from app.core.automaton import START, Automaton, Prune, Refit
from app.core.conditions import AtMost, Condition, Equals, Guard
from app.core.errors import EditError
from app.core.project import Project
from app.core.transition import distribution
from app.core.tree import Branch, Forest, Leaf, Tree
from tests.samples import AGENT, project, when

NEAR = Condition(AtMost("distance", 2.0))
FAR = Condition(AtMost("distance", 2.0), wanted=False)


def goto(changed: Project) -> Automaton:
    return changed.library(AGENT).get("goto")


def rule_ids(changed: Project, automaton_id: str) -> list[str]:
    return [rule.id for rule in changed.library(AGENT).get(automaton_id).rules]


def test_a_new_rule_is_tried_last_and_its_id_counts_up() -> None:
    changed, new = edits.add_rule(project(), AGENT, "wander", "left", "right", probability=0.5)
    assert new == "6"
    assert [rule.id for rule in changed.library(AGENT).get("wander").rules_of("left")] == ["4", "6"]
    changed = edits.remove_rule(changed, AGENT, "wander", "3")
    assert edits.add_rule(changed, AGENT, "wander", "left", "right")[1] == "7"


def test_a_rule_is_changed_in_its_place() -> None:
    changed = edits.replace_rule(project(), AGENT, "wander", "2", probability=0.2, target="right")
    rule = changed.library(AGENT).get("wander").rules[1]
    assert (rule.id, rule.source, rule.target, rule.probability) == ("2", "forward", "right", 0.2)
    assert edits.replace_rule(changed, AGENT, "wander", "2", probability=0.05, target="left") == project()


@pytest.mark.parametrize("probability", [-0.1, 1.5, float("nan")])
def test_a_probability_lies_between_0_and_1(probability: float) -> None:
    with pytest.raises(EditError, match="allowed: 0 to 1"):
        edits.add_rule(project(), AGENT, "wander", "left", "right", probability=probability)


def test_a_rule_leads_from_a_state_to_a_state() -> None:
    for source, target in (("left", "gone"), ("gone", "left")):
        with pytest.raises(EditError, match="wander has no state 'gone'; there are: 'start', 'forward'"):
            edits.add_rule(project(), AGENT, "wander", source, target)
    with pytest.raises(EditError, match="wander has no rule '9'; there are: '1', '2'"):
        edits.remove_rule(project(), AGENT, "wander", "9")


def test_the_rules_of_a_state_are_put_in_order_among_the_others() -> None:
    changed = edits.order_rules(project(), AGENT, "wander", "forward", ["3", "2"])
    assert rule_ids(changed, "wander") == ["1", "3", "2", "4", "5"]


@pytest.mark.parametrize("order", [["2"], ["2", "3", "3"], ["2", "4"]])
def test_an_order_names_each_rule_of_the_state_once(order: list[str]) -> None:
    with pytest.raises(EditError, match="the rules of state 'forward' of wander are 2, 3"):
        edits.order_rules(project(), AGENT, "wander", "forward", order)


def test_all_rules_of_a_state_are_removed_at_once() -> None:
    assert rule_ids(edits.remove_rules_of(project(), AGENT, "wander", "forward"), "wander") == ["1", "4", "5"]


# ---------------------------------------------------------------------------------------------- learned


def test_what_was_learned_is_put_in_with_its_fingerprint() -> None:
    changed = edits.set_learned(project(), AGENT, "wander", {"left": Refit("knn")}, "abc")
    wander = changed.library(AGENT).get("wander")
    assert (wander.learned, wander.learned_from) == ({"left": Refit("knn")}, "abc")
    with pytest.raises(EditError, match="wander has no state 'gone'"):
        edits.set_learned(project(), AGENT, "wander", {"gone": Refit("knn")}, "abc")


def test_prunes_are_added_changed_and_taken_back() -> None:
    changed, new = edits.add_prune(project(), AGENT, "goto", "forward", ["left"])
    assert goto(changed).prunes_of("forward") == (Prune("2", "forward", (), frozenset({"left"})),)
    changed = edits.replace_prune(changed, AGENT, "goto", new, forbidden=["left", "done"], guard=(NEAR,))
    assert goto(changed).prunes_of("forward") == (
        Prune("2", "forward", (NEAR,), frozenset({"left", "done"})),
    )
    assert edits.remove_prune(changed, AGENT, "goto", new) == project()


def test_a_prune_forbids_states_there_are() -> None:
    with pytest.raises(EditError, match="forbids nothing"):
        edits.add_prune(project(), AGENT, "goto", "forward", [])
    with pytest.raises(EditError, match="goto has no state 'gone'"):
        edits.add_prune(project(), AGENT, "goto", "forward", ["gone"])
    with pytest.raises(EditError, match="goto has no prune '7'; there are: '1'"):
        edits.remove_prune(project(), AGENT, "goto", "7")


def test_transitions_with_little_support_are_pruned_at_their_leaves_and_staying_never() -> None:
    changed = edits.prune_weak(project(), AGENT, "goto", 2)
    weak = [prune for prune in goto(changed).prunes if prune.id != "1"]
    assert {prune.source for prune in weak} == {START, "left"}  # in "forward", the one example says to stay
    assert all(prune.forbidden == {"forward"} and len(prune.guard) == 2 for prune in weak)
    assert edits.prune_weak(changed, AGENT, "goto", 2) == changed


# ------------------------------------------------------------------------------- rules from learned trees


def chances(
    automaton: Automaton, state: str, values: dict[str, float], *, learned: bool
) -> dict[str, object]:
    model = automaton.learned.get(state) if learned else None
    assert model is None or isinstance(model, Tree)
    outcome = distribution(automaton, state, model, values.__getitem__)
    total: dict[str, float] = {}
    for target, p in zip(outcome.states, outcome.probabilities, strict=True):
        total[target] = total.get(target, 0.0) + p
    return {target: pytest.approx(p) for target, p in sorted(total.items()) if p > 1e-12}


GUARDS: list[Guard] = [
    (),
    (NEAR,),
    (FAR,),
    when(AtMost("distance", 5.0)),
    (FAR, Condition(AtMost("distance", 5.0))),
    (Condition(Equals("direction", 0.0)),),
]


@pytest.mark.parametrize(("first", "second"), list(product(range(len(GUARDS)), repeat=2)))
def test_rules_made_from_a_tree_do_what_tree_and_prunes_do(first: int, second: int) -> None:
    changed, _ = edits.add_prune(project(), AGENT, "goto", "left", ["forward"], GUARDS[first])
    changed, _ = edits.add_prune(changed, AGENT, "goto", "left", ["left", "done"], GUARDS[second])
    authored = edits.author_learned(changed, AGENT, "goto", "left")
    for distance, direction in product((1.0, 3.0, 10.0, 100.0), (0.0, 0.4, 3.0)):
        values = {"distance": distance, "direction": direction}
        assert chances(goto(authored), "left", values, learned=False) == chances(
            goto(changed), "left", values, learned=True
        )


def test_a_leaf_without_data_becomes_a_rule_to_stay() -> None:
    tree = Tree(("left",), Branch(AtMost("distance", 2.0), Leaf((0.0,)), Leaf((1.0,)), (1.0,)))
    changed = edits.set_learned(project(), AGENT, "goto", {"forward": tree}, "")
    rules = goto(edits.author_learned(changed, AGENT, "goto", "forward")).rules
    assert [(rule.guard, rule.target, rule.probability) for rule in rules] == [
        ((NEAR,), "forward", 1.0),
        ((FAR,), "left", 1.0),
    ]


def test_rules_made_from_a_tree_can_be_turned_back() -> None:
    authored = edits.author_learned(project(), AGENT, "goto", "left")
    assert goto(authored).learned == goto(project()).learned
    assert edits.remove_rules_of(authored, AGENT, "goto", "left") == project()


def test_only_a_tree_can_be_turned_into_rules() -> None:
    with pytest.raises(EditError, match="has learned nothing; only a tree"):
        edits.author_learned(project(), AGENT, "wander", "left")
    forest = Forest(("left",), (Tree(("left",), Leaf((1.0,))),))
    changed = edits.set_learned(project(), AGENT, "wander", {"left": forest}, "")
    with pytest.raises(EditError, match="has learned a forest"):
        edits.author_learned(changed, AGENT, "wander", "left")
