"""Parameters: who binds, who performs, and what an open slot or a target without referent does."""

from collections.abc import Callable

import pytest

from app.core.automaton import START, Automaton
from app.core.errors import BindingError
from app.core.features import Bindings, FeatureUse, Ground, Operation, Parameter, Sense, Statistic
from app.core.hierarchy import Hierarchy
from app.core.vocabulary import NO_ENTITY
from tests.fakes import HOLDS, Play, agents, inner, one_agent, rules, types_of, yes
from tests.samples import GROUP, SQUAD, automaton, nested, state

BOX, HOME = 60, 70
HERE: Bindings = {"target": Parameter("target")}

#: Faces its parameter.
FACE = automaton(
    "face",
    state("face", "Face", HERE),
    parameters=("target",),
    features=(FeatureUse("distance", Sense("DistanceTo", HERE)),),
    rules=rules((START, (), "face")),
)


def to(target: str) -> Bindings:
    return {"target": Ground(target)}


def test_a_slot_bound_to_a_ground_target_means_that_target() -> None:
    play = one_agent(
        automaton("home", state("face", "Face", to("deposit")), rules=rules((START, (), "face"))), top="home"
    )
    play.senses.target_is("deposit", HOME)
    assert [(action.behavior, action.targets) for action in play.tick()] == [("Face", (HOME,))]


def test_a_parameter_is_handed_down_through_two_levels() -> None:
    middle = automaton(
        "middle", nested("face", "face", HERE), parameters=("target",), rules=rules((START, (), "face"))
    )
    outer = automaton("outer", nested("middle", "middle", to("deposit")), rules=rules((START, (), "middle")))
    play = one_agent(FACE, middle, outer, top="outer")
    play.senses.target_is("deposit", HOME)
    assert play.tick()[0].targets == (HOME,)
    assert play.states("a") == "middle/face/face"


def test_a_parameter_of_another_name_is_handed_down_by_slot() -> None:
    outer = automaton(
        "outer",
        nested("face", "face", {"target": Parameter("goal")}),
        parameters=("goal",),
        rules=rules((START, (), "face")),
    )
    play = one_agent(FACE, outer, top="outer", goal="nearest-box")
    play.senses.target_is("nearest-box", BOX)
    assert play.tick()[0].targets == (BOX,)


def test_a_feature_takes_the_automatons_parameter() -> None:
    play = one_agent(FACE, top="face", target="deposit")
    play.senses.target_is("deposit", HOME)
    play.senses.feature_is("DistanceTo", 12.5)
    assert play.sees("a", Sense("DistanceTo", HERE)) == 12.5
    assert play.senses.asked == [("DistanceTo", 0, (HOME,))]


def test_two_features_of_one_automaton_can_have_different_targets() -> None:
    play = one_agent(FACE, top="face", target="deposit")
    play.senses.target_is("deposit", HOME)
    play.senses.target_is("nearest-box", BOX)
    play.sees("a", Sense("DistanceTo", HERE))
    play.sees("a", Sense("DistanceTo", to("nearest-box")))
    assert [targets for _, _, targets in play.senses.asked] == [(HOME,), (BOX,)]


def test_bindings_are_resolved_at_every_tick() -> None:
    play = one_agent(FACE, top="face", target="nearest-box")
    play.senses.target_is("nearest-box", BOX)
    play.senses.target_is("nearest-box", BOX + 1, since=2)
    assert [play.tick()[0].targets for _ in range(3)] == [(BOX,), (BOX,), (BOX + 1,)]


def test_a_target_without_referent_gives_a_feature_its_documented_default() -> None:
    play = one_agent(FACE, top="face", target="nearest-box")
    play.senses.target_is("nearest-box", NO_ENTITY)
    assert play.sees("a", Sense("DistanceTo", HERE)) == 1000.0
    assert play.senses.asked == []


def test_a_behavior_whose_target_has_no_referent_idles_until_there_is_one() -> None:
    play = one_agent(FACE, top="face", target="nearest-box")
    play.senses.target_is("nearest-box", NO_ENTITY)
    play.senses.target_is("nearest-box", BOX, since=2)
    assert play.does(4) == ["", "", "Face", "Face"]
    assert play.states("a") == "face"


@pytest.mark.parametrize("binding", [{}, {"goal": Ground("deposit")}])
def test_an_open_slot_of_a_behavior_is_an_error_that_names_the_state_and_the_slot(binding: Bindings) -> None:
    play = one_agent(
        automaton("home", state("turn-there", "Face", binding), rules=rules((START, (), "turn-there"))),
        top="home",
    )
    with pytest.raises(BindingError, match="'target' of state 'turn-there' of 'home' is open"):
        play.tick()


def test_an_open_parameter_of_a_nested_automaton_is_an_error_that_names_the_state_and_the_slot() -> None:
    play = one_agent(
        FACE, automaton("outer", nested("go", "face"), rules=rules((START, (), "go"))), top="outer"
    )
    with pytest.raises(BindingError, match="'target' of state 'go' of 'outer' is open"):
        play.tick()


def test_an_open_slot_of_a_feature_is_an_error_that_names_the_feature_and_the_slot() -> None:
    far = automaton(
        "far",
        state("on", "Forward"),
        features=(FeatureUse("d", Sense("DistanceTo"), "how far"),),
        rules=rules((START, yes("d"), "on")),
    )
    with pytest.raises(BindingError, match="'target' of feature 'how far' of 'far' is open"):
        one_agent(far, top="far").tick()


def test_a_binding_to_a_parameter_that_the_automaton_lacks_is_an_error_that_names_both() -> None:
    wrong = automaton(
        "wrong",
        state("face", "Face", {"target": Parameter("there")}),
        parameters=("here",),
        rules=rules((START, (), "face")),
    )
    with pytest.raises(
        BindingError, match=r"'target' of state 'face' of 'wrong' is bound to 'there'.*are: here"
    ):
        one_agent(wrong, top="wrong", here="deposit").tick()


def test_an_error_leaves_the_node_in_the_state_in_which_it_was() -> None:
    play = one_agent(automaton("home", state("face", "Face"), rules=rules((START, (), "face"))), top="home")
    with pytest.raises(BindingError):
        play.tick()
    assert play.states("a") == START


@pytest.mark.parametrize("behavior", ["face", "Face"])
def test_a_behavior_cannot_be_started_without_targets_for_its_parameters(behavior: str) -> None:
    with pytest.raises(BindingError, match=f"'target' of '{behavior}' is open: 'a' needs a target"):
        one_agent(FACE, top=behavior)


# ---------------------------------------------------------------------------------- who owns, who performs


def closest_attached(attached: set[int]) -> Callable[[range, int], int]:
    """What closest-attached-agent means: the attached agent in the owner's subtree with the nearest number."""

    def found(members: range, performer: int) -> int:
        others = [agent for agent in members if agent in attached]
        if performer in attached or not others:
            return NO_ENTITY
        return min(others, key=lambda agent: abs(agent - performer))

    return found


CALL = automaton(
    "call",
    state("gather", "face", to("closest-attached-agent")),
    rules=rules((START, (), "gather")),
)


def two_groups(*squad: Automaton) -> Play:
    """A squad ``s`` of the groups ``g`` (agents 0 to 2) and ``h`` (agents 3 to 5)."""
    forest = Hierarchy(
        (
            inner(
                "s",
                SQUAD,
                inner("g", GROUP, *agents("a", "b", "c")),
                inner("h", GROUP, *agents("d", "e", "f")),
            ),
        )
    )
    return Play(forest, types_of(FACE, group=(CALL,), squad=squad))


def test_a_controllers_target_is_bound_by_the_controller_and_resolved_for_the_agent_that_acts() -> None:
    play = two_groups()
    asked: list[tuple[range, int]] = []

    def noted(members: range, performer: int) -> int:
        asked.append((members, performer))
        return 100 + performer

    play.senses.target_is("closest-attached-agent", noted)
    play.direct("h", "call")
    assert [(action.agent, action.targets) for action in play.tick()] == [
        (3, (103,)),
        (4, (104,)),
        (5, (105,)),
    ]
    assert set(asked) == {(range(3, 6), 3), (range(3, 6), 4), (range(3, 6), 5)}


def test_closest_attached_agent_is_the_attached_one_of_the_owners_nearest_the_performer_none_for_an_attached_one() -> (
    None
):
    play = two_groups()
    play.senses.target_is("closest-attached-agent", closest_attached({2, 3, 5}))
    play.direct("h", "call")
    assert [(action.agent, action.targets) for action in play.tick()] == [(4, (3,))]


def test_a_target_of_level_2_is_handed_through_level_1_to_agents_with_level_2_as_the_owner() -> None:
    summon = automaton(
        "summon", state("all", "face", to("biggest-attached-agent")), rules=rules((START, (), "all"))
    )
    play = two_groups(summon)
    asked: list[tuple[range, int]] = []

    def noted(members: range, performer: int) -> int:
        asked.append((members, performer))
        return 200

    play.senses.target_is("biggest-attached-agent", noted)
    play.direct("s", "summon")
    actions = play.tick()
    assert [(action.agent, action.behavior) for action in actions] == [(agent, "Face") for agent in range(6)]
    assert {members for members, _ in asked} == {range(6)}
    assert [performer for _, performer in asked] == list(range(6))


def test_a_parameterized_controller_hands_on_what_its_own_controller_bound() -> None:
    call = automaton(
        "come",
        state("face", "face", HERE),
        parameters=("target",),
        rules=rules((START, (), "face")),
    )
    summon = automaton(
        "summon", state("all", "come", to("biggest-attached-agent")), rules=rules((START, (), "all"))
    )
    forest = Hierarchy((inner("s", SQUAD, inner("g", GROUP, *agents("a")), inner("h", GROUP, *agents("b"))),))
    play = Play(forest, types_of(FACE, group=(call,), squad=(summon,)))
    play.senses.target_is("biggest-attached-agent", lambda members, _: members.stop)
    play.direct("s", "summon")
    assert [action.targets for action in play.tick()] == [(2,), (2,)]


def test_a_statistic_binds_targets_by_the_controller_with_each_agent_as_the_performer() -> None:
    play = two_groups()
    play.direct("h", "call")
    asked: list[tuple[range, int]] = []

    def noted(members: range, performer: int) -> int:
        asked.append((members, performer))
        return NO_ENTITY if performer == 4 else 50

    play.senses.target_is("closest-attached-agent", noted)
    play.senses.feature_is("DistanceTo", 6.0)
    far = Statistic(Operation.MAX, Sense("DistanceTo", to("closest-attached-agent")))
    assert play.sees("h", far) == 1000.0
    assert asked == [(range(3, 6), 3), (range(3, 6), 4), (range(3, 6), 5)]


def test_an_agent_is_its_own_owner() -> None:
    play = two_groups()
    play.senses.target_is("nearest-box", lambda members, performer: 10 * len(members) + performer)
    play.direct("e", "face", target="nearest-box")
    assert play.tick()[0].targets == (14,)


def test_an_attached_feature_needs_no_target() -> None:
    play = one_agent(FACE, top="face", target="deposit")
    play.senses.feature_is("IsAttached", 1.0)
    assert play.sees("a", HOLDS.source) == 1.0
