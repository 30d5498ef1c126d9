"""How far what a node sees is from what it was taught with."""

from math import inf, pi

from app.core.automaton import Automaton
from app.core.examples import Example
from app.core.features import FeatureUse, Ground, Sense
from app.engine.familiar import Familiar, Nearest
from tests.samples import automaton, state, vocabulary

TARGET = {"target": Ground("deposit")}
SEEN = FeatureUse("sees", Sense("SeesABox"))
FAR = FeatureUse("far", Sense("DistanceTo", TARGET))
TOWARD = FeatureUse("toward", Sense("DirectionTo", TARGET))
SOIL = FeatureUse("soil", Sense("Ground"))


def taught(*features: FeatureUse) -> Automaton:
    return automaton("A", state("a", "Forward"), state("b", "Forward"), features=features)


def nearest(features: tuple[FeatureUse, ...], rows: list[dict[str, float]], **seen: float) -> Nearest:
    examples = [Example(str(n), "a", "b", row) for n, row in enumerate(rows)]
    return Familiar(taught(*features), examples, vocabulary()).nearest("a", seen)


def test_what_is_just_like_an_example_is_not_far() -> None:
    assert (
        nearest(
            (FAR, SEEN), [{"far": 1.0, "sees": 1.0}, {"far": 9.0, "sees": 0.0}], far=9.0, sees=0.0
        ).distance
        == 0.0
    )


def test_a_number_is_measured_by_the_range_of_all_examples() -> None:
    rows = [{"far": 10.0}, {"far": 30.0}]
    assert nearest((FAR,), rows, far=35.0) == Nearest(0.25, "far", 2)
    assert nearest((FAR,), rows, far=70.0) == Nearest(2.0, "far", 2)


def test_the_range_is_that_of_the_examples_of_all_states() -> None:
    examples = [Example("1", "a", "b", {"far": 10.0}), Example("2", "b", "b", {"far": 50.0})]
    found = Familiar(taught(FAR), examples, vocabulary()).nearest("a", {"far": 30.0})
    assert found == Nearest(0.5, "far", 1)


def test_an_angle_is_measured_around_the_circle() -> None:
    assert nearest((TOWARD,), [{"toward": 0.9 * pi}], toward=-0.9 * pi).distance == (2 * pi - 1.8 * pi) / pi
    assert nearest((TOWARD,), [{"toward": 0.0}], toward=-pi).distance == 1.0


def test_booleans_and_categories_are_the_same_or_not() -> None:
    assert nearest((SEEN,), [{"sees": 0.0}], sees=1.0).distance == 1.0
    assert nearest((SOIL,), [{"soil": 0.0}, {"soil": 2.0}], soil=1.0).distance == 1.0


def test_a_number_that_never_varied_is_the_same_or_not() -> None:
    assert nearest((FAR,), [{"far": 4.0}, {"far": 4.0}], far=4.5).distance == 1.0
    assert nearest((FAR,), [{"far": 4.0}], far=4.0).distance == 0.0


def test_the_feature_that_is_farthest_counts_and_is_named() -> None:
    rows = [{"far": 0.0, "sees": 1.0}, {"far": 10.0, "sees": 0.0}]
    assert nearest((FAR, SEEN), rows, far=1.0, sees=0.0) == Nearest(0.9, "far", 2)
    assert nearest((FAR, SEEN), [*rows[:1], {"far": 100.0, "sees": 1.0}], far=1.0, sees=0.0).feature == "sees"


def test_having_no_target_is_as_far_from_having_one_as_can_be_and_stretches_no_range() -> None:
    rows = [{"far": 0.0}, {"far": 10.0}, {"far": 1000.0}]
    assert nearest((FAR,), rows, far=15.0).distance == 0.5
    assert nearest((FAR,), rows, far=1000.0).distance == 0.0
    assert nearest((FAR,), rows[:2], far=1000.0).distance == 1.0
    assert nearest((FAR,), rows[2:], far=3.0).distance == 1.0


def test_a_state_without_examples_is_infinitely_far_and_one_without_features_is_not_far() -> None:
    assert nearest((FAR,), [], far=1.0) == Nearest(inf, "", 0)
    assert nearest((), [{}]) == Nearest(0.0, "", 1)


def test_disabled_examples_and_those_that_lack_a_value_do_not_count() -> None:
    examples = [
        Example("1", "a", "b", {"far": 1.0}, enabled=False),
        Example("2", "a", "b", {}),
        Example("3", "a", "b", {"far": 5.0}),
        Example("4", "a", "b", {"far": 9.0}),
    ]
    assert Familiar(taught(FAR), examples, vocabulary()).nearest("a", {"far": 1.0}) == Nearest(1.0, "far", 2)


def test_a_feature_that_cannot_be_seen_now_is_left_out() -> None:
    assert nearest((FAR, SEEN), [{"far": 1.0, "sees": 1.0}], sees=1.0) == Nearest(0.0, "sees", 1)
