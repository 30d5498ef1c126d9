from dataclasses import replace

import pytest

from app.core.automaton import Automaton
from app.core.errors import LibraryError
from app.core.library import Library, NodeType, Types, known_flags, raised_flags, statistic_vocabulary
from app.core.vocabulary import BasicBehavior, Vocabulary
from tests.fakes import types_of
from tests.samples import (
    AGENT,
    GROUP,
    SQUAD,
    TYPES,
    automaton,
    fetch,
    flag,
    forage,
    goto,
    nested,
    state,
    vocabulary,
    wander,
)


def library(*automata: Automaton) -> Library:
    return Library({a.id: a for a in automata})


def holding(name: str, *held: str) -> Automaton:
    return automaton(name, *(nested(f"s{k}", one) for k, one in enumerate(held)))


# ------------------------------------------------------------------------------------------ a library's graph


def test_automata_come_bottom_up_each_after_those_it_holds_equals_by_name() -> None:
    mixed = library(forage(), fetch(), wander(), goto())
    assert [a.name for a in mixed.bottom_up()] == ["goto", "fetch", "wander", "forage"]


@pytest.mark.parametrize(
    ("automata", "cycle"),
    [
        ((holding("a", "a"),), {"a holds a"}),
        ((holding("a", "b"), holding("b", "a")), {"a holds b holds a", "b holds a holds b"}),
        (
            (holding("top", "a"), holding("a", "b"), holding("b", "c"), holding("c", "a")),
            {"a holds b holds c holds a", "b holds c holds a holds b", "c holds a holds b holds c"},
        ),
    ],
)
def test_recursion_is_refused_with_the_cycle_spelled_out(
    automata: tuple[Automaton, ...], cycle: set[str]
) -> None:
    with pytest.raises(LibraryError) as refused:
        library(*automata).bottom_up()
    assert str(refused.value) in {f"recursion is not permitted, but {one}" for one in cycle}


def test_a_cycle_is_spelled_out_in_names_not_ids() -> None:
    assert library(replace(holding("7", "7"), name="Forage")).cycle() == ("Forage", "Forage")
    assert library(holding("a", "b"), wander()).cycle() == ()


def test_holding_one_behavior_twice_or_by_two_ways_is_no_recursion() -> None:
    library(holding("top", "a", "b", "b"), holding("a", "b"), holding("b")).refuse_cycle()


def test_a_behavior_that_is_held_but_missing_is_named() -> None:
    with pytest.raises(LibraryError, match="there is no behavior with the id 'gone'; there are: a"):
        library(holding("a", "gone")).bottom_up()


def test_automata_are_found_by_id_and_by_name() -> None:
    one = replace(wander(), name="Wander about")
    assert library(one).get("wander") is one
    assert library(one).by_name("Wander about") is one
    assert library(one).by_name("wander") is None
    with pytest.raises(LibraryError, match="no behavior with the id 'Wander about'; there are: wander"):
        library(one).get("Wander about")


def test_users_are_those_that_hold_a_behavior_directly_all_users_also_those_above() -> None:
    whole = library(wander(), goto(), fetch(), forage())
    assert [a.id for a in whole.users("goto")] == ["fetch", "forage"]
    assert [a.id for a in whole.users("fetch")] == ["forage"]
    assert whole.all_users("goto") == {"fetch", "forage"}
    assert whole.all_users("forage") == frozenset()
    assert whole.all_users("not there") == frozenset()


def test_the_flags_of_an_automaton_are_those_of_its_flag_states_and_of_its_flag_raisers() -> None:
    both = automaton(
        "both", flag("x", "lost"), state("y", "ReleaseBox"), flag("z", "lost"), state("w", "Forward")
    )
    assert raised_flags(both, vocabulary()) == ("lost", "done")
    assert known_flags(library(both), vocabulary()) == ("done", "failed", "lost", "finished")


# --------------------------------------------------------------------------- what a controller's type can do


def test_agents_use_the_scenarios_own_words_up_to_their_level() -> None:
    words = types_of(wander()).vocabulary(AGENT)
    assert set(words.behaviors) == set(vocabulary().behaviors)
    assert set(words.targets) == {"nearest-box", "deposit"}
    assert "SomeoneNeedsHelp" not in words.features


def test_a_controllers_targets_are_those_of_its_level_or_below_and_its_features_those_of_groups() -> None:
    types = types_of(wander())
    assert set(types.vocabulary(GROUP).targets) == {"nearest-box", "deposit", "closest-attached-agent"}
    assert "biggest-attached-agent" in types.vocabulary(SQUAD).targets
    assert set(types.vocabulary(GROUP).features) == {"SomeoneNeedsHelp"}


def test_a_controllers_basic_behaviors_are_all_that_its_subsidiaries_can_do() -> None:
    types = types_of(wander(), goto(), group=(automaton("lead"),))
    derived = types.vocabulary(GROUP).behaviors
    assert set(derived) == {*vocabulary().behaviors, "wander", "goto"}
    assert all(behavior.derived for behavior in derived.values())
    assert derived["goto"].parameters == ("target",)
    assert set(types.vocabulary(SQUAD).behaviors) == {*derived, "lead"}


def test_a_derived_behavior_runs_once_where_the_original_does_and_raises_no_flag_itself() -> None:
    derived = types_of(wander()).vocabulary(SQUAD).behaviors
    once = {name for name, behavior in derived.items() if behavior.runs_once}
    assert once == {"GrabBox", "ReleaseBox", "ReleaseBoxAndFinish", "Done"}
    assert not any(behavior.raises or behavior.finishes for behavior in derived.values())


TWO_KINDS = (NodeType("walker"), NodeType("flyer"), NodeType("boss", 1, ("walker", "flyer")))


def shared(walker: Automaton, flyer: Automaton) -> set[str]:
    """The automata that a controller over two types of agents can direct."""
    types = Types(TWO_KINDS, {"walker": library(walker), "flyer": library(flyer)}, vocabulary())
    return set(types.vocabulary("boss").behaviors) - set(vocabulary().behaviors)


def test_a_controllers_basic_behaviors_are_those_that_all_its_subsidiaries_types_share_by_name_and_signature() -> (
    None
):
    assert shared(wander(), wander()) == {"wander"}
    assert shared(wander(), goto()) == set()
    assert shared(goto(), replace(goto(), id="other id", states=wander().states)) == {"goto"}
    assert shared(goto(), replace(goto(), parameters=())) == set()
    assert shared(goto(), replace(goto(), parameters=("place",))) == set()


def test_a_behavior_that_runs_once_for_one_of_the_types_runs_once_for_the_controller() -> None:
    mine = automaton("GrabBox")
    types = Types(TWO_KINDS, {"walker": library(mine)}, vocabulary())
    assert types.vocabulary("boss").behavior("GrabBox").one_shot


def test_a_learned_behavior_hides_a_basic_one_of_the_same_name() -> None:
    mine = automaton("GrabBox")
    assert types_of(mine).repertoire(AGENT)["GrabBox"] is mine


def test_an_unknown_type_is_refused_with_those_there_are() -> None:
    with pytest.raises(LibraryError, match="there is no node type 'robot'; there are: agent, group, squad"):
        types_of().vocabulary("robot")
    with pytest.raises(LibraryError, match="there is no node type 'ghost'; there are: boss"):
        Types((NodeType("boss", 1, ("ghost",)),), {}, vocabulary()).vocabulary("boss")


@pytest.mark.parametrize("level", [1, 2])
def test_types_that_stand_under_each_other_in_a_circle_are_refused(level: int) -> None:
    circle = (NodeType("a", 1, ("b",)), NodeType("b", level, ("a",)))
    with pytest.raises(LibraryError, match=f"'b' has level {level}, but under 'a' it must be below 1"):
        Types(circle, {}, vocabulary()).vocabulary("a")


def test_a_controller_type_without_subsidiaries_can_do_nothing() -> None:
    assert Types((NodeType("boss", 1),), {}, vocabulary()).vocabulary("boss").behaviors == {}


def test_a_type_without_a_library_has_an_empty_one() -> None:
    assert types_of().library(SQUAD).automata == {}


def test_statistics_are_made_of_the_scenarios_agent_features() -> None:
    words = statistic_vocabulary(types_of())
    assert "SeesABox" in words.features
    assert "SomeoneNeedsHelp" not in words.features


def test_derived_words_pass_through_every_level() -> None:
    words = Types(TYPES, {}, Vocabulary(behaviors={"Hop": BasicBehavior("Hop", ("over",), doc="Hops.")}))
    assert words.vocabulary(SQUAD).behavior("Hop") == BasicBehavior(
        "Hop", ("over",), derived=True, doc="Hops."
    )
