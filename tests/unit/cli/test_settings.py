import pytest

from app.cli.settings import parsed
from app.core.errors import ParameterError
from app.sim.scenarios.foraging import scenario as foraging


@pytest.mark.parametrize(
    ("word", "name", "value"),
    [
        ("world.boxes=20", "world.boxes", 20),
        ("world.width=50", "world.width", 50.0),
        (" world.sight = 2.5", "world.sight", 2.5),
        ("world.placement=ring", "world.placement", "ring"),
        ("physics=kinematic", "physics", "kinematic"),
    ],
)
def test_a_value_takes_the_type_of_its_parameter(word: str, name: str, value: object) -> None:
    settings = parsed([word], foraging)
    assert settings == {name: value}
    assert type(settings[name]) is type(value)


def test_what_is_no_number_is_left_for_the_scenario_to_refuse_by_name() -> None:
    settings = parsed(["world.boxes=many"], foraging)
    with pytest.raises(ParameterError, match="boxes takes a whole number, but it is 'many'"):
        foraging.settle({"boxes": settings["world.boxes"]})


@pytest.mark.parametrize("word", ["world.bxes=3", "boxes=3", "box=3"])
def test_an_unknown_setting_is_answered_with_those_there_are(word: str) -> None:
    with pytest.raises(ParameterError, match=r"did you mean 'world\.boxes'\?.*physics, engine, world\."):
        parsed([word], foraging)


def test_a_setting_without_a_value_is_refused_with_an_example() -> None:
    with pytest.raises(ParameterError, match=r"--set world\.boxes: it takes NAME=VALUE"):
        parsed(["world.boxes"], foraging)


def test_a_setting_is_given_once() -> None:
    with pytest.raises(ParameterError, match=r"world\.boxes is set twice"):
        parsed(["world.boxes=1", "world.boxes=2"], foraging)
