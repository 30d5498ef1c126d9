"""What a hand does in a lesson can be kept as a demonstration, which records the same examples when it is played."""

from collections.abc import Callable
from dataclasses import replace

import pytest

from app.core.automaton import Automaton
from app.core.edits import (
    add_demonstration,
    delete_automaton,
    disable_examples,
    note_state,
    remove_state,
)
from app.core.edits.arms import replace_arm
from app.engine import commands
from app.engine.commands import AskMe, GoTo, MoveEntities, Others, Pick, RedoMove, RunArm, UndoMove
from app.engine.demonstrations import recreate
from app.engine.transcript import Transcript
from tests.corridor import AT_END, corridor, project
from tests.driver import Driver
from tests.samples import AGENT, automaton, state
from tests.unit.engine.kept_lessons import (
    SHUTTLE,
    TOWARD,
    acts,
    check,
    kept,
    learned,
    lesson,
    problems,
)


def test_picks_are_played_again() -> None:
    driver = lesson().pick("up").advance(5).pick("down").advance(3)
    assert acts(driver) == ["0 teach agent-1", "0 pick agent-1 up", "5 pick agent-1 down"]
    assert kept(driver).ticks == 6  # nothing came after that
    check(driver)


def test_a_lesson_that_begins_while_the_arm_runs_is_played_from_the_worlds_beginning() -> None:
    driver = Driver().advance(7).teach("agent-1", "Shuttle", Others.RUN, "shuttle-1")
    driver.advance(2).pick("up").advance(5).pick("down")
    assert acts(driver)[:2] == ["7 teach agent-1", "9 pick agent-1 up"]
    assert kept(driver).others == "run"
    check(driver)


def test_several_are_taught_in_turn() -> None:
    driver = lesson(("agent-1", "agent-2")).pick("up").pick("down", "agent-2").advance(3)
    check(driver.pick("down", "agent-1"))


def test_seed_parameters_and_arguments_are_kept() -> None:
    driver = Driver(seed=5, length=60.0).teach("agent-1", "Seek", demonstration="seek-1", target="lamp")
    driver.pick("Up").advance(4).pick("Down").advance()
    made = kept(driver)
    assert (made.seed, made.parameters, made.arguments) == (5, {"length": 60.0}, {"target": "lamp"})
    check(driver, (AGENT, "Seek"))


def test_a_pick_that_was_taken_back_or_replaced_leaves_the_same_examples() -> None:
    driver = lesson().pick("up").advance(3).pick("down").advance(2).undo().advance(2)
    assert acts(driver) == ["0 teach agent-1", "0 pick agent-1 up"]  # what came after left nothing
    check(driver.pick("jump").pick("down").advance())


def test_a_pick_that_no_tick_has_carried_out_leaves_no_trace() -> None:
    driver = lesson().pick(TOWARD).pick("down").advance(3).pick(TOWARD).undo().pick("up").advance()
    assert acts(driver)[1:] == ["0 pick agent-1 down", "3 pick agent-1 up"]
    assert kept(driver).removed == ()
    check(driver)


def test_a_state_that_went_with_its_pick_is_there_again_while_that_is_played() -> None:
    driver = lesson().pick(TOWARD).advance(3).undo().pick(TOWARD).advance(2).pick("down").advance()
    assert acts(driver)[1:] == [
        "0 pick agent-1 toward",
        "3 undo",
        "3 pick agent-1 toward",
        "5 pick agent-1 down",
    ]
    check(driver)
    driver = lesson().pick("up").advance().pick(TOWARD).advance(3).undo().pick("down").advance()
    (gone,) = kept(driver).removed
    assert (gone.id, gone.content) == ("toward", TOWARD)
    assert problems(driver) == []
    check(driver)


def test_a_lesson_is_played_again_after_one_of_its_states_was_removed() -> None:
    driver = lesson().pick("up").advance(5).pick(TOWARD).advance(3).pick("down").advance(2).run()
    driver.edit(add_demonstration, kept(driver)).edit(remove_state, *SHUTTLE, "toward")
    (demonstration,) = driver.project.demonstrations
    assert [state.id for state in demonstration.removed] == ["toward"]
    assert not all(example.enabled for example in driver.examples)
    assert problems(driver) == []
    again = recreate(driver.project, corridor)
    assert again.examples_of(*SHUTTLE) == driver.examples
    assert again.demonstrations == driver.project.demonstrations
    assert not again.library(AGENT).get("Shuttle").has_state("toward")


def test_what_was_picked_before_a_test_is_taken_back_before_it_is_learned_from() -> None:
    driver = lesson().pick("up").advance(4).pick("down").advance(2).pick("up").advance(2)
    driver.send(commands.Test()).undo().advance().advance(9).pick("up", "agent-2").advance(2)
    assert [word.split()[1] for word in acts(driver)][-3:] == ["undo", "test", "pick"]
    check(driver)


@pytest.mark.parametrize("ticks", [0, 2])
def test_picks_that_are_done_again_at_once_were_never_taken_back(ticks: int) -> None:
    driver = lesson().pick("up").advance(3).pick(TOWARD).advance(ticks)
    before = acts(driver)
    driver.undo().undo().redo().redo()
    assert acts(driver) == before
    check(driver.advance().pick("down").advance())


def test_when_all_is_taken_back_there_is_nothing_to_keep() -> None:
    driver = lesson().pick("up").advance().undo()
    assert driver.demonstration is None


def test_a_test_with_corrections_is_played_again() -> None:
    driver = lesson().pick("up").advance(4).pick("down").advance(4).test().advance(9)
    driver.pick("jump", "agent-2").advance(3)
    assert "8 test" in acts(driver)
    check(driver)


def test_should_not_have_left_is_played_again() -> None:
    driver = Driver(project(pacer())).teach("agent-1", "Pacer", demonstration="pacer-1")
    driver.pick("up").advance(4).pick("down").advance(3).test().advance(30)
    driver.should_not_have_left("agent-1").advance(2)
    check(driver, (AGENT, "Pacer"))


def pacer() -> Automaton:
    return automaton("Pacer", state("up", "Up"), state("down", "Down"), features=(AT_END,))


def test_what_is_learned_in_the_background_during_a_test_is_learned_when_it_is_played() -> None:
    driver = lesson().pick("up").advance(4).pick("down").advance(4).test().advance(3)
    driver.pick("jump", "agent-2").advance(2)
    driver.edit(learned).advance(6).pick("up", "agent-1")
    assert "13 learn" in acts(driver)
    check(driver)


def test_an_answer_is_played_as_one() -> None:
    waver = automaton("Waver", state("up", "Up"), state("down", "Down"), features=(AT_END,))
    driver = Driver(project(waver)).teach("agent-1", "Waver", demonstration="waver-1")
    driver.pick("up").advance(2).pick("down").advance(2).test()
    driver.send(AskMe(("agent-1",), 0.9, None)).advance(10)
    assert driver.snapshot.asked is not None
    driver.send(Pick("agent-1", "down"))
    driver.send(AskMe()).advance(5).pick("up", "agent-1")
    assert "5 answer agent-1 down" in acts(driver)
    check(driver, (AGENT, "Waver"))


def test_teaching_goes_on_after_a_test() -> None:
    driver = lesson().pick("up").advance(4).pick("down").advance(2).test().advance(3)
    driver.teach("agent-2", "Shuttle", demonstration="shuttle-1").pick("down").advance(2)
    assert acts(driver)[-2:] == ["9 teach agent-2", "9 pick agent-2 down"]
    check(driver)


def test_what_was_moved_before_and_in_a_lesson_is_moved_again() -> None:
    driver = (
        Driver()
        .send(RunArm())
        .send(MoveEntities({1: (7.0, 0.0)}))
        .advance(3)
        .send(MoveEntities({0: (2.0, 0.0)}))
    )
    driver.teach("agent-1", "Shuttle", demonstration="shuttle-1").pick("up").advance(4)
    driver.send(MoveEntities({0: (3.0, 0.0)})).pick("down").advance(2).send(MoveEntities({0: (9.0, 0.0)}))
    moved = [(act.tick, act.entity, act.x, act.y) for act in kept(driver).picks if act.act == "move"]
    # What comes after the last pick is no part.
    assert moved == [(0, 1, 7.0, 0.0), (3, 0, 2.0, 0.0), (7, 0, 3.0, 0.0)]
    assert problems(driver) == []
    check(driver)


def test_a_move_that_is_undone_at_once_was_never_made_and_one_done_again_was() -> None:
    driver = (
        lesson()
        .pick("up")
        .advance(4)
        .send(MoveEntities({0: (3.0, 0.0)}))
        .send(UndoMove(1))
        .pick("down")
        .advance()
    )
    assert "4 move" not in acts(driver)
    driver = (
        lesson().pick("up").advance(4).send(MoveEntities({0: (3.0, 0.0)})).send(UndoMove(1)).send(RedoMove(1))
    )
    driver.pick("down").advance()
    assert "4 move" in acts(driver)
    check(driver)


def test_several_that_were_moved_at_once_are_kept_as_moves_of_one_tick_and_undone_as_one() -> None:
    both = MoveEntities({0: (3.0, 0.0), 1: (9.0, 0.0)})
    driver = lesson().pick("up").advance(4).send(both).pick("down").advance()
    moved = [(act.tick, act.entity, act.x) for act in kept(driver).picks if act.act == "move"]
    assert moved == [(4, 0, 3.0), (4, 1, 9.0)]
    check(driver)
    driver = lesson().pick("up").advance(4).send(both).send(UndoMove(1)).pick("down").advance()
    assert "4 move" not in acts(driver)
    check(driver)


def test_a_move_before_the_run_was_gone_back_in_is_not_played() -> None:
    driver = Driver().send(RunArm()).advance(5).send(MoveEntities({0: (3.0, 0.0)})).send(GoTo(2)).advance(3)
    driver.teach("agent-1", "Shuttle", demonstration="shuttle-1").pick("up").advance()
    assert "gone back in" in driver.obstacle


def test_other_physics_are_not_what_a_demonstration_is_played_with() -> None:
    assert "rigid" in Transcript("alone", 1, {"physics": "rigid", "engine": "auto"}).obstacle
    assert not Transcript("alone", 1, {"physics": "kinematic", "world.length": 5.0}).obstacle


@pytest.mark.parametrize(
    ("spoil", "why"),
    [
        (lambda d: [d.send(MoveEntities({0: (40.0, 0.0)})).advance(), d.send(UndoMove(1))], "moved back"),
        (lambda d: d.pick("down").undo().advance().redo().pick("up"), "replaced at once"),
        (lambda d: d.reset(2), "begun again"),
        (lambda d: d.edit(note_state, *SHUTTLE, "up", "a note"), "behaviors were changed"),
        (lambda d: d.edit(disable_examples, *SHUTTLE, ["1"]), "examples were changed"),
        (lambda d: d.edit(lambda p: replace_arm(p, "alone", replace(p.arms[0], note="x"))), "the arm was"),
        (lambda d: d.run().teach("agent-1", "Shuttle", demonstration="shuttle-1"), "taught in before"),
        (lambda d: d.teach("agent-1", "Seek", demonstration="s", target="lamp"), "taught in before"),
    ],
)
def test_what_playing_would_not_repeat_is_said(spoil: Callable[[Driver], object], why: str) -> None:
    driver = lesson().pick("up").advance(2)
    spoil(driver)
    choice = "Up" if driver._lesson[1] == "Seek" else "down"
    driver.pick(choice)
    assert why in driver.obstacle
    lesson_view = driver.snapshot.lesson
    assert lesson_view is not None
    assert lesson_view.obstacle == driver.obstacle


def test_a_lesson_in_which_nothing_was_done_does_not_keep_the_next_from_being_kept() -> None:
    driver = Driver().teach("agent-1", "Shuttle", demonstration="shuttle-1").run()
    driver.teach("agent-1", "Seek", demonstration="s", target="lamp").pick("Up").advance()
    check(driver, (SHUTTLE[0], "Seek"))


def test_another_world_can_be_taught_in_again() -> None:
    driver = lesson().pick("up").advance(2).run().reset()
    driver.teach("agent-1", "Shuttle", demonstration="shuttle-2").pick("down").advance()
    assert kept(driver).picks[0].tick == 0


def test_what_was_taught_can_be_deleted_and_come_back() -> None:
    driver = lesson().pick("up").advance(2)
    before = driver.project
    driver.edit(delete_automaton, *SHUTTLE)
    assert "the lesson is over" in driver.interruptions[-1]
    driver.edit(lambda _: before).teach("agent-1", "Shuttle", demonstration="shuttle-2").pick("up")
    assert "in the middle of the lesson" in driver.obstacle


def test_notes_on_the_project_are_no_obstacle() -> None:
    driver = lesson().pick("up").advance(2).edit(lambda p: replace(p, note="a note")).pick("down")
    check(driver)
