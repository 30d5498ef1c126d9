"""Picks that were taken back, replaced or done again are kept as they were done."""

from app.engine.commands import MoveEntities
from tests.unit.engine.kept_lessons import TOWARD, acts, check, learned, lesson


def test_a_pick_that_is_done_again_later_than_it_was_taken_back_is_kept_as_such() -> None:
    driver = lesson().pick("up").advance(4).pick("down").advance(3).undo().advance(2).redo().advance()
    assert [act.split()[:2] for act in acts(driver)[-2:]] == [["7", "undo"], ["9", "redo"]]
    check(driver)
    driver.pick("up").advance(2)
    check(driver)
    driver.undo().undo().advance().redo().advance().redo().advance()
    check(driver)


def test_a_pick_that_was_taken_back_before_it_was_carried_out_and_done_again_later_is_kept() -> None:
    driver = lesson().pick("up").advance(4).pick("down").undo().advance(3).redo().advance()
    assert [act.split()[1] for act in acts(driver)[-3:]] == ["pick", "undo", "redo"]
    check(driver)
    driver = (
        lesson()
        .pick("up")
        .advance(4)
        .pick("down", "agent-1")
        .undo()
        .undo()
        .advance(2)
        .redo()
        .redo()
        .advance(2)
    )
    check(driver)


def test_what_was_done_again_later_can_be_taken_back_again() -> None:
    driver = lesson().pick("up").advance(2).pick("down").advance(2).undo().advance().redo().undo()
    check(driver)
    driver.advance().redo().advance(2).undo().advance()
    check(driver)


def test_a_pick_that_is_done_again_at_once_stands_before_what_was_moved_after_it() -> None:
    driver = lesson().pick("up").send(MoveEntities({0: (9.0, 0.0)})).undo().redo().advance()
    assert [act.split()[1] for act in acts(driver)] == ["teach", "pick"]  # the move came after the last pick
    check(driver)
    check(driver.pick("down").advance())


def test_a_pick_before_a_test_is_not_replaced_by_one_at_the_same_tick_in_it() -> None:
    driver = lesson().pick("up").advance(2).pick("down").test().pick("up").advance()
    assert [act.split()[1] for act in acts(driver)][-3:] == ["pick", "test", "pick"]
    check(driver)


def test_once_it_is_tested_too_a_pick_that_is_done_again_later_is_kept() -> None:
    driver = lesson().pick("up").advance(2).pick("down").advance(2).undo().advance().test().redo().pick("up")
    check(driver.advance(2))
    driver = lesson().pick("up").advance(4).pick("down").advance(4).test().advance(2).undo().advance(3)
    check(driver.redo().advance(2).pick("jump", "agent-2").advance(2))
    assert [act.split()[1] for act in acts(driver)][-4:] == ["test", "undo", "redo", "pick"]


def test_what_a_test_had_learned_is_not_as_if_it_had_never_been_picked() -> None:
    driver = lesson().pick("up").advance(2).pick("down").test().undo().pick("jump", "agent-2").advance(2)
    assert [act.split()[1] for act in acts(driver)][-4:] == ["pick", "test", "undo", "pick"]
    check(driver)
    driver = lesson().pick("up").advance(2).pick("down").advance(2).test().advance(1).pick("jump", "agent-2")
    driver.edit(learned).undo().advance(3).redo().pick("down", "agent-1").advance()
    check(driver)


def test_examples_are_numbered_as_they_were_where_a_pick_was_replaced_after_another_ones() -> None:
    driver = lesson(("agent-1", "agent-2")).pick("up").pick("down", "agent-2").pick("jump", "agent-1")
    assert [act.split()[1:3] for act in acts(driver)][2:] == [
        ["pick", "agent-1"],
        ["pick", "agent-2"],
        ["pick", "agent-1"],
    ]
    check(driver.advance())
    check(driver.undo().advance())


def test_who_is_taught_anew_at_the_same_tick_keeps_what_was_picked_before() -> None:
    driver = lesson().advance().pick("up").teach(("agent-1", "agent-2"), "Shuttle", demonstration="shuttle-1")
    check(driver.pick("down").advance(2))


def test_a_state_that_had_been_learned_and_went_in_the_test_is_an_obstacle_which_is_said() -> None:
    driver = lesson().pick("up").advance(2).pick(TOWARD).advance(2).test().advance().undo().pick("up")
    assert "a state that had been learned" in driver.obstacle


def test_what_was_done_again_later_is_followed_by_more() -> None:
    driver = (
        lesson().pick("up").advance(4).pick("down").advance(3).undo().advance(2).redo().pick("up").advance(3)
    )
    check(driver)
    driver.test().advance(3)
    check(driver)
