"""The parameters of foraging: defaults of the paper, the original code's arena, and what is refused."""

from typing import Any

import pytest

from app.core.errors import ParameterError
from app.core.hierarchy import Hierarchy
from app.sim.reference import ReferenceEngine
from app.sim.scenarios.foraging import scenario
from tests.arena import Arena
from tests.foragers import STRUCTURES, start

#: The original code's arena, as a project writes it down.
ORIGINAL: dict[str, Any] = {"deposit_x": 75.0, "deposit_y": 75.0, "grab_range": 14.0, "deposit_range": 10.0}


def test_the_defaults_are_the_papers() -> None:
    paper = {
        "width": 200.0,
        "height": 200.0,
        "step": 0.1,
        "turn_degrees": 2.0,
        "boxes": 10,
        "pullers": 5,
        "big_pullers": 25,
        "box_diameter": 5.0,
        "sight": 10.0,
        "grab_range": 5.0,
        "deposit_x": 100.0,
        "deposit_y": 100.0,
        "deposit_range": 5.0,
    }
    assert scenario.settle({}).items() >= paper.items()


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"walls": 4}, "scenario 'foraging' has no parameter 'walls'; there are: agent_diameter, "),
        ({"boxes": -1}, "boxes must be 0 or more, but it is -1"),
        ({"boxes": 2.5}, "boxes takes a whole number, but it is 2.5"),
        ({"boxes": True}, "boxes takes a whole number, but it is True"),
        ({"boxes": "ten"}, "boxes takes a whole number, but it is 'ten'"),
        ({"boxes": None}, "boxes takes a whole number, but it is None"),
        ({"boxes": 2**70}, "boxes takes whole numbers of up to 63 bits, but this one has more"),
        ({"pullers": 0}, "pullers must be 1 agent or more, but it is 0"),
        ({"width": 5}, "width must be 10 units or more, but it is 5"),
        ({"width": 1e9}, "width must be 100,000 units or less, but it is 1,000,000,000"),
        ({"width": "wide"}, "width takes a number, but it is 'wide'"),
        ({"sight": float("nan")}, "sight takes a finite number, but it is nan"),
        ({"sight": float("inf")}, "sight takes a finite number, but it is inf"),
        ({"sight": 10**400}, "sight takes a finite number, but it is inf"),
        ({"placement": "center"}, "placement is one of anywhere, ring, but it is 'center'"),
        ({"release": 1}, "release takes a word, but it is 1"),
        (
            {"boxes": 3, "big_boxes": 4},
            "big_boxes must be 3 or less, as many as there are boxes, but it is 4",
        ),
        ({"deposit_x": 201.0}, "deposit_x must be 200 or less, within the arena's width, but it is 201"),
        ({"deposit_y": 201.0}, "deposit_y must be 200 or less, within the arena's height, but it is 201"),
        (
            {"deposit_range": 142.0},
            "deposit_range must be below 141.42, short of a corner of the arena, but it is 142",
        ),
        (
            {"placement": "ring", "ring_radius": 5.0},
            "ring_radius must be above 5, beyond deposit_range, but it is 5",
        ),
    ],
)
def test_what_cannot_be_is_refused_with_what_is_allowed(given: dict[str, Any], message: str) -> None:
    with pytest.raises(ParameterError) as refused:
        scenario.settle(given)
    assert str(refused.value).startswith(message)


def test_whole_numbers_will_do_for_lengths() -> None:
    width = scenario.settle({"width": 300})["width"]
    assert (width, type(width)) == (300.0, float)


def test_the_original_codes_arena_is_a_set_of_parameters() -> None:
    arena = Arena(1, pullers=1, **ORIGINAL)
    assert arena.at(arena.world.first_deposit) == (75.0, 75.0)
    arena.place(0, 36.5, 75.0)
    arena.place_box(0, 50.0, 75.0)
    arena.do("GrabBox")
    assert arena.attached() == [0]
    arena.tell("Forward")
    arena.tick(149)
    assert arena.counts()["boxes"] == 0
    arena.tick(2)
    assert arena.counts()["boxes"] == 1


@pytest.mark.parametrize(("forest", "top"), STRUCTURES.values(), ids=STRUCTURES)
def test_a_forager_runs_in_the_original_codes_arena(forest: Hierarchy, top: str) -> None:
    engine = ReferenceEngine(start(forest, top, **ORIGINAL))
    engine.step(100)
    assert engine.tick == 100


def test_a_world_can_do_without_boxes() -> None:
    arena = Arena(2, boxes=0)
    arena.do("GrabBox")
    assert arena.sees("ICanSeeABox") == 0.0
    assert arena.counts() == {"boxes": 0.0, "weight": 0.0}
