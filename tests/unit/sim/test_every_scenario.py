"""Whatever ships keeps the contract: a scenario added to app/sim/scenarios is tested here without a new test."""

from collections.abc import Callable, Iterator
from dataclasses import is_dataclass
from typing import Any

import pytest

from app.core.vocabulary import FeatureKind
from app.sim import portable, trial
from app.sim.ranges import is_value
from app.sim.scenario import Per, Scenario
from app.sim.scenarios import names, shipped
from tests.chase import scenario as chase

SCENARIOS = {**{name: shipped(name) for name in names()}, "chase": chase}
each = pytest.mark.parametrize("scenario", SCENARIOS.values(), ids=SCENARIOS)


def declared(scenario: Scenario) -> Iterator[tuple[str, Callable[..., Any]]]:
    """All functions, by what they are."""
    for what in ("features", "behaviors", "targets", "stages"):
        for name, function in getattr(scenario, what).items():
            yield f"{what} {name}", function
    for check in scenario.checks:
        yield "check", check


def test_foraging_ships() -> None:
    assert "foraging" in names()


@each
def test_its_module_is_called_like_it(scenario: Scenario) -> None:
    assert scenario.features
    module = next(iter(scenario.features.values())).__module__
    assert module.split(".")[-1] == scenario.name
    assert scenario.title
    assert scenario.doc


@each
def test_every_function_is_documented(scenario: Scenario) -> None:
    assert [what for what, function in declared(scenario) if not (function.__doc__ or "").strip()] == []


@each
def test_the_vocabulary_says_what_the_functions_say(scenario: Scenario) -> None:
    words = scenario.vocabulary
    tables: tuple[Any, ...] = (words.features, words.behaviors, words.targets)
    assert [named.name for table in tables for named in table.values() if not named.doc] == []


@each
def test_it_says_how_a_world_begins_and_how_things_move(scenario: Scenario) -> None:
    assert {"reset", "kinematics"} <= scenario.stages.keys()


@each
def test_measures_are_kept_in_columns_with_a_single_entry(scenario: Scenario) -> None:
    single = {column.name for column in scenario.columns if column.per is Per.WORLD}
    assert scenario.measures
    assert set(scenario.measures.values()) <= single


@each
def test_every_column_and_kind_is_documented(scenario: Scenario) -> None:
    assert [column.name for column in scenario.columns if not column.doc] == []
    assert [kind.name for kind in scenario.kinds if not kind.doc] == []


@each
def test_parameters_are_frozen_documented_and_have_units(scenario: Scenario) -> None:
    assert is_dataclass(scenario.parameters)
    assert scenario.parameters.__dataclass_params__.frozen  # type: ignore[attr-defined]  # where Python has it
    fields = scenario.parameter_fields()
    assert [name for name, declared in fields.items() if not declared.metadata["doc"]] == []
    unitless = [name for name, f in fields.items() if isinstance(f.default, float) and not f.metadata["unit"]]
    assert unitless == []


@each
def test_numbers_have_a_range(scenario: Scenario) -> None:
    unbounded = [
        name
        for name, declared in scenario.parameter_fields().items()
        if type(declared.default) in (int, float)
        and (declared.metadata["low"] is None or declared.metadata["high"] is None)
    ]
    assert unbounded == []


@each
def test_defaults_of_parameters_are_allowed_alone_and_together(scenario: Scenario) -> None:
    assert scenario.settle(scenario.defaults()) == scenario.defaults()


@each
def test_defaults_of_features_are_values_that_they_can_have(scenario: Scenario) -> None:
    features = scenario.vocabulary.features.values()
    assert [feature.name for feature in features if not is_value(feature, feature.default)] == []


@each
def test_features_can_be_put_into_sentences(scenario: Scenario) -> None:
    wordless = [
        feature.name
        for feature in scenario.vocabulary.features.values()
        if not _has_phrases(feature.kind, feature.phrases)
    ]
    assert wordless == []


def _has_phrases(kind: FeatureKind, phrases: Any) -> bool:
    if kind is FeatureKind.CONTINUOUS:
        return bool(phrases.above or phrases.below)
    return bool(phrases.true)


@each
def test_its_functions_can_be_compiled_with_the_same_results(scenario: Scenario) -> None:
    assert portable.faults(scenario) == []


@each
def test_its_functions_keep_their_promises(scenario: Scenario) -> None:
    assert trial.faults(scenario) == []


#: A world in which all that can happen does, for scenarios whose defaults are too roomy for that.
CROWDED: dict[str, dict[str, Any]] = {
    "foraging": {
        "width": 12.0,
        "height": 12.0,
        "deposit_x": 6.0,
        "deposit_y": 6.0,
        "deposit_range": 2.0,
        "boxes": 4,
        "pullers": 1,
        "big_boxes": 1,
        "big_pullers": 2,
        "step": 0.5,
    }
}


@each
def test_its_functions_keep_their_promises_where_much_happens(scenario: Scenario) -> None:
    assert trial.faults(scenario, CROWDED.get(scenario.name), ticks=120) == []
