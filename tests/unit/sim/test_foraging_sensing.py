"""Foraging: features and targets."""

from math import pi

import pytest

from app.core.hierarchy import Hierarchy, Node
from app.core.vocabulary import NO_ENTITY
from tests.arena import Arena
from tests.foragers import BIGGEST, BOX, CLOSEST, DEPOSIT, squads
from tests.samples import AGENT, GROUP, SQUAD

# ------------------------------------------------------------------------------------------------ features


def test_distances_are_center_to_center() -> None:
    arena = Arena()
    arena.place(0, 97.0, 96.0)
    assert arena.sees("DistanceTo", 0, arena.world.first_deposit) == 5.0


@pytest.mark.parametrize(
    ("heading", "direction"), [(0.0, pi / 2), (90.0, 0.0), (120.0, -pi / 6), (-120.0, -5 * pi / 6)]
)
def test_directions_are_in_the_agents_frame_positive_to_the_left(heading: float, direction: float) -> None:
    arena = Arena()
    arena.place(0, 100.0, 80.0, heading)
    assert arena.sees("DirectionTo", 0, arena.world.first_deposit) == pytest.approx(direction)


def test_what_lies_straight_behind_is_at_minus_pi() -> None:
    arena = Arena()
    arena.place(0, 120.0, 100.0)
    assert arena.sees("DirectionTo", 0, arena.world.first_deposit) == -pi


def test_the_direction_to_where_one_stands_is_a_number() -> None:
    arena = Arena()
    arena.place(0, 100.0, 100.0)
    assert arena.sees("DirectionTo", 0, arena.world.first_deposit) == 0.0


@pytest.mark.parametrize(("gap", "seen"), [(9.9, 1.0), (10.0, 1.0), (10.1, 0.0)])
def test_a_box_is_seen_within_10_units(gap: float, seen: float) -> None:
    arena = Arena()
    arena.place(0, 50.0, 50.0)
    arena.place_box(0, 50.0 + gap, 50.0)
    assert arena.sees("ICanSeeABox") == seen
    assert arena.means(BOX) == (arena.box() if seen else NO_ENTITY)


def test_a_box_is_seen_only_while_it_still_needs_pullers() -> None:
    arena = Arena(3, pullers=2)
    arena.place(0, 50.0, 50.0)
    arena.place_box(0, 51.0, 50.0, 1)
    assert arena.sees("ICanSeeABox") == 1.0
    arena.place_box(0, 51.0, 50.0, 1, 2)
    assert arena.sees("ICanSeeABox") == 0.0


def test_an_agent_knows_whether_it_is_attached() -> None:
    arena = Arena(2)
    arena.place_box(0, 50.0, 50.0, 1)
    assert [arena.sees("IAmAttachedToABox", agent) for agent in range(2)] == [0.0, 1.0]


def test_an_agent_knows_whether_its_box_has_all_it_needs() -> None:
    arena = Arena(3, pullers=2)
    arena.place_box(0, 50.0, 50.0, 0)
    assert [arena.sees("MyBoxMoves", agent) for agent in range(3)] == [0.0, 0.0, 0.0]
    arena.place_box(0, 50.0, 50.0, 0, 1)
    assert [arena.sees("MyBoxMoves", agent) for agent in range(3)] == [1.0, 1.0, 0.0]


# ------------------------------------------------------------------------------------- someone needs help

#: Two agents under a group of two, three under a group of three, one under the squad itself, one on its own.
UNEVEN = Hierarchy(
    (
        Node(
            "squad",
            SQUAD,
            (
                Node("pair", GROUP, (Node("a", AGENT), Node("b", AGENT))),
                Node("trio", GROUP, (Node("c", AGENT), Node("d", AGENT), Node("e", AGENT))),
                Node("f", AGENT),
            ),
        ),
        Node("g", AGENT),
    )
)


def needs_help(arena: Arena, first: int, end: int) -> bool:
    return arena.engine.senses.group_feature("SomeoneNeedsHelp", range(first, end)) == 1.0


def test_group_sizes_are_those_of_the_level_1_groups() -> None:
    assert Arena(UNEVEN).world.group_size[:7] == [2, 2, 3, 3, 3, 1, 1]


@pytest.mark.parametrize(
    ("holder", "needed", "calls"), [(0, 2, False), (0, 3, True), (3, 3, False), (3, 4, True), (5, 2, True)]
)
def test_who_holds_a_box_that_needs_more_than_its_group_has_needs_help(
    holder: int, needed: int, calls: bool
) -> None:
    arena = Arena(UNEVEN, pullers=needed)
    arena.place_box(0, 50.0, 50.0, holder)
    assert needs_help(arena, 0, 6) is calls


def test_help_is_needed_even_when_the_box_is_full() -> None:
    arena = Arena(UNEVEN, pullers=3)
    arena.place_box(0, 50.0, 50.0, 0, 1, 2)
    assert needs_help(arena, 0, 2)


def test_controllers_hear_only_of_those_below() -> None:
    arena = Arena(UNEVEN, pullers=3)
    arena.place_box(0, 50.0, 50.0, 0)
    assert needs_help(arena, 0, 2)
    assert not needs_help(arena, 2, 5)


def test_nobody_needs_help_without_a_box() -> None:
    assert not needs_help(Arena(UNEVEN), 0, 6)


# ------------------------------------------------------------------------------------------------ targets


def test_the_nearest_visible_box_is_the_nearest_that_still_needs_pullers() -> None:
    arena = Arena(3, boxes=3, pullers=2)
    arena.place(0, 50.0, 50.0)
    arena.place_box(0, 58.0, 50.0)
    arena.place_box(1, 50.0, 45.0)
    arena.place_box(2, 51.0, 50.0, 1, 2)
    assert arena.means(BOX) == arena.box(1)


def test_of_equally_near_boxes_the_first_is_meant() -> None:
    arena = Arena(1, boxes=2)
    arena.place(0, 50.0, 50.0)
    arena.place_box(0, 53.0, 50.0)
    arena.place_box(1, 50.0, 53.0)
    assert arena.means(BOX) == arena.box(0)


def test_the_deposit_is_meant_from_anywhere() -> None:
    arena = Arena()
    assert arena.means(DEPOSIT) == arena.world.first_deposit


def attached_squad() -> Arena:
    """Agents 0 to 7 in two groups of two under each of two squads; 1, 3 and 6 hold boxes, 3 and 6 big ones."""
    arena = Arena(squads(2, 2, 2), boxes=4, big_boxes=2)
    for agent in range(8):
        arena.place(agent, 10.0 * agent, 50.0)
    arena.place_box(2, 10.0, 50.0, 1)
    arena.place_box(0, 30.0, 50.0, 3)
    arena.place_box(1, 60.0, 50.0, 6)
    return arena


@pytest.mark.parametrize(
    ("performer", "owner", "meant"),
    [
        (0, range(4), 1),
        (2, range(4), 1),
        (2, range(2, 4), 3),
        (5, range(4, 8), 6),
        (4, range(4, 6), NO_ENTITY),
    ],
)
def test_the_closest_attached_agent_is_the_nearest_in_the_owners_subtree(
    performer: int, owner: range, meant: int
) -> None:
    assert attached_squad().means(CLOSEST, performer, owner) == meant


def test_there_is_no_closest_attached_agent_for_one_that_is_attached() -> None:
    assert attached_squad().means(CLOSEST, 1, range(4)) == NO_ENTITY


@pytest.mark.parametrize(
    ("performer", "owner", "meant"),
    [(0, range(4), 3), (1, range(4), 3), (0, range(2), 1), (7, range(4, 8), 6), (4, range(4, 6), NO_ENTITY)],
)
def test_the_biggest_attached_agent_holds_the_box_that_needs_most(
    performer: int, owner: range, meant: int
) -> None:
    assert attached_squad().means(BIGGEST, performer, owner) == meant


def test_there_is_no_biggest_attached_agent_for_one_that_holds_such_a_box() -> None:
    assert attached_squad().means(BIGGEST, 3, range(4)) == NO_ENTITY


def test_of_several_with_the_biggest_box_the_nearest_is_meant() -> None:
    arena = attached_squad()
    assert arena.means(BIGGEST, 4, range(8)) == 3
    assert arena.means(BIGGEST, 5, range(8)) == 6
