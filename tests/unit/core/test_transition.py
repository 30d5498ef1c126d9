"""The transition function of one state by itself; `test_machine_transitions` plays it."""

from collections.abc import Callable

import pytest

from app.core.automaton import START, Prune, Sampling
from app.core.conditions import AtMost, Condition, Equals
from app.core.transition import Outcome, choose, distribution, pruned
from app.core.tree import Branch, Leaf, Tree
from tests.fakes import Listed, leaf, rules, yes
from tests.samples import automaton, state

A, B = state("a", "Forward"), state("b", "RotateLeft")
#: A test of a feature that nobody may ask for, and a leaf.
ASKED, FULL = AtMost("not there", 0.0), Leaf((1.0,))
MET: dict[str, float] = {"on": 1.0, "off": 0.0, "d": 3.0}


def outcome(*listed: Listed, learned: Tree | None = None, prunes: tuple[Prune, ...] = ()) -> Outcome:
    chooser = automaton("chooser", A, B, rules=rules(*listed), prunes=prunes)
    return distribution(chooser, START, learned, MET.__getitem__)


def test_without_rules_and_model_all_probability_stays() -> None:
    assert outcome() == Outcome((START,), (1.0,), ())


def test_rules_take_their_shares_in_order_and_the_rest_falls_through_to_the_model() -> None:
    found = outcome(
        (START, yes("on"), "a", 0.5),
        (START, yes("off"), "b", 0.9),
        (START, (), "b", 0.2),
        learned=leaf(a=3.0, b=1.0),
    )
    assert found.states == ("a", "b", "a", "b", START)
    assert found.probabilities == pytest.approx((0.5, 0.1, 0.3, 0.1, 0.0))
    assert sum(found.probabilities) == pytest.approx(1.0)
    assert found.key == ("r1", "r3", (1,), (True, True))


def test_a_certain_rule_leaves_nothing_and_the_model_is_not_asked() -> None:
    found = outcome(
        (START, (), "a"), (START, (), "b"), learned=Tree(("b",), Branch(ASKED, FULL, FULL, (2.0,)))
    )
    assert (found.states, found.probabilities) == (("a", START), (1.0, 0.0))
    assert found.key == ("r1",)


def test_rules_of_other_states_do_not_count() -> None:
    assert outcome(("a", (), "b")).states == (START,)


def test_an_empty_leaf_stays() -> None:
    assert outcome(learned=leaf(a=0.0, b=0.0)).probabilities == (0.0, 0.0, 1.0)


def test_pruned_labels_are_gone_and_the_rest_is_made_to_add_up_to_1_within_what_the_rules_left() -> None:
    found = outcome(
        (START, (), "a", 0.5),
        learned=leaf(a=1.0, b=1.0),
        prunes=(Prune("p", START, yes("on"), frozenset({"a"})),),
    )
    assert found.probabilities == (0.5, 0.0, 0.5, 0.0)


def test_several_prunes_add_up_and_where_all_is_forbidden_the_rest_stays() -> None:
    both = (
        Prune("p", START, yes("on"), frozenset({"a"})),
        Prune("q", START, (Condition(AtMost("d", 5.0)),), frozenset({"b"})),
    )
    assert outcome((START, (), "a", 0.25), learned=leaf(a=1.0, b=1.0), prunes=both).probabilities == (
        0.25,
        0.0,
        0.0,
        0.75,
    )


def test_a_prune_whose_guard_is_not_met_changes_nothing() -> None:
    found = outcome(learned=leaf(a=1.0, b=1.0), prunes=(Prune("p", START, yes("off"), frozenset({"a"})),))
    assert found == outcome(learned=leaf(a=1.0, b=1.0))


def test_pruning_what_was_impossible_leaves_the_others_as_they_are() -> None:
    never = Prune("p", START, (), frozenset({"c"}))
    assert pruned((0.25, 0.75), ("a", "b"), (never,), MET.__getitem__) == [0.25, 0.75]


def test_the_key_tells_rules_leaves_and_what_is_possible_at_them_apart() -> None:
    tree = Tree(("a", "b"), Branch(Equals("on", 1.0), Leaf((1.0, 1.0)), Leaf((1.0, 2.0)), (2.0, 3.0)))
    other = Tree(("a", "b"), Branch(Equals("off", 1.0), Leaf((1.0, 1.0)), Leaf((1.0, 2.0)), (2.0, 3.0)))
    prune = Prune("p", START, (), frozenset({"a"}))
    keys = [
        outcome(learned=tree).key,
        outcome(learned=other).key,
        outcome(learned=tree, prunes=(prune,)).key,
        outcome((START, (), "a", 0.5), learned=tree).key,
    ]
    assert len(set(keys)) == 4


def fixed(u: float) -> Callable[[], float]:
    return lambda: u


def refuse() -> float:
    pytest.fail("nothing may be drawn")


HALVES = Outcome(("a", "b", START), (0.5, 0.5, 0.0), ("leaf",))


@pytest.mark.parametrize(("u", "chosen"), [(0.0, "a"), (0.4999, "a"), (0.5, "b"), (1.0 - 2.0**-53, "b")])
def test_the_first_state_at_which_the_running_sum_exceeds_the_draw_is_chosen(u: float, chosen: str) -> None:
    assert choose(HALVES, Sampling.SAMPLE, START, None, fixed(u)) == chosen


def test_where_rounding_keeps_the_sum_below_the_draw_the_last_possible_state_is_chosen() -> None:
    tenths = Outcome(("a",) * 9 + ("b", "c", START), (0.1,) * 10 + (0.0, 0.0), ())
    total = 0.0
    for p in tenths.probabilities:
        total += p
    almost = 1.0 - 2.0**-53
    assert total <= almost
    assert choose(tenths, Sampling.SAMPLE, START, None, fixed(almost)) == "b"


def test_an_impossible_state_is_never_chosen() -> None:
    edges = Outcome(("a", "b", "c", START), (0.0, 1.0, 0.0, 0.0), ())
    assert {choose(edges, Sampling.SAMPLE, START, None, fixed(u)) for u in (0.0, 0.5, 1.0 - 2.0**-53)} == {
        "b"
    }


def test_argmax_sums_up_the_shares_of_a_state_and_draws_nothing() -> None:
    shares = Outcome(("a", "b", "a", START), (0.3, 0.4, 0.3, 0.0), ())
    assert choose(shares, Sampling.ARGMAX, START, None, refuse) == "a"


def test_argmax_takes_the_first_of_equals() -> None:
    assert choose(HALVES, Sampling.ARGMAX, START, None, refuse) == "a"


def test_hold_draws_where_what_decides_is_new_and_otherwise_stays() -> None:
    assert choose(HALVES, Sampling.HOLD, START, None, fixed(0.7)) == "b"
    assert choose(HALVES, Sampling.HOLD, START, ("another leaf",), fixed(0.7)) == "b"
    assert choose(HALVES, Sampling.HOLD, START, ("leaf",), refuse) == START
