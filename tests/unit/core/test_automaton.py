from typing import Any

import pytest

from app.core.automaton import START, Automaton, Prune, Refit, Rule, predicted, reachable, trimmed
from app.core.conditions import AtMost
from app.core.features import Ground
from app.core.tree import Branch, Forest, Leaf, Tree
from tests.fakes import DONE_UP, SEES, leaf, rules, yes
from tests.samples import automaton, flag, forage, nested, state

A, B, C, D = (state(name, "Forward") for name in "abcd")


def entered(*listed: Any, **fields: Any) -> str:
    """The states that can be entered, besides Start."""
    found = reachable(automaton("x", A, B, C, D, rules=rules(*listed), **fields))
    assert START in found
    return "".join(sorted(found - {START}))


def test_start_is_always_reachable() -> None:
    assert entered() == ""
    assert entered(("a", (), "b")) == ""


def test_states_are_reached_through_rules_and_models_from_start_on() -> None:
    assert entered((START, yes("x"), "a"), ("a", yes("x"), "b"), ("c", (), "d")) == "ab"
    assert entered((START, (), "a"), learned={"a": leaf(b=1.0), "b": leaf(c=1.0)}) == "abc"


def test_a_rule_that_never_fires_leads_nowhere() -> None:
    assert entered((START, (), "a", 0.0)) == ""


def test_nothing_falls_through_a_rule_that_always_fires() -> None:
    assert entered((START, (), "a"), (START, (), "b"), learned={START: leaf(c=1.0)}) == "a"
    assert entered((START, (), "a", 0.9), (START, (), "b"), learned={START: leaf(c=1.0)}) == "ab"
    assert entered((START, yes("x"), "a"), learned={START: leaf(c=1.0)}) == "ac"


def test_a_label_that_no_leaf_predicts_is_not_entered() -> None:
    tree = Tree(
        ("a", "b", "c"),
        Branch(AtMost("d", 1.0), Leaf((1.0, 0.0, 0.0)), Leaf((0.0, 2.0, 0.0)), (1.0, 2.0, 0.0)),
    )
    assert predicted(tree) == {"a", "b"}
    assert predicted(Forest(("a", "b", "c"), (tree, Tree(("a", "b", "c"), Leaf((0.0, 0.0, 1.0)))))) == {
        "a",
        "b",
        "c",
    }
    assert entered(learned={START: tree}) == "ab"


def test_a_label_that_a_prune_forbids_everywhere_is_not_entered() -> None:
    model = leaf(a=1.0, b=1.0)
    everywhere = Prune("p", START, (), frozenset({"a"}))
    somewhere = Prune("p", START, yes("x"), frozenset({"a"}))
    elsewhere = Prune("p", "c", (), frozenset({"a"}))
    assert entered(learned={START: model}, prunes=(everywhere,)) == "b"
    assert entered(learned={START: model}, prunes=(somewhere,)) == "ab"
    assert entered(learned={START: model}, prunes=(elsewhere,)) == "ab"


def test_a_model_without_a_table_may_predict_any_state() -> None:
    assert entered(learned={START: Refit("knn")}) == "abcd"


def test_trimming_keeps_what_runs_and_drops_the_rest() -> None:
    whole = automaton(
        "x",
        A,
        B,
        C,
        features=(SEES,),
        rules=rules((START, (), "b", 0.5), ("b", (), START), ("a", (), "b"), ("b", (), "a", 0.0)),
        learned={"b": leaf(b=1.0), "a": leaf(c=1.0)},
        prunes=(Prune("p", "a", (), frozenset({"b"})), Prune("q", "b", (), frozenset({"c"}))),
        note="mine",
        learned_from="those",
    )
    left = trimmed(whole)
    assert [s.id for s in left.states] == [START, "b"]
    # A choice that is held compares which rules were met, those of probability 0 as well.
    assert left.rules == (
        Rule("r1", START, (), "b", 0.5),
        Rule("r2", "b", (), START),
        Rule("r4", "b", (), "b", 0.0),
    )
    assert (set(left.learned), [prune.id for prune in left.prunes]) == ({"b"}, ["q"])
    assert (left.features, left.note, left.learned_from) == ((SEES,), "mine", "those")


def test_trimming_what_is_all_used_changes_nothing() -> None:
    assert trimmed(forage()) == forage()
    assert trimmed(trimmed(forage())) == trimmed(forage())


def test_parts_are_found_by_id() -> None:
    x = automaton(
        "x", A, features=(SEES, DONE_UP), rules=rules((START, (), "a"), ("a", (), START), (START, (), START))
    )
    assert x.state("a") == A
    assert x.has_state("a")
    assert not x.has_state("z")
    assert x.feature("done") == DONE_UP
    assert [rule.id for rule in x.rules_of(START)] == ["r1", "r3"]
    with pytest.raises(KeyError):
        x.state("z")
    with pytest.raises(KeyError):
        x.feature("z")


def test_what_it_holds_is_listed_once_in_order() -> None:
    x = automaton(
        "x",
        nested("1", "goto", {"target": Ground("deposit")}),
        A,
        nested("2", "walk"),
        nested("3", "goto"),
        flag("4"),
    )
    assert x.nested() == ("goto", "walk")
    assert Automaton("x", "x").nested() == ()
