"""What a scenario cannot declare is refused at once, with a message that names it."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import pytest

from app.core.errors import ScenarioError
from app.sim.scenario import Column, FeatureKind, Kind, Per, Phrases, Scenario, World, quantity


@dataclass(frozen=True, slots=True)
class Parameters:
    size: float = quantity(1.0, "units", 0.0, 2.0)
    count: int = quantity(1, "", 0, 9)
    any_count: int = quantity(1)


def scenario(**fields: Any) -> Scenario:
    return Scenario("test", "Test", **{"parameters": Parameters, **fields})


def nothing(world: World, me: int) -> float:
    return 0.0


def refused(declare: Callable[[], object]) -> str:
    with pytest.raises(ScenarioError) as error:
        declare()
    message = str(error.value)
    assert message.startswith("scenario 'test': ")
    return message.removeprefix("scenario 'test': ")


# ----------------------------------------------------------------------------------------- names and twins


@pytest.mark.parametrize("what", ["feature", "behavior", "target"])
def test_two_of_one_name(what: str) -> None:
    made = scenario()
    arguments: dict[str, Any] = {"kind": FeatureKind.CONTINUOUS} if what == "feature" else {}
    function: Any = {"target": lambda: take4}.get(what, lambda: nothing)()
    declare = getattr(made, what)
    declare("Twin", **arguments)(function)
    assert refused(lambda: declare("Twin", **arguments)(function)) == f"{what} 'Twin' is declared twice"


def take4(world: World, first: int, end: int, me: int) -> int:
    return -1


def test_a_feature_of_an_agent_and_one_of_a_group_with_one_name() -> None:
    made = scenario()
    made.feature("Twin", FeatureKind.CONTINUOUS)(nothing)

    def of_group(world: World, first: int, end: int) -> float:
        return 0.0

    message = refused(lambda: made.group_feature("Twin", FeatureKind.CONTINUOUS)(of_group))
    assert message == "feature 'Twin' is declared twice"


def test_two_resets() -> None:
    made = scenario()

    def reset(world: World) -> None: ...

    made.reset(reset)
    assert refused(lambda: made.reset(reset)) == "reset is declared twice"


def test_a_name_that_is_empty() -> None:
    assert refused(lambda: scenario().behavior(" ")(nothing)) == "a name is missing: behavior ' '"


def test_one_parameter_named_twice() -> None:
    message = refused(lambda: scenario().behavior("Join", ("a", "a"))(take4))
    assert message == "behavior 'Join' names the parameter 'a' twice"


# ---------------------------------------------------------------------------------------------- functions


def test_a_function_with_other_arguments() -> None:
    message = refused(lambda: scenario().feature("F", FeatureKind.CONTINUOUS, ("target",))(nothing))
    assert message == "feature 'F' is called with 3 arguments, but nothing takes: world, me"


@pytest.mark.parametrize("function", [lambda _world, _me: 0.0, print, int, 3])
def test_what_is_no_plain_function(function: Any) -> None:
    assert refused(lambda: scenario().behavior("B")(function)).startswith(
        "behavior 'B' has to be a plain function, not "
    )


def test_a_check_with_other_arguments() -> None:
    assert "check is called with 1 arguments" in refused(lambda: scenario().check(nothing))


# ----------------------------------------------------------------------------------------------- features


@pytest.mark.parametrize(
    ("declared", "message"),
    [
        ({"kind": "boolean", "default": 0.5}, "the default of feature 'F' is 0.5; allowed: 0 or 1"),
        (
            {"kind": "continuous", "default": float("nan")},
            "the default of feature 'F' is nan; allowed: a finite number",
        ),
        (
            {"kind": "toroidal", "default": 2.0, "period": 4.0},
            "the default of feature 'F' is 2.0; allowed: a number in [-2, 2)",
        ),
        ({"kind": "toroidal", "period": 0.0}, "feature 'F' has the period 0.0; allowed: above 0"),
        (
            {"kind": "categorical", "categories": ("a", "b"), "default": 2.0},
            "the default of feature 'F' is 2.0; allowed: a whole number from 0 to 1",
        ),
        ({"kind": "categorical"}, "feature 'F' is categorical with the categories (); "),
        (
            {"kind": "categorical", "categories": ("a", "a")},
            "feature 'F' is categorical with the categories ",
        ),
        ({"kind": "boolean", "categories": ("no", "yes")}, "feature 'F' is boolean with the categories "),
        (
            {"kind": "continuous", "phrases": Phrases(above="beyond {valeu}")},
            "phrase 'above' of feature 'F' has no words for {valeu}; it has for: {value}",
        ),
        (
            {"kind": "boolean", "phrases": Phrases(detail="of {target}")},
            "phrase 'detail' of feature 'F' has no words for {target}; it has for: none",
        ),
    ],
)
def test_features_that_cannot_be(declared: dict[str, Any], message: str) -> None:
    kind = FeatureKind(declared.pop("kind"))
    assert refused(lambda: scenario().feature("F", kind, **declared)(nothing)).startswith(message)


# ---------------------------------------------------------------------------- columns, kinds and measures


@pytest.mark.parametrize(
    ("column", "message"),
    [
        (Column("x"), "column 'x' has the name of a column that every world has"),
        (Column("clock"), "column 'clock' has the name of something that every world has"),
        (Column("end_box"), "column 'end_box' has the name of something that every world has"),
        (Column("class"), "column 'class' needs another name: "),
        (Column("_hidden"), "column '_hidden' needs another name: "),
        (Column("two words"), "column 'two words' needs another name: "),
        (Column("c", initial=float("inf")), "column 'c' begins with inf; allowed: a finite number"),
        (Column("c", whole=True, initial=0.5), "column 'c' begins with 0.5; allowed: a whole number"),
    ],
)
def test_columns_that_cannot_be(column: Column, message: str) -> None:
    assert refused(lambda: scenario(columns=(column,), kinds=(Kind("box", 1),))).startswith(message)


def test_two_columns_of_one_name() -> None:
    twins = (Column("c"), Column("c", whole=True))
    assert refused(lambda: scenario(columns=twins)) == "column 'c' has the name of another column"


@pytest.mark.parametrize(
    ("kind", "message"),
    [
        (Kind("agent", 1), "there is more than one kind 'agent'"),
        (Kind("def", 1), "kind 'def' needs another name: "),
        (Kind("box", -1), "the count of kind 'box' is -1; allowed: "),
        (Kind("box", "boxes"), "the count of kind 'box' is 'boxes'; allowed: "),
        (Kind("box", "size"), "the count of kind 'box' is 'size'; allowed: "),
        (Kind("box", "any_count"), "the count of kind 'box' is 'any_count'; allowed: "),
        (Kind("box", "count", "girth"), "the radius of kind 'box' is a parameter 'girth' that there is not"),
    ],
)
def test_kinds_that_cannot_be(kind: Kind, message: str) -> None:
    assert refused(lambda: scenario(kinds=(kind,))).startswith(message)


@pytest.mark.parametrize("column", ["nowhere", "x", "amount"])
def test_measures_without_a_column_of_a_single_entry(column: str) -> None:
    columns = (Column("amount"), Column("total", per=Per.WORLD))
    message = refused(lambda: scenario(columns=columns, measures={"m": column}))
    assert message == (
        f"measure 'm' names the column {column!r}; columns with a single entry: progressed, total"
    )


# --------------------------------------------------------------------------------------------- parameters


@dataclass(frozen=True)
class Hidden:
    _size: float = quantity(1.0)


@dataclass(frozen=True)
class Bare:
    size: float = 1.0


@dataclass(frozen=True)
class Required:
    size: float


@dataclass(frozen=True)
class Made:
    size: float = field(default_factory=lambda: 1.0)


@dataclass(frozen=True)
class Listed:
    size: Any = quantity((1, 2))  # type: ignore[arg-type]  # noqa: RUF009 - a field, as mypy does not see


@dataclass(frozen=True)
class Wordy:
    size: str = quantity("large")


@dataclass(frozen=True)
class Outside:
    size: float = quantity(3.0, "units", 0.0, 2.0)


@dataclass(frozen=True)
class OtherWord:
    size: str = quantity("huge", choices=("small", "large"))


@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        (dict, "the parameters have to be a dataclass, not <class 'dict'>"),
        (Parameters(), "the parameters have to be a dataclass, not Parameters("),
        (Hidden, "parameter '_size' must not begin with an underscore"),
        (Bare, "parameter 'size' has to be made by quantity(default, ...)"),
        (Required, "parameter 'size' has to be made by quantity(default, ...)"),
        (Made, "parameter 'size' has to be made by quantity(default, ...)"),
        (
            Listed,
            "the default of parameter 'size' is (1, 2); allowed: a number, a whole number, true or false, a word",
        ),
        (Wordy, "parameter 'size' is a word, so it needs choices"),
        (Outside, "the default of a parameter is not allowed: size must be 2 units or less, but it is 3"),
        (
            OtherWord,
            "the default of a parameter is not allowed: size is one of small, large, but it is 'huge'",
        ),
    ],
)
def test_parameters_that_cannot_be(parameters: Any, message: str) -> None:
    assert refused(lambda: scenario(parameters=parameters)).startswith(message)
