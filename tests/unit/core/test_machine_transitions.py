"""Transitions: authored rules, then the learned tree, then "stay"; sampled, most probable, or held."""

from dataclasses import replace

import pytest

from app.core.automaton import START, Automaton, Prune, Refit, Sampling, Settings
from app.core.chance import FIRST_CONTROLLER, draw, world_key
from app.core.conditions import Equals
from app.core.errors import LibraryError
from app.core.hierarchy import Hierarchy
from app.core.tree import Branch, Leaf, Tree
from tests.fakes import HOLDS, SEES, Play, agents, inner, leaf, one_agent, rules, types_of, yes
from tests.samples import GROUP, automaton, nested, state

SEEDS = range(40)
WALK, LEFT, RIGHT = state("walk", "Forward"), state("left", "RotateLeft"), state("right", "RotateRight")


def drawn(seed: int, tick: int, depth: int = 0, who: int = 0) -> float:
    """The number that decides a transition."""
    return draw(world_key(seed, 0), tick, who, depth)


def after_first_tick(chooser: Automaton, seed: int, **features: float) -> str:
    play = one_agent(chooser, top=chooser.name, seed=seed)
    for name, value in features.items():
        play.senses.feature_is(name, value)
    return play.trace("a", 1)[0]


def test_the_first_rule_whose_guard_is_met_decides_if_it_is_certain() -> None:
    two = automaton(
        "two",
        LEFT,
        RIGHT,
        features=(SEES, HOLDS),
        rules=rules((START, yes("sees"), "left"), (START, yes("holds"), "right"), (START, (), START)),
    )
    assert after_first_tick(two, 0) == START
    assert after_first_tick(two, 0, IsAttached=1.0) == "right"
    assert after_first_tick(two, 0, IsAttached=1.0, SeesABox=1.0) == "left"


def test_every_condition_of_a_guard_must_be_met() -> None:
    both = automaton(
        "both", LEFT, features=(SEES, HOLDS), rules=rules((START, yes("sees") + yes("holds"), "left"))
    )
    assert after_first_tick(both, 0, SeesABox=1.0) == START
    assert after_first_tick(both, 0, SeesABox=1.0, IsAttached=1.0) == "left"


@pytest.mark.parametrize("seed", SEEDS)
def test_each_rule_takes_its_probability_of_what_is_left_and_the_tree_gets_the_rest(seed: int) -> None:
    mixed = automaton(
        "mixed",
        WALK,
        LEFT,
        RIGHT,
        rules=rules((START, (), "left", 0.5), (START, (), "right", 0.5)),
        learned={START: leaf(walk=3.0, left=1.0)},
    )
    # left 1/2, right 1/4, and of the quarter that remains three to one walk and left
    u = drawn(seed, 0)
    expected = "left" if u < 0.5 else "right" if u < 0.75 else "walk" if u < 0.75 + 0.25 * 0.75 else "left"
    assert after_first_tick(mixed, seed) == expected


@pytest.mark.parametrize("seed", SEEDS)
def test_what_the_rules_leave_stays_where_nothing_was_learned(seed: int) -> None:
    turn = automaton("turn", LEFT, rules=rules((START, (), "left", 0.3)))
    assert after_first_tick(turn, seed) == ("left" if drawn(seed, 0) < 0.3 else START)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_learned_leaf_is_sampled_at_every_tick(seed: int) -> None:
    flip = leaf(walk=1.0, left=3.0)
    flipper = automaton("flip", WALK, LEFT, learned={START: flip, "walk": flip, "left": flip})
    play = one_agent(flipper, top="flip", seed=seed)
    assert play.trace("a", 10) == ["walk" if drawn(seed, tick) < 0.25 else "left" for tick in range(10)]


def test_the_depth_of_an_automaton_is_the_number_of_its_draw() -> None:
    flip = leaf(walk=1.0, left=1.0)
    flipper = automaton("flip", WALK, LEFT, learned={START: flip, "walk": flip, "left": flip})
    outer = automaton("outer", nested("flip", "flip"), rules=rules((START, (), "flip")))
    play = one_agent(flipper, outer, top="outer", seed=7)
    assert play.trace("a", 20) == [
        "flip/walk" if drawn(7, tick, depth=1) < 0.5 else "flip/left" for tick in range(20)
    ]


def test_agents_and_controllers_each_draw_their_own_numbers() -> None:
    flip = leaf(walk=1.0, left=1.0)
    flipper = automaton("flip", WALK, LEFT, learned={START: flip, "walk": flip, "left": flip})
    forest = Hierarchy((inner("g", GROUP, *agents("a")), inner("h", GROUP, *agents("b"))))
    play = Play(forest, types_of(flipper, group=(flipper,)), seed=3)
    play.direct("h", "flip")
    play.direct("a", "flip")
    for tick in range(10):
        play.tick()
        assert play.states("h") == ("walk" if drawn(3, tick, who=FIRST_CONTROLLER + 1) < 0.5 else "left")
        assert play.states("a") == ("walk" if drawn(3, tick, who=0) < 0.5 else "left")


def test_argmax_takes_the_most_probable_state_of_rules_and_tree_together() -> None:
    mixed = automaton(
        "mixed",
        WALK,
        LEFT,
        RIGHT,
        rules=rules((START, (), "left", 0.4)),
        learned={START: leaf(walk=5.0, left=1.0, right=4.0)},
        settings=Settings(sampling=Sampling.ARGMAX),
    )
    # left 0.4 + 0.06, walk 0.3, right 0.24
    assert {after_first_tick(mixed, seed) for seed in SEEDS} == {"left"}


def test_argmax_takes_the_first_of_equals() -> None:
    even = automaton(
        "even",
        WALK,
        LEFT,
        learned={START: leaf(left=1.0, walk=1.0)},
        settings=Settings(sampling=Sampling.ARGMAX),
    )
    assert {after_first_tick(even, seed) for seed in SEEDS} == {"left"}


BY_SIGHT = Tree(("walk", "left"), Branch(Equals("sees", 1.0), Leaf((1.0, 1.0)), Leaf((3.0, 1.0)), (4.0, 2.0)))
HOLDING = automaton(
    "holding",
    WALK,
    LEFT,
    features=(SEES, HOLDS),
    rules=rules((START, (), "walk")),
    learned={"walk": BY_SIGHT},
    settings=Settings(sampling=Sampling.HOLD),
)


@pytest.mark.parametrize("seed", SEEDS)
def test_hold_draws_again_only_when_the_leaf_changes(seed: int) -> None:
    play = one_agent(HOLDING, top="holding", seed=seed)
    play.senses.feature_is("SeesABox", 1.0, since=5)
    first = "walk" if drawn(seed, 1) < 0.75 else "left"
    second = first if first == "left" else ("walk" if drawn(seed, 5) < 0.5 else "left")
    assert play.trace("a", 9) == ["walk"] + [first] * 4 + [second] * 4


@pytest.mark.parametrize("seed", SEEDS)
def test_hold_draws_anew_when_the_state_is_entered_anew(seed: int) -> None:
    flip = leaf(walk=1.0, left=1.0)
    flipper = replace(HOLDING, rules=(), learned={START: flip, "walk": flip, "left": flip})
    expected, current, fresh = [], START, True
    for tick in range(12):
        drawn_now = "walk" if drawn(seed, tick) < 0.5 else "left"
        if fresh and drawn_now != current:
            current = drawn_now
        else:
            fresh = False
        expected.append(current)
    assert one_agent(flipper, top="holding", seed=seed).trace("a", 12) == expected


def test_hold_draws_again_when_the_leaf_is_pruned_otherwise() -> None:
    held = replace(HOLDING, prunes=(Prune("p", "walk", yes("holds"), frozenset({"walk"})),))
    seed = next(seed for seed in SEEDS if drawn(seed, 1) < 0.75)
    play = one_agent(held, top="holding", seed=seed)
    play.senses.feature_is("IsAttached", 1.0, since=4)
    assert play.trace("a", 5) == ["walk"] * 4 + ["left"]


def test_a_prune_forbids_labels_where_its_guard_is_met_and_the_rest_adds_up_to_1_again() -> None:
    three = automaton(
        "three",
        WALK,
        LEFT,
        RIGHT,
        features=(SEES,),
        learned={START: leaf(walk=2.0, left=1.0, right=1.0)},
        prunes=(Prune("p", START, yes("sees"), frozenset({"walk"})),),
    )
    for seed in SEEDS:
        u = drawn(seed, 0)
        assert after_first_tick(three, seed) == ("walk" if u < 0.5 else "left" if u < 0.75 else "right")
        assert after_first_tick(three, seed, SeesABox=1.0) == ("left" if u < 0.5 else "right")


def test_where_everything_is_pruned_it_stays() -> None:
    two = automaton(
        "two",
        WALK,
        LEFT,
        rules=rules((START, (), "left", 0.25)),
        learned={START: leaf(walk=2.0)},
        prunes=(Prune("p", START, (), frozenset({"walk"})),),
    )
    for seed in SEEDS:
        assert after_first_tick(two, seed) == ("left" if drawn(seed, 0) < 0.25 else START)


def test_a_prune_forbids_nothing_in_other_states_and_no_rule() -> None:
    two = automaton(
        "two",
        WALK,
        LEFT,
        rules=rules((START, (), "walk")),
        learned={"walk": leaf(left=1.0)},
        prunes=(Prune("p", START, (), frozenset({"walk", "left"})),),
    )
    assert one_agent(two, top="two").trace("a", 2) == ["walk", "left"]


def test_only_features_that_are_tested_are_asked_for_and_each_once() -> None:
    play = one_agent(HOLDING, top="holding")
    play.tick()
    assert play.senses.asked == []
    play.tick()
    assert play.senses.asked == [("SeesABox", 0, ())]


def test_a_model_that_is_refitted_decides_through_the_given_classifiers() -> None:
    refitted = automaton("refitted", WALK, LEFT, learned={START: Refit("knn")})
    forest = Hierarchy(agents("a"))
    play = Play(forest, types_of(refitted))
    play.direct("a", "refitted")
    assert play.trace("a", 2) == [START, START]
    play = Play(forest, types_of(refitted), classifiers=lambda *_: leaf(left=1.0))
    play.direct("a", "refitted")
    assert play.trace("a", 2) == ["left", "left"]


def test_a_transition_to_a_missing_state_names_it_and_those_there_are() -> None:
    lost = automaton("lost", WALK, rules=rules((START, (), "nowhere")))
    with pytest.raises(
        LibraryError, match="no state 'nowhere' to enter: the states of 'lost' are: start, walk"
    ):
        one_agent(lost, top="lost").tick()


def test_a_test_of_a_missing_feature_names_it_and_those_there_are() -> None:
    lost = automaton("lost", WALK, features=(SEES, HOLDS), rules=rules((START, yes("smells"), "walk")))
    with pytest.raises(
        LibraryError, match="'lost' has no feature 'smells' to test; its features are: sees, holds"
    ):
        one_agent(lost, top="lost").tick()


def test_a_listener_is_told_of_each_change_at_the_top_of_a_node_before_it_happens() -> None:
    inside = automaton("inside", WALK, LEFT, rules=rules((START, (), "walk"), ("walk", (), "left")))
    outer = automaton(
        "outer",
        nested("in", "inside"),
        RIGHT,
        features=(SEES,),
        rules=rules((START, (), "in"), ("in", yes("sees"), "right")),
    )
    told: list[tuple[int, str, str, str]] = []
    play = Play(
        Hierarchy(agents("a")),
        types_of(inside, outer),
        leaving=lambda actor, new: told.append((play.machine.now, actor.node.id, play.states("a"), new)),
    )
    play.senses.feature_is("SeesABox", 1.0, since=3)
    play.direct("a", "outer")
    play.trace("a", 5)
    assert told == [(0, "a", START, "in"), (3, "a", "in/left", "right")]
