"""What the examples table says of each example."""

from dataclasses import replace
from typing import Any

from app.core.automaton import Automaton, Basic, Refit, State
from app.core.conditions import AtMost
from app.core.examples import Example
from app.core.features import FeatureUse, Sense
from app.core.tree import Branch, Leaf, Tree
from app.editor.examples.verdicts import MEANINGS, Matter, Verdict, judge

TREE = Tree(("go", "stop"), Branch(AtMost("f", 5.0), Leaf((3.0, 0.0)), Leaf((0.0, 3.0)), (3.0, 3.0)))
AUTOMATON = Automaton(
    "a",
    "A",
    states=(*Automaton("a", "A").states, State("go", Basic("Go")), State("stop", Basic("Stop"))),
    features=(FeatureUse("f", Sense("F")),),
    learned={"go": TREE},
)


def verdict_on(*examples: Example) -> list[Verdict]:
    judged = judge(Matter(AUTOMATON, examples))
    return [judged.verdicts[example.id] for example in examples]


def example(number: int, label: str, value: float, source: str = "go", **more: Any) -> Example:
    return Example(str(number), source, label, {"f": value}, **more)


def test_an_example_agrees_where_the_tree_would_do_what_it_says() -> None:
    assert verdict_on(example(1, "go", 4.0), example(2, "stop", 6.0)) == [Verdict.AGREES] * 2


def test_an_example_is_outvoted_where_the_tree_would_do_something_else() -> None:
    assert verdict_on(example(1, "stop", 4.0)) == [Verdict.OUTVOTED]


def test_equal_features_with_different_labels_conflict_on_both_sides() -> None:
    assert verdict_on(example(1, "go", 4.0), example(2, "stop", 4.0)) == [Verdict.CONFLICT] * 2


def test_a_disabled_example_conflicts_with_nothing() -> None:
    found = verdict_on(example(1, "go", 4.0), example(2, "stop", 4.0, enabled=False))
    assert found == [Verdict.AGREES, Verdict.OFF]


def test_an_example_without_a_value_or_with_a_state_that_is_gone_is_left_out() -> None:
    lacking = Example("1", "go", "go", {})
    assert verdict_on(lacking, example(2, "gone", 4.0)) == [Verdict.LEFT_OUT] * 2


def test_of_a_state_without_a_tree_nothing_is_known() -> None:
    assert verdict_on(example(1, "go", 4.0, source="stop")) == [Verdict.UNKNOWN]


def test_the_verdict_follows_the_example_and_the_model() -> None:
    first, other = example(1, "go", 4.0), example(2, "stop", 6.0)

    def found(automaton: Automaton, *examples: Example) -> list[Verdict]:
        return list(judge(Matter(automaton, examples)).verdicts.values())

    assert found(AUTOMATON, first, other) == [Verdict.AGREES, Verdict.AGREES]
    assert found(AUTOMATON, replace(first, label="stop"), other) == [Verdict.OUTVOTED, Verdict.AGREES]
    stops = replace(AUTOMATON, learned={"go": Tree(("go", "stop"), Leaf((0.0, 3.0)))})
    assert found(stops, first, other) == [Verdict.OUTVOTED, Verdict.AGREES]
    assert found(replace(stops, learned={}), first, other) == [Verdict.UNKNOWN, Verdict.UNKNOWN]


def test_what_a_model_says_by_a_feature_that_was_dropped_is_known_where_the_example_has_it() -> None:
    without = replace(AUTOMATON, features=())
    assert judge(Matter(without, (example(1, "go", 4.0),))).verdicts == {"1": Verdict.AGREES}
    assert judge(Matter(without, (Example("1", "go", "go", {}),))).verdicts == {"1": Verdict.UNKNOWN}


def test_judging_ends_when_it_is_cancelled() -> None:
    assert judge(Matter(AUTOMATON, (example(1, "go", 4.0),)), lambda: True).verdicts == {}


def test_every_verdict_is_explained() -> None:
    assert set(MEANINGS) == set(Verdict)


def test_of_a_model_without_a_tree_nobody_says_that_nothing_was_learned() -> None:
    fitted = replace(AUTOMATON, learned={"go": Refit("knn")})
    assert judge(Matter(fitted, (example(1, "go", 4.0),))).verdicts == {"1": Verdict.UNTOLD}
