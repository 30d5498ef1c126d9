import pytest

from app.core.errors import ScenarioError
from app.core.features import (
    FeatureUse,
    FlagUp,
    Ground,
    Operation,
    Over,
    Parameter,
    Sense,
    Source,
    Statistic,
    TicksInState,
    declaration,
    describe,
    slots,
    summarize,
)
from app.core.vocabulary import FeatureKind
from tests.samples import vocabulary

TO_HOME = Sense("DistanceTo", {"target": Ground("deposit")})


@pytest.mark.parametrize(
    ("source", "name"),
    [
        (TO_HOME, "DistanceTo(deposit)"),
        (Sense("DistanceTo", {"target": Parameter("goal")}), "DistanceTo(goal)"),
        (Sense("SeesABox"), "SeesABox"),
        (FlagUp("done"), "done"),
        (TicksInState(), "TicksInState"),
        (Statistic(Operation.ANY, FlagUp("finished")), "any finished"),
        (Statistic(Operation.MEAN, TO_HOME, Over.SUBSIDIARIES), "mean DistanceTo(deposit) (direct)"),
    ],
)
def test_a_feature_without_a_name_is_called_after_its_source(source: Source, name: str) -> None:
    assert describe(source) == name
    assert FeatureUse("f", source).shown == name
    assert FeatureUse("f", source, "mine").shown == "mine"


def test_several_slots_are_shown_in_order() -> None:
    assert slots({"from": Ground("a"), "to": Parameter("b")}) == "(a, b)"
    assert slots({}) == ""


def test_what_a_scenario_declares_holds_for_a_sensed_feature() -> None:
    assert declaration(TO_HOME, vocabulary()) == vocabulary().feature("DistanceTo")
    assert declaration(Sense("DirectionTo"), vocabulary()).kind is FeatureKind.TOROIDAL


def test_a_feature_that_the_scenario_lacks_is_refused() -> None:
    with pytest.raises(ScenarioError, match="there is no feature 'Smell'"):
        declaration(Statistic(Operation.ANY, Sense("Smell")), vocabulary())


def test_built_in_features_are_a_boolean_and_a_number_of_ticks() -> None:
    assert declaration(FlagUp("done"), vocabulary()).kind is FeatureKind.BOOLEAN
    ticks = declaration(TicksInState(), vocabulary())
    assert (ticks.kind, ticks.unit, ticks.default) == (FeatureKind.CONTINUOUS, "ticks", 0.0)


@pytest.mark.parametrize(
    ("operation", "kind", "default"),
    [
        (Operation.ANY, FeatureKind.BOOLEAN, 0.0),
        (Operation.ALL, FeatureKind.BOOLEAN, 1.0),
        (Operation.COUNT, FeatureKind.CONTINUOUS, 0.0),
        (Operation.MEAN, FeatureKind.CONTINUOUS, 1000.0),
        (Operation.MIN, FeatureKind.CONTINUOUS, 1000.0),
        (Operation.MAX, FeatureKind.CONTINUOUS, 1000.0),
    ],
)
def test_the_default_of_a_statistic_is_its_value_over_nobody(
    operation: Operation, kind: FeatureKind, default: float
) -> None:
    found = declaration(Statistic(operation, TO_HOME), vocabulary())
    assert (found.kind, found.default) == (kind, default)
    assert summarize(operation, [], vocabulary().feature("DistanceTo").default) == default


@pytest.mark.parametrize(
    ("operation", "values", "expected"),
    [
        (Operation.ANY, [0.0, -2.0], 1.0),
        (Operation.ANY, [0.0, 0.0], 0.0),
        (Operation.ALL, [1.0, 0.5], 1.0),
        (Operation.ALL, [1.0, 0.0], 0.0),
        (Operation.COUNT, [0.0, 3.0, 1.0], 2.0),
        (Operation.MEAN, [1.0, 2.0, 6.0], 3.0),
        (Operation.MIN, [4.0, -1.0, 2.0], -1.0),
        (Operation.MAX, [4.0, -1.0, 2.0], 4.0),
    ],
)
def test_statistics(operation: Operation, values: list[float], expected: float) -> None:
    assert summarize(operation, values, 9.0) == expected


def test_sums_run_left_to_right_without_compensation_as_a_kernel_adds() -> None:
    assert summarize(Operation.MEAN, [1e16, 1.0, -1e16, 1.0], 0.0) == 0.25
