"""Moves by hand: told as events, undone exactly if no tick has passed, and done again."""

from copy import copy
from math import nan
from pathlib import Path

import pytest

from app.core.storage import load
from app.engine.commands import MoveEntities, RedoMove, Reset, UndoMove, UseArm
from app.engine.session import Session
from app.engine.snapshots import Moved, MovedEntity
from app.sim.scenario import Scenario, World
from app.sim.scenarios.foraging import scenario as foraging
from tests.corridor import corridor
from tests.driver import UNCOMPILED, Driver

LAMP = 2
FORAGING = Path(__file__).parents[3] / "projects" / "foraging"


def spoiled() -> Scenario:
    """The corridor, where who is dragged is nowhere."""
    scenario = copy(corridor)
    scenario.stages = {**corridor.stages, "moved": _lose}
    return scenario


def _lose(world: World, entity: int, x: float, _y: float) -> None:
    world.x[entity] = x * 1e308 * 10.0


def moved(driver: Driver, entity: int, x: float, y: float = 0.0) -> Moved:
    """Move; what the session told of it."""
    event = driver.send(MoveEntities({entity: (x, y)})).told[-1]
    assert isinstance(event, Moved)
    return event


def test_a_move_is_told_with_who_where_from_and_where_to() -> None:
    driver = Driver().advance(3)
    agent = MovedEntity(1, "agent", "Agent 2", (13.0, 0.0), (40.0, 0.0))
    assert moved(driver, 1, 40.0) == Moved((agent,), 1)
    lamp = MovedEntity(LAMP, "lamp", "lamp", (50.0, 0.0), (7.0, 2.0))
    assert moved(driver, LAMP, 7.0, 2.0) == Moved((lamp,), 2)


def test_several_are_moved_at_once_and_told_as_one_move() -> None:
    driver = Driver().advance(3)
    driver.send(MoveEntities({1: (40.0, 0.0), 0: (30.0, 0.0)}))
    (event,) = driver.told
    assert isinstance(event, Moved)
    assert (driver.place(1), driver.place(2)) == (30.0, 40.0)
    assert ([one.entity for one in event.entities], event.words) == ([1, 0], "2 agents")


def test_what_was_moved_is_said_by_its_name_or_how_many_there_were() -> None:
    driver = Driver()
    assert [moved(driver, entity, 9.0).words for entity in (0, LAMP)] == ["Agent 1", "lamp"]
    event = driver.send(MoveEntities({0: (1.0, 0.0), LAMP: (2.0, 0.0)})).told[-1]
    assert isinstance(event, Moved)
    assert event.words == "2 things"


def test_several_that_were_moved_at_once_are_taken_back_and_moved_again_at_once() -> None:
    driver = Driver().advance(3)
    before = driver.look()
    after = driver.send(MoveEntities({0: (30.0, 0.0), 1: (40.0, 0.0)})).look()
    assert driver.send(UndoMove(1)).look() == before
    assert driver.send(RedoMove(1)).look() == after
    driver.advance(4).send(UndoMove(1))
    assert (driver.place(1), driver.place(2)) == (3.0, 13.0)


def test_of_several_all_are_moved_or_none() -> None:
    driver = Driver().advance(3)
    before = driver.look()
    assert "there is no entity 9" in driver.refused(MoveEntities({0: (30.0, 0.0), 9: (1.0, 1.0)}))
    assert driver.look() == before


def test_a_move_of_nothing_is_refused() -> None:
    assert Driver().refused(MoveEntities({})) == "a move has to name what is moved"


def test_a_box_and_who_holds_it_are_put_back_to_where_each_was() -> None:
    driver = Driver(load(FORAGING), "independent, authored", scenario=foraging, pullers=1)
    while max(driver.snapshot.world["held"]) < 0:
        driver.advance(50)
    held = driver.snapshot.world["held"]
    box = int(max(held))
    agent = next(one for one in range(len(held)) if held[one] == box)
    before = _places(driver, box, agent)
    driver.send(MoveEntities({agent: (before[2] + 1.0, before[3]), box: (20.0, 30.0)}))
    driver.send(MoveEntities({49 if agent != 49 else 48: (5.0, 5.0)})).send(UndoMove(1))
    assert _places(driver, box, agent) == pytest.approx(before)


def _places(driver: Driver, *entities: int) -> list[float]:
    """Their places, x and y one after the other."""
    world = driver.snapshot.world
    return [float(world[axis][entity]) for entity in entities for axis in "xy"]


def test_a_move_undone_before_a_tick_leaves_the_world_exactly_as_it_was() -> None:
    driver = Driver().advance(3)
    before = driver.look()
    number = moved(driver, 0, 40.0).number
    driver.send(UndoMove(number))
    assert driver.look() == before


def test_several_moves_are_undone_exactly_one_after_the_other() -> None:
    driver = Driver().advance(3)
    looks, numbers = [driver.look()], []
    for place in (20.0, 30.0, 40.0):
        numbers.append(moved(driver, 0, place).number)
        looks.append(driver.look())
    for number in reversed(numbers):
        assert driver.look() == looks.pop()
        driver.send(UndoMove(number))
    assert driver.look() == looks.pop()


def test_a_move_undone_after_ticks_puts_the_entity_back_where_it_was() -> None:
    driver = Driver().advance(3)
    number = moved(driver, 0, 40.0).number
    driver.advance(4).send(UndoMove(number))
    assert (driver.place(1), driver.snapshot.tick, driver.place(2)) == (3.0, 7, 17.0)


def test_a_move_undone_after_another_puts_only_its_own_entity_back() -> None:
    driver = Driver().advance(3)
    first = moved(driver, 0, 40.0).number
    moved(driver, 1, 60.0)
    driver.send(UndoMove(first))
    assert (driver.place(1), driver.place(2)) == (3.0, 60.0)


def test_an_undone_move_is_done_again_and_can_be_undone_again() -> None:
    driver = Driver().advance(3)
    before = driver.look()
    number = moved(driver, 0, 40.0).number
    after = driver.look()
    driver.send(UndoMove(number)).send(RedoMove(number))
    assert driver.look() == after
    driver.send(UndoMove(number))
    assert driver.look() == before
    driver.advance().send(RedoMove(number))
    assert driver.place(1) == 40.0


def test_undo_and_redo_tell_of_no_move() -> None:
    driver = Driver()
    number = moved(driver, 0, 40.0).number
    driver.send(UndoMove(number)).send(RedoMove(number))
    assert len(driver.told) == 1


@pytest.mark.parametrize("command", [Reset(), UseArm("groups", UNCOMPILED)], ids=repr)
def test_moves_belong_to_their_world_and_keep_their_numbers(command: Reset | UseArm) -> None:
    driver = Driver()
    number = moved(driver, 0, 40.0).number
    driver.send(command)
    assert driver.refused(UndoMove(number)) == "there is no move 1 in this world; it has begun again since"
    assert moved(driver, 0, 5.0).number == number + 1


def test_what_is_undone_or_not_is_refused_the_other_way() -> None:
    driver = Driver()
    number = moved(driver, 0, 40.0).number
    assert driver.refused(RedoMove(number)) == "move 1 is not undone, so it cannot be done again"
    driver.send(UndoMove(number))
    assert driver.refused(UndoMove(number)) == "move 1 is undone already"


@pytest.mark.parametrize("entity", [-1, 3])
def test_an_entity_that_is_not_there_is_refused(entity: int) -> None:
    message = Driver().refused(MoveEntities({entity: (1.0, 1.0)}))
    assert message == f"there is no entity {entity}; there are: agent 0 to 1, lamp 2 to 2"


def test_in_a_lesson_moves_are_told_and_undone_as_well() -> None:
    driver = Driver().teach("agent-1", "Shuttle").pick("up").advance(3)
    before = driver.look()
    number = moved(driver, 0, 40.0).number
    driver.send(UndoMove(number))
    assert driver.look() == before


def test_a_failed_world_is_not_moved_in() -> None:
    driver = Driver(breaks=2)
    driver.session.advance(5)
    driver.session.events()
    assert "ZeroDivisionError" in driver.refused(MoveEntities({0: (1.0, 1.0)}))


def test_a_box_dragged_with_all_who_hold_it_comes_back_with_them() -> None:
    driver = Driver(load(FORAGING), "independent, authored", scenario=foraging, pullers=1)
    while max(driver.snapshot.world["held"]) < 0:
        driver.advance(50)
    before, box = driver.look(), int(max(driver.snapshot.world["held"]))
    number = moved(driver, box, 20.0, 30.0).number
    assert driver.look() != before
    driver.send(UndoMove(number))
    assert driver.look() == before


def test_a_move_that_spoils_the_world_is_refused_and_the_world_is_as_it_was() -> None:
    driver = Driver(scenario=spoiled()).advance(3)
    assert "holds finite numbers" in driver.refused(MoveEntities({0: (40.0, 0.0)}))
    assert driver.advance(2).place(1) == 5.0


def test_a_refused_move_leaves_bodies_as_they_are() -> None:
    moved_in, left_alone = (
        Session(load(FORAGING), foraging, "independent", 1, settings={"physics": "rigid", **UNCOMPILED})
        for _ in range(2)
    )
    for session in (moved_in, left_alone):
        session.advance(40)
    moved_in.send(MoveEntities({-1: (1.0, 1.0)}))
    moved_in.send(MoveEntities({0: (nan, 1.0)}))
    assert len(moved_in.events()) == 2
    assert moved_in.advance(60).world == left_alone.advance(60).world
