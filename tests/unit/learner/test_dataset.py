"""Which examples are learned from, and how they become arrays."""

from dataclasses import replace
from math import inf, nan

import pytest

from app.core.automaton import START
from app.core.errors import ExampleError, ScenarioError
from app.core.examples import Example
from app.core.features import FeatureUse, FlagUp, Operation, Sense, Statistic, TicksInState
from app.core.vocabulary import FeatureKind
from app.learner.dataset import columns_of, conflicts, datasets, refuse_unlearnable, sift
from tests import samples
from tests.unit.learner.examples import column, example, of

GOTO = samples.goto()
EXAMPLES = samples.goto_examples()
VOCABULARY = samples.vocabulary()


def test_disabled_examples_are_left_out_in_silence() -> None:
    sifted = sift(GOTO, [replace(EXAMPLES[0], enabled=False), EXAMPLES[1]])
    assert [e.id for e in sifted.kept] == ["2"]
    assert sifted.left_out == ()


@pytest.mark.parametrize(
    "changed", [replace(EXAMPLES[2], source="backward"), replace(EXAMPLES[2], label="backward")]
)
def test_examples_of_a_state_that_is_gone_are_left_out_with_the_reason(changed: Example) -> None:
    (left,) = sift(GOTO, [*EXAMPLES[:2], changed]).left_out
    assert (left.example, left.reason) == ("3", "the state 'backward' is gone")


def test_examples_without_a_value_for_a_feature_in_use_are_left_out_with_the_reason() -> None:
    partial = replace(EXAMPLES[0], values={"distance": 1.0})
    (left,) = sift(GOTO, [partial, EXAMPLES[1]]).left_out
    assert (left.example, left.reason) == ("1", "it has no value for the feature 'direction'")


def test_values_of_features_that_are_not_in_use_are_ignored() -> None:
    more = [replace(e, values={**e.values, "gone": nan}) for e in EXAMPLES]
    refuse_unlearnable(GOTO, more, VOCABULARY)
    found = datasets(GOTO, more, columns_of(GOTO.features, VOCABULARY))
    assert found["forward"].x.shape == (2, 2)


@pytest.mark.parametrize("value", [nan, inf, -inf])
def test_a_value_that_is_no_finite_number_is_refused_with_its_place(value: float) -> None:
    bad = replace(EXAMPLES[2], values={"distance": value, "direction": 0.0})
    with pytest.raises(
        ExampleError,
        match=rf"behavior 'goto', state 'forward', example '3': .*'distance' is {value}; it must be a finite number",
    ):
        refuse_unlearnable(GOTO, [*EXAMPLES[:2], bad], VOCABULARY)


@pytest.mark.parametrize("weight", [0.0, -1.0, nan, inf])
def test_a_weight_that_is_not_above_zero_and_finite_is_refused(weight: float) -> None:
    with pytest.raises(ExampleError, match="example '1': its weight is"):
        refuse_unlearnable(GOTO, [replace(EXAMPLES[0], weight=weight)], VOCABULARY)


def test_an_example_to_start_is_refused() -> None:
    with pytest.raises(ExampleError, match="example '1': it leads to Start"):
        refuse_unlearnable(GOTO, [replace(EXAMPLES[0], label=START)], VOCABULARY)


def test_an_example_from_a_flag_state_is_refused() -> None:
    with pytest.raises(ExampleError, match=r"state 'done', example '1': this state raises a flag"):
        refuse_unlearnable(GOTO, [replace(EXAMPLES[0], source="done")], VOCABULARY)


def test_an_example_from_a_state_whose_basic_behavior_raises_a_flag_is_refused() -> None:
    with pytest.raises(ExampleError, match="raises a flag"):
        refuse_unlearnable(samples.fetch(), [replace(EXAMPLES[0], source="release")], VOCABULARY)


def test_each_state_gets_its_own_dataset_in_the_order_of_the_states() -> None:
    found = datasets(GOTO, EXAMPLES, columns_of(GOTO.features, VOCABULARY))
    assert list(found) == [START, "forward", "left"]
    assert found["forward"].labels == ("forward", "left")
    assert found["left"].labels == ("left", "done")
    assert found["forward"].counts() == (1.0, 1.0)


def test_columns_are_the_automatons_features_and_no_others() -> None:
    assert [(c.feature, c.kind) for c in columns_of(GOTO.features, VOCABULARY)] == [
        ("distance", FeatureKind.CONTINUOUS),
        ("direction", FeatureKind.TOROIDAL),
    ]


def test_flags_ticks_and_statistics_are_columns_where_the_user_chose_them() -> None:
    uses = [
        FeatureUse("done", FlagUp("done")),
        FeatureUse("ticks", TicksInState()),
        FeatureUse("attached", Statistic(Operation.COUNT, Sense("IsAttached"))),
        FeatureUse("help", Sense("SomeoneNeedsHelp")),
    ]
    boolean, continuous = FeatureKind.BOOLEAN, FeatureKind.CONTINUOUS
    assert [c.kind for c in columns_of(uses, VOCABULARY)] == [boolean, continuous, continuous, boolean]


def test_a_feature_that_the_scenario_lacks_is_refused() -> None:
    with pytest.raises(ScenarioError, match="no feature 'Smell'; there are: DirectionTo"):
        columns_of([FeatureUse("smell", Sense("Smell"))], VOCABULARY)


def test_rows_do_not_depend_on_the_order_of_examples() -> None:
    made = [example(n, "AB"[n % 2], {"f": float(n % 3)}, weight=1.0 + n) for n in range(6)]
    one, other = of(made, column("f")), of(made[::-1], column("f"))
    assert one.x.tolist() == other.x.tolist()
    assert one.examples == other.examples


def test_conflicts_are_groups_with_equal_features_and_different_labels() -> None:
    points = [("A", 1.0), ("B", 1.0), ("A", 1.0), ("A", 2.0), ("B", 3.0), ("B", 3.0)]
    made = [example(number, label, {"f": value}) for number, (label, value) in enumerate(points)]
    assert [sorted(group) for group in conflicts(of(made, column("f")))] == [["0", "1", "2"]]


def test_without_features_all_examples_are_equal() -> None:
    data = of([example(1, "A", {}), example(2, "B", {})])
    assert conflicts(data) == (("1", "2"),)
