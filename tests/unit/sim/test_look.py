"""How a scenario says what its worlds look like, and what it cannot say."""

from dataclasses import dataclass
from typing import Any

import pytest

from app.core.errors import ScenarioError
from app.sim.look import SettledLook, settled
from app.sim.scenario import Column, Kind, Look, Scenario, quantity
from app.sim.scenarios.foraging import scenario as foraging


@dataclass(frozen=True, slots=True)
class Parameters:
    size: float = quantity(1.5, "units", 0.0, 2.0)
    reach: float = quantity(4.0, "units", 0.0, 9.0)
    word: str = quantity("a", choices=("a", "b"))


def scenario(look: Look | None) -> Scenario:
    kinds = (Kind("lamp", 1, radius="size"), Kind("wall", 2, radius=0.5))
    return Scenario(
        "test", "Test", Parameters, kinds, (Column("held", whole=True), Column("dose")), look=look
    )


def settle(look: Look | None) -> SettledLook:
    made = scenario(look)
    return settled(made.look, made.kinds, made.settle({}))


def test_foraging_looks_as_its_parameters_say() -> None:
    look = settled(foraging.look, foraging.kinds, foraging.settle({"width": 300.0, "sight": 12.0}))
    assert (look.width, look.height) == (300.0, 200.0)
    assert look.diameters == {"agent": 1.0, "box": 5.0, "deposit": 0.0}
    assert look.ranges["agent"] == {"sight": 12.0, "grab_range": 5.0}
    assert look.ranges["deposit"] == {"deposit_range": 5.0}
    assert (look.held, look.loads, look.got, look.needed) == ("held", "box", "pulling", "needed")
    assert look.places == ("deposit",)


def test_without_a_look_entities_are_as_large_as_their_kinds_say() -> None:
    assert settle(None) == SettledLook(diameters={"agent": 0.0, "lamp": 3.0, "wall": 1.0})


def test_a_diameter_counts_more_than_the_radius_of_the_kind() -> None:
    assert settle(Look(diameters={"lamp": "reach"})).diameters == {"agent": 0.0, "lamp": 4.0, "wall": 1.0}


@pytest.mark.parametrize(
    ("named", "message"),
    [
        ({"width": "breadth"}, "look: width is 'breadth', but there is no such parameter that is a number; "),
        ({"height": "word"}, "look: height is 'word', but there is no such parameter that is a number; "),
        (
            {"held": "dose"},
            "look: held is 'dose', but there is no such column of whole numbers; there are: held",
        ),
        (
            {"loads": "boxes"},
            "look: loads is 'boxes', but there is no such kind of entity; there are: agent, lamp, wall",
        ),
        ({"places": ("hole",)}, "one of places, is 'hole', but there is no such kind of entity"),
        ({"diameters": {"door": "size"}}, "a key of diameters or ranges, or one of places, is 'door'"),
        ({"ranges": {"lamp": ("word",)}}, "a diameter or range is 'word', but there is no such parameter"),
    ],
)
def test_a_look_that_names_what_there_is_not_is_refused(named: dict[str, Any], message: str) -> None:
    with pytest.raises(ScenarioError) as refused:
        scenario(Look(**named))
    assert message in str(refused.value)
