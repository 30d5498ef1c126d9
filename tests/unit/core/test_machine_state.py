"""Freezing and thawing, most of all after edits; `tests/property/test_machine.py` has the round trips."""

import json
from dataclasses import replace

import pytest

from app.core.automaton import START, Automaton, Sampling, Settings, State
from app.core.features import FlagUp, Ground
from app.core.hierarchy import Hierarchy
from app.core.library import Types
from app.core.machine import stored_classifiers
from app.core.machine_state import freeze, rebase, thaw, thaw_node
from app.core.tree import Leaf, Tree
from app.core.vocabulary import DONE
from tests.fakes import DONE_UP, Play, agents, inner, one_agent, rules, types_of
from tests.samples import GROUP, SQUAD, automaton, flag, nested, state

FACE = automaton(
    "face",
    state("turn", "Face", {"target": Ground("deposit")}),
    state("on", "Forward"),
    rules=rules((START, (), "turn")),
)
OUTER = automaton(
    "outer", nested("facing", "face"), state("rest", "RotateLeft"), rules=rules((START, (), "facing"))
)
CALL = automaton(
    "call",
    state("gather", "Face", {"target": Ground("closest-attached-agent")}),
    state("all", "outer"),
    rules=rules((START, (), "all")),
)


def group_of_two(*automata: Automaton, group: Automaton = CALL) -> Play:
    play = Play(
        Hierarchy((inner("g", GROUP, *agents("a", "b")),)),
        types_of(*(automata or (FACE, OUTER)), group=(group,)),
    )
    play.senses.target_is("deposit", 9)
    play.senses.target_is("closest-attached-agent", 8)
    play.direct("g", "call")
    play.tick()
    return play


def edited(play: Play, *automata: Automaton, group: Automaton = CALL) -> Play:
    """The same play after an edit of its libraries."""
    rebase(play.machine, types_of(*(automata or (FACE, OUTER)), group=(group,)), stored_classifiers)
    return play


def test_a_frozen_machine_is_plain_data_that_keeps_arguments_with_their_owners() -> None:
    play = group_of_two()
    play.tick({"g": "gather"}, taught=["g"])
    frozen = freeze(play.machine)
    assert json.loads(json.dumps(frozen)) == frozen
    assert frozen["now"] == 2
    assert frozen["nodes"]["g"]["direction"] == ["Face", {"target": ["closest-attached-agent", "g"]}]
    assert frozen["nodes"]["b"]["run"]["arguments"] == {"target": ["closest-attached-agent", "g"]}


def test_a_frozen_copy_does_not_change_with_the_machine() -> None:
    play = group_of_two()
    frozen = freeze(play.machine)
    before = json.dumps(frozen)
    play.direct("a", "Done")
    play.tick({"g": "gather"}, taught=["g"])
    assert json.dumps(frozen) == before


def test_thawing_twice_gives_states_that_do_not_share_anything() -> None:
    play = group_of_two()
    frozen = freeze(play.machine)
    thaw(play.machine, frozen)
    play.run("a").flags.add(DONE)
    thaw(play.machine, frozen)
    assert play.shown("a") == set()


def test_nodes_that_only_one_side_knows_are_left_alone() -> None:
    play = group_of_two()
    frozen = freeze(play.machine)
    other = Play(Hierarchy(agents("a", "z")), types_of(FACE, OUTER))
    other.direct("z", "outer")
    thaw(other.machine, frozen)
    assert other.states("a") == "facing/turn"
    assert other.states("z") == START


def test_that_a_controller_has_left_its_direction_is_kept() -> None:
    flagging = automaton("outer", flag("up"), rules=rules((START, (), "up")))
    play = group_of_two(flagging)
    play.machine.enter(play.actor("g"), play.run("g"), START)
    other = group_of_two(flagging)
    thaw(other.machine, freeze(play.machine))
    assert other.shown("a") == {DONE}
    other.tick(taught=["g"], still=["a", "b"])
    assert other.shown("a") == set()


def test_a_held_draw_still_stands_after_thawing() -> None:
    flip = Tree(("on", "off"), Leaf((1.0, 1.0)))
    hold = automaton(
        "hold",
        state("on", "Forward"),
        state("off", "RotateLeft"),
        rules=rules((START, (), "on")),
        learned={"on": flip},
        settings=Settings(sampling=Sampling.HOLD),
    )
    stays = next(
        seed for seed in range(20) if one_agent(hold, top="hold", seed=seed).trace("a", 2)[1] == "on"
    )
    play = one_agent(hold, top="hold", seed=stays)
    play.trace("a", 2)
    thaw(play.machine, json.loads(json.dumps(freeze(play.machine))))
    assert play.trace("a", 20) == ["on"] * 20


# --------------------------------------------------------------------------------------------- after an edit


def test_an_edited_automaton_goes_on_in_the_same_state() -> None:
    more = replace(FACE, rules=rules((START, (), "turn"), ("turn", (), "on")))
    play = edited(group_of_two(), more, OUTER)
    assert play.states("a") == "facing/turn"
    assert play.does() == ["Forward"]


def test_an_automaton_whose_state_is_gone_is_in_start() -> None:
    less = replace(FACE, states=(FACE.states[0], FACE.states[2]), rules=())
    play = edited(group_of_two(), less, OUTER)
    assert play.states("a") == "facing/start"
    assert play.does() == [""]


@pytest.mark.parametrize(
    "content",
    [state("facing", "Forward"), nested("facing", "other"), flag("facing"), state("facing", "Face")],
)
def test_an_automaton_whose_state_holds_something_else_now_is_in_start(content: State) -> None:
    changed = replace(OUTER, states=(OUTER.states[0], content), rules=())
    play = edited(group_of_two(), FACE, changed, automaton("other"))
    assert play.states("a") == START


def test_a_node_whose_behavior_is_gone_idles() -> None:
    play = edited(group_of_two(), FACE, group=replace(CALL, states=CALL.states[:2], rules=()))
    assert play.actor("a").run is None
    assert play.states("g") == START
    assert play.actor("g").direction is None


def test_a_node_whose_behavior_needs_a_new_target_idles() -> None:
    play = edited(group_of_two(), FACE, replace(OUTER, parameters=("goal",)), group=automaton("call"))
    assert play.actor("a").run is None
    assert play.actor("g").direction is None


def test_a_node_whose_target_was_bound_by_a_node_that_is_gone_idles() -> None:
    play = group_of_two()
    play.tick({"g": "gather"}, taught=["g"])
    other = Play(Hierarchy(agents("a")), types_of(FACE, OUTER))
    thaw(other.machine, freeze(play.machine))
    assert other.actor("a").run is None


def test_rebasing_uses_the_new_models() -> None:
    play = group_of_two()
    types = types_of(FACE, OUTER, group=(CALL,))
    rebase(play.machine, types, lambda *_: None)
    assert play.machine.types is types


def test_flags_survive_an_edit_of_the_state_that_raised_them() -> None:
    once = automaton("face", flag("up"), rules=rules((START, (), "up")))
    watch = replace(OUTER, features=(DONE_UP,))
    play = group_of_two(once, watch)
    assert play.sees("a", FlagUp(DONE)) == 1.0
    play = edited(play, replace(once, states=once.states[:1], rules=()), watch)
    assert play.sees("a", FlagUp(DONE)) == 1.0


# ------------------------------------------------------------------------------------------------- one node


def test_one_node_and_all_below_it_go_back_while_the_others_and_time_go_on() -> None:
    command = automaton("command", state("call", "call"), rules=rules((START, (), "call")))
    forest = Hierarchy((inner("s", SQUAD, inner("g", GROUP, *agents("a")), inner("h", GROUP, *agents("b"))),))
    play = Play(forest, types_of(FACE, OUTER, group=(CALL,), squad=(command,)))
    play.senses.target_is("deposit", 9)
    play.senses.target_is("closest-attached-agent", 8)
    play.direct("s", "command")
    play.tick()
    before = freeze(play.machine)
    for group in ("g", "h"):
        play.tick({group: "gather"}, taught=["g", "h"], still=["s"])
    thaw_node(play.machine, "g", before)
    assert [play.states(node) for node in "ghab"] == ["all", "gather", "facing/turn", ""]
    assert play.run("b").behavior.name == "Face"
    assert play.machine.now == 3
    assert isinstance(play.machine.types, Types)
