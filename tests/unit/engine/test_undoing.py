"""Taking picks back one by one, also after ticks have passed, and what controllers direct with them."""

from dataclasses import replace

import pytest

from app.core.automaton import START
from app.core.edits import disable_examples, remove_state
from app.engine.commands import Others, Pick, RedoPick, ShouldNotHaveLeft, UndoPick
from app.engine.snapshots import Snapshot
from tests.driver import Driver


def lesson() -> Driver:
    return Driver().teach("agent-1", "Shuttle")


def test_a_pick_can_be_taken_back_before_the_tick_that_carries_it_out() -> None:
    driver = lesson().pick("up").undo().advance(3)
    assert (driver.taught, driver.state(), driver.place()) == ([], START, 0.0)


def test_a_pick_can_be_taken_back_after_ticks_have_passed() -> None:
    driver = lesson().pick("up").advance(3).pick("down").advance(2).undo()
    assert (driver.taught, driver.state()) == (["start>up", "up>up+"], "up")
    assert driver.advance().place() == 2.0  # time is not turned back: up to 3, down to 1, up again


def test_picks_are_taken_back_one_by_one_the_last_first() -> None:
    driver = lesson().pick("up").advance().pick("jump").advance().pick("down").advance()
    seen = [(driver.undo().taught, driver.state()) for _ in range(3)]
    assert seen == [
        (["start>up", "up>up+", "up>jump"], "jump"),
        (["start>up", "up>up+"], "up"),
        ([], START),
    ]


def test_a_one_shot_that_was_pulsed_is_not_pulsed_again_by_taking_back_what_came_after() -> None:
    driver = lesson().pick("jump").advance().pick("up").advance().undo().advance(3)
    assert (driver.state(), driver.place()) == ("jump", 6.0)


def test_a_pick_that_recorded_nothing_can_be_taken_back() -> None:
    driver = lesson().pick("jump").advance().pick("jump").advance().pick(START).advance()
    assert driver.undo().state() == "jump"
    assert driver.undo().undo().state() == START
    assert driver.taught == []


def test_taking_back_a_pick_inside_an_automaton_puts_the_node_back_inside_it() -> None:
    driver = lesson().pick("signal").advance(2)
    assert driver.state() == "signal/up"
    driver.pick("down").advance().undo()
    assert driver.state() == "signal/up"
    assert driver.advance().view().basic == "Up"


def test_ticks_that_passed_under_a_pick_that_was_taken_back_do_not_count() -> None:
    driver = lesson().pick("up").advance(3).pick("down").advance(50).undo().pick("jump")
    assert driver.examples[-1].values["ticks"] == 3.0


def test_taking_back_a_pick_of_several_agents_in_turn_puts_back_the_one_it_was_for() -> None:
    driver = Driver().teach(("agent-1", "agent-2"), "Shuttle")
    driver.pick("up", "agent-1").advance(2).pick("up", "agent-2").advance(2).undo().advance(2)
    assert [driver.state(node) for node in ("agent-1", "agent-2")] == ["up", START]
    assert [driver.place(1), driver.place(2)] == [6.0, 12.0]


def test_nothing_is_taken_back_where_nothing_was_picked() -> None:
    assert lesson().refused(UndoPick()) == "there is no pick left to take back in this lesson"


def test_nothing_of_an_earlier_lesson_is_taken_back() -> None:
    driver = lesson().pick("up").advance().teach("agent-2", "Shuttle")
    driver.refused(UndoPick())
    assert driver.taught == ["start>up", "up>up+"]


# -------------------------------------------------------------------------------------------------- in a test


def in_a_test() -> Driver:
    return lesson().pick("up").advance(3).pick("down").advance(2).test().advance(2)


def test_taking_back_a_correction_lets_the_node_go_on_with_the_test() -> None:
    driver = in_a_test()
    was = driver.state("agent-2")
    driver.pick("jump", "agent-2").advance(2)
    assert driver.view().taught
    driver.undo()
    assert (driver.view().taught, driver.state()) == (False, was)


def test_taking_back_a_replaced_correction_lets_the_node_go_on_with_the_test() -> None:
    driver = in_a_test().pick("jump", "agent-2").pick("signal", "agent-2").undo()
    assert not driver.view("agent-2").taught


def test_taking_back_the_second_of_two_corrections_leaves_the_node_in_training() -> None:
    driver = in_a_test().pick("jump", "agent-2").advance().pick("up", "agent-2").advance().undo()
    assert (driver.view("agent-2").taught, driver.state("agent-2")) == (True, "jump")


def test_taking_back_should_not_have_left_lets_it_be_said_again() -> None:
    driver = lesson().pick("up").advance(3).pick("down").advance(2).test().advance(6)
    before = driver.taught
    driver.should_not_have_left().advance(2).undo()
    assert (driver.taught, driver.view().taught) == (before, False)
    assert len(driver.should_not_have_left().taught) == len(before) + 1


def test_a_pick_of_before_the_test_is_taken_back_without_disturbing_the_test() -> None:
    driver = in_a_test()
    was = driver.state()
    driver.undo()
    assert (driver.taught, driver.state()) == (["start>up", "up>up+"], was)
    assert not driver.view().taught


# ------------------------------------------------------------------------------------------------ controllers


def test_taking_back_a_pick_for_a_controller_puts_all_below_it_back_too() -> None:
    driver = Driver(arm="groups").teach("group-1", "Lead").pick("signal").advance(2)
    inside = [driver.state(agent) for agent in ("agent-1", "agent-2")]
    assert inside == ["up", "up"]
    driver.pick("down").advance(2)
    assert [driver.view(agent).basic for agent in ("agent-1", "agent-2")] == ["Down", "Down"]
    driver.undo()
    assert driver.state("group-1") == "signal"
    assert [driver.state(agent) for agent in ("agent-1", "agent-2")] == inside
    assert driver.does(2, "agent-1") == ["Up", ""]  # its third step, and the signal


def test_taking_back_a_pick_for_a_controller_leaves_other_groups_alone() -> None:
    driver = Driver(arm="groups").advance(2).teach("group-1", "Lead", others=Others.RUN)
    driver.pick("down").advance(3).undo().advance(2)
    assert [driver.view(agent).basic for agent in ("agent-3", "agent-4")] == ["Up", "Up"]
    assert driver.place(3) == 27.0


def test_after_taking_back_the_first_pick_the_last_direction_stands_again() -> None:
    driver = Driver(arm="groups").advance(2).teach("group-1", "Lead").pick("down").advance(1).undo()
    assert driver.state() == START
    assert driver.advance().view("agent-1").behavior == "Stroll"


# ------------------------------------------------------------------------- undone by the caller in other ways


def test_examples_that_were_disabled_meanwhile_go_with_their_pick() -> None:
    driver = lesson().pick("up").advance()
    driver.edit(disable_examples, "agent", "Shuttle", ["1"]).undo()
    assert driver.taught == []


@pytest.mark.parametrize("ticks", [0, 1])
def test_after_taking_back_the_same_numbers_are_given_again(ticks: int) -> None:
    driver = lesson().pick("up").advance(ticks).undo().pick("down")
    assert [(e.id, e.pick) for e in driver.examples] == [("1", 1), ("2", 1)]


def test_a_state_that_is_picked_again_by_what_it_holds_after_undo_gets_its_id_again() -> None:
    driver = Driver().teach("agent-1", "Seek", target="lamp").pick("Up").advance().undo().pick("Up")
    assert driver.automaton.states[1].id == "up"
    driver.session.send(Pick("agent-1", "up"))
    driver.listen()


# ------------------------------------------------------------------------------------------------- done again


def looks(driver: Driver) -> Snapshot:
    """What is seen, whatever was sent to get there."""
    return replace(driver.session.snapshot(), acknowledged=0, revision=0)


@pytest.mark.parametrize("ticks", [0, 3])
def test_a_pick_that_is_done_again_at_once_is_as_if_it_had_never_been_taken_back(ticks: int) -> None:
    driver = lesson().pick("up").advance(3).pick("down").advance(ticks)
    before, examples = looks(driver), driver.examples
    driver.undo().redo()
    assert (looks(driver), driver.examples) == (before, examples)
    assert driver.advance(2).state() == "down"


def test_a_pick_that_is_done_again_later_lets_the_node_do_what_it_did_then() -> None:
    driver = lesson().pick("up").advance(3).pick("signal").advance(2)
    inside = driver.state()
    driver.undo().advance(4).redo()
    assert driver.state() == inside
    assert driver.advance().place() == 3.0 + 2.0 + 4.0 + 1.0


def test_a_pick_that_no_tick_had_carried_out_is_carried_out_once_it_is_done_again() -> None:
    driver = lesson().pick("up").advance(3).pick("down").undo().advance(2).redo()
    assert driver.state() == "up"
    assert driver.advance().state() == "down"
    assert driver.undo().state() == "up"


def test_picks_are_done_again_one_by_one_and_can_be_taken_back_again() -> None:
    driver = lesson().pick("up").advance().pick("jump").advance().pick("down").advance()
    taught = driver.taught
    for _ in range(2):
        for _ in range(3):
            driver.undo()
        assert (driver.taught, driver.state()) == ([], START)
        states = [driver.redo().state() for _ in range(3)]
        assert (states, driver.taught) == (["up", "jump", "down"], taught)


def test_a_state_that_a_pick_added_comes_back_with_it_and_the_node_in_it() -> None:
    driver = Driver().teach("agent-1", "Seek", target="lamp").pick("Up").advance(2).undo()
    assert not driver.automaton.has_state("up")
    driver.redo()
    assert (driver.state(), driver.automaton.has_state("up")) == ("up", True)


def test_a_correction_that_is_done_again_takes_the_node_out_of_the_test_again() -> None:
    driver = in_a_test().pick("jump", "agent-2").advance(2).undo().redo()
    assert (driver.view("agent-2").taught, driver.state("agent-2")) == (True, "jump")
    driver.undo()
    assert not driver.view("agent-2").taught


def test_should_not_have_left_is_done_again_too() -> None:
    driver = lesson().pick("up").advance(3).pick("down").advance(2).test().advance(6)
    taught = driver.should_not_have_left().taught
    driver.undo().redo()
    assert (driver.taught, driver.view().taught) == (taught, True)
    assert "left no state by itself" in driver.refused(ShouldNotHaveLeft("agent-1"))


def test_of_a_pick_of_before_the_test_only_the_examples_come_back() -> None:
    driver = lesson().pick("up").advance(3).pick("down").advance(2)
    taught = driver.taught
    driver.undo().test().advance(2)
    was = driver.state()
    driver.redo()
    assert (driver.taught, driver.state(), driver.view().taught) == (taught, was, False)


def test_a_pick_for_a_controller_that_is_done_again_lets_all_below_it_do_what_they_did() -> None:
    driver = Driver(arm="groups").teach("group-1", "Lead").pick("signal").advance(2).pick("down").advance(2)
    below = [driver.view(agent).basic for agent in ("agent-1", "agent-2")]
    driver.undo().redo()
    assert driver.state("group-1") == "down"
    assert [driver.view(agent).basic for agent in ("agent-1", "agent-2")] == below


@pytest.mark.parametrize("between", ["another pick", "another lesson", "changed examples"])
def test_nothing_is_done_again_once_something_else_was_taught(between: str) -> None:
    driver = lesson().pick("up").advance().pick("down").advance().undo()
    match between:
        case "another pick":
            driver.pick("jump")
        case "another lesson":
            driver.teach("agent-1", "Shuttle")
        case _:
            driver.edit(disable_examples, "agent", "Shuttle", ["1"])
    taught = driver.taught
    assert "was taken back and could be done again" in driver.refused(RedoPick())
    assert driver.taught == taught


def test_a_pick_whose_state_is_gone_is_not_done_again() -> None:
    driver = lesson().pick("jump").advance().pick(START).undo().undo()
    driver.edit(remove_state, "agent", "Shuttle", "jump")
    before = driver.session.project
    driver.refused(RedoPick())
    assert driver.session.project is before
