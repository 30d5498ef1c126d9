"""Worlds as columns: how they begin, and how they are copied and put back."""

import json
import re
from math import inf, nan
from typing import Any

import numpy as np
import pytest

from app.core.chance import world_key
from app.core.errors import ParameterError, ScenarioError
from app.core.hierarchy import from_table
from app.sim.scenarios.foraging import scenario as foraging
from app.sim.world import FrozenWorld, as_arrays, empty_world, freeze, new_world, spans, thaw
from tests.chase import scenario as chase
from tests.foragers import alone, groups


def world(seed: int = 1, number: int = 0, agents: int = 3, **parameters: Any) -> Any:
    return new_world(foraging, foraging.settle(parameters), alone(agents), seed, number)


def frozen(**begin: Any) -> FrozenWorld:
    return freeze(world(**begin), foraging)


# ---------------------------------------------------------------------------------------------- beginning


def test_agents_come_first_then_each_kind_in_its_order() -> None:
    assert spans(world(boxes=2), foraging) == {"agent": range(3), "box": range(3, 5), "deposit": range(5, 6)}


def test_columns_are_as_long_as_there_are_entities_or_hold_one_number() -> None:
    fresh = world(boxes=2)
    assert {len(getattr(fresh, column.name)) for column in foraging.columns} == {6, 1}
    assert len(fresh.boxes_delivered) == 1


def test_columns_begin_with_their_initial_values() -> None:
    empty = empty_world(foraging, foraging.settle({}), alone(2))
    assert empty.held[:2] == [-1, -1]
    assert empty.progressed == [-1]
    assert {type(value) for value in empty.held} == {int}
    assert {type(value) for value in empty.x} == {float}


def test_members_and_groups_come_from_the_forest() -> None:
    empty = empty_world(foraging, foraging.settle({}), groups(2, 3))
    assert empty.members[:6] == list(range(6))
    assert empty.group_size[:6] == [3] * 6


def test_a_word_is_its_place_among_the_choices() -> None:
    assert world(placement="ring", release="anyone").params[-3:] == (1, 70.0, 0)


def test_the_clock_holds_seed_world_tick_and_key() -> None:
    assert world(seed=7, number=3).clock == [7, 3, 0, world_key(7, 3)]


def test_the_same_seed_and_number_give_the_same_world() -> None:
    assert frozen(seed=5, number=2) == frozen(seed=5, number=2)


@pytest.mark.parametrize("other", [{"seed": 6}, {"number": 1}])
def test_another_seed_or_number_gives_another_world(other: dict[str, int]) -> None:
    assert frozen(**{"seed": 5, **other})["x"] != frozen(seed=5)["x"]


def test_seed_and_number_are_not_interchangeable() -> None:
    assert frozen(seed=2, number=3)["x"] != frozen(seed=3, number=2)["x"]


@pytest.mark.parametrize("seed", [0, 2**63 - 1])
def test_seeds_run_up_to_63_bits(seed: int) -> None:
    assert frozen(seed=seed)["clock"][0] == seed


@pytest.mark.parametrize(
    ("begin", "message"), [({"seed": -1}, "a seed is"), ({"number": 2**63}, "a world number is")]
)
def test_other_seeds_are_refused(begin: dict[str, int], message: str) -> None:
    with pytest.raises(
        ParameterError, match=message + r" a whole number from 0 to 9,223,372,036,854,775,807, but"
    ):
        world(**begin)


def test_agents_begin_all_over_the_arena() -> None:
    xs = frozen(agents=200)["x"][:200]
    assert min(xs) < 20
    assert max(xs) > 180
    assert 80 < sum(xs) / len(xs) < 120


def test_boxes_begin_where_they_did_however_many_there_are() -> None:
    few, many = frozen(boxes=2), frozen(boxes=5)
    assert few["x"][3:5] == many["x"][3:5]


# ------------------------------------------------------------------------------------- copying and putting back


def test_a_copy_does_not_follow_the_world() -> None:
    running = world()
    copy = freeze(running, foraging)
    running.x[0] += 1.0
    assert copy["x"][0] != running.x[0]


def test_what_was_copied_can_be_put_back() -> None:
    running = world()
    copy = freeze(running, foraging)
    running.x[0], running.held[1], running.clock[2], running.progressed[0] = 3.0, 4, 99, 12
    thaw(running, copy, foraging)
    assert freeze(running, foraging) == copy


def stored(copy: FrozenWorld) -> dict[str, Any]:
    """A copy that went through JSON."""
    loaded: dict[str, Any] = json.loads(json.dumps(copy))
    return loaded


def arrays(copy: FrozenWorld) -> dict[str, Any]:
    """A copy that went through files of arrays."""
    return {name: np.array(values) for name, values in copy.items()}


@pytest.mark.parametrize("through", [stored, arrays])
def test_what_comes_back_from_files_is_plain_numbers_again(through: Any) -> None:
    running, copy = world(), frozen()
    thaw(running, through(copy), foraging)
    assert freeze(running, foraging) == copy
    assert {type(value) for value in running.x} == {float}
    assert {type(value) for value in running.held} == {type(value) for value in running.clock} == {int}


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        ({"y": None}, "a stored world of 'foraging': column 'y' is missing, not 14 long"),
        ({"y": (1.0,)}, "a stored world of 'foraging': column 'y' is 1 long, not 14 long"),
        (
            {"y": (1.0,) * 13 + (float("nan"),)},
            "scenario 'foraging': column 'y' holds finite numbers, but entry 13 is nan",
        ),
        ({"held": (0.5,) * 14}, "scenario 'foraging': column 'held' holds whole numbers, but entry 0 is 0.5"),
        ({"held": ("a",) * 14}, "scenario 'foraging': column 'held' holds whole numbers, but entry 0 is 'a'"),
        ({"clock": (1, 2, 3)}, "a stored world of 'foraging': column 'clock' is 3 long, not 4 long"),
    ],
)
def test_a_damaged_copy_is_refused_and_changes_nothing(spoil: dict[str, Any], message: str) -> None:
    running, copy = world(), {**frozen(seed=2), **spoil}
    before = freeze(running, foraging)
    with pytest.raises(ScenarioError) as error:
        thaw(running, {name: values for name, values in copy.items() if values is not None}, foraging)
    assert str(error.value) == message
    assert freeze(running, foraging) == before


def test_a_copy_of_another_scenario_is_refused() -> None:
    other = freeze(new_world(chase, chase.settle({}), from_table((3,), ("hound",)), 1), chase)
    with pytest.raises(ScenarioError, match="a stored world of 'foraging': column"):
        thaw(world(), other, foraging)


# -------------------------------------------------------------------------------------------------- as arrays

#: What a scenario may have put somewhere.
ENTRIES = (
    0.5,
    1,
    True,
    2**53 + 1,
    2**63 - 1,
    2**63,
    -(2**63),
    2.0**53,
    -(2**60),
    1e300,
    nan,
    inf,
    "3",
    None,
    1j,
    [1.0],
    np.float64(2),
    np.float32(0.1),
)


@pytest.mark.parametrize("entry", ENTRIES, ids=repr)
@pytest.mark.parametrize("column", ["x", "held", "boxes_delivered", "progressed"])
def test_as_arrays_a_world_is_the_same_as_its_copy_or_refused_alike(column: str, entry: Any) -> None:
    spoiled = world()
    getattr(spoiled, column)[-1] = entry
    try:
        wanted = freeze(spoiled, foraging)
    except ScenarioError as error:
        with pytest.raises(ScenarioError, match=re.escape(str(error))):
            as_arrays(spoiled, foraging)
    else:
        found = as_arrays(spoiled, foraging)
        assert {name: tuple(numbers.tolist()) for name, numbers in found.items()} == wanted
        kinds = {name: {type(number) for number in numbers.tolist()} for name, numbers in found.items()}
        assert kinds == {name: set(map(type, numbers)) for name, numbers in wanted.items()}
