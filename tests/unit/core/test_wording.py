"""Tests and guards in the words that the user reads."""

import pytest

from app.core.automaton import Automaton
from app.core.conditions import Condition, Equals, Guard, InArc
from app.core.features import FeatureUse, Ground, Operation, Sense, Source, Statistic
from app.core.vocabulary import Feature, FeatureKind, Phrases, Vocabulary
from app.core.wording import Speech, condition_words, guard_words
from tests import chase, samples
from tests.foragers import beyond, no, within, yes
from tests.unit.core.all_features import DEPOSIT, EXPLAINED, FORAGER, FORAGING, arc

# ------------------------------------------------------------------------------------------------ captions


@pytest.mark.parametrize(
    ("guard", "words"),
    [
        ((), "always"),
        ((yes("sees"),), "sees a box"),
        ((no("sees"),), "sees no box"),
        ((Condition(Equals("sees", 0.0)),), "sees no box"),
        ((within("away", 5.0),), "within 5 of deposit"),
        ((beyond("box", 12.34567),), "farther than 12.3 from nearest visible box"),
        ((beyond("away", 5.0), within("away", 12.0)), "between 5 and 12 from deposit"),
        ((within("away", 12.0), within("away", 8.0), beyond("away", 5.0)), "between 5 and 8 from deposit"),
        ((beyond("away", 5.0001), within("away", 5.0002)), "between 5.0001 and 5.0002 from deposit"),
        ((arc("toward", -180, 2.82e-15),), "deposit lies between -180 and 0 degrees"),
        ((arc("toward", -10, 10),), "deposit lies between -10 and 10 degrees"),
        ((arc("toward", -12.185033067, -12.185033067 + 1e-12),), "deposit lies at -12.2 degrees"),
        ((arc("toward", 71.8, 71.8 + 1e-12, wanted=False),), "deposit does not lie at 71.8 degrees"),
        ((arc("toward", -10, 10, wanted=False),), "deposit does not lie between -10 and 10 degrees"),
        ((arc("toward", 170, -170),), "deposit does not lie between -170 and 170 degrees"),
        ((arc("toward", 0, -180),), "deposit lies between 0 and 180 degrees"),
        ((arc("toward", -90, 90), arc("toward", 0, 135)), "deposit lies between 0 and 90 degrees"),
        ((yes("done"),), "done"),
        ((no("done"),), "not done"),
        ((beyond("ticks", 20.5),), "more than 20 ticks in this state"),
        ((within("ticks", 1.0),), "at most 1 tick in this state"),
        ((beyond("ticks", 180 * (1 - 1e-15)),), "at least 180 ticks in this state"),
        ((within("ticks", 180 * (1 - 1e-15)),), "fewer than 180 ticks in this state"),
        ((beyond("ticks", 2.5), within("ticks", 9.5)), "more than 2 ticks and at most 9 ticks in this state"),
        ((yes("sees"), no("done")), "sees a box and not done"),
        ((yes("gone"),), "Gone is 1"),
        ((yes("nowhere"),), "nowhere is 1"),
    ],
)  # fmt: skip
def test_tests_of_a_forager(guard: Guard, words: str) -> None:
    assert guard_words(guard, FORAGER, FORAGING) == words


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        (beyond("box", 999.9999), "there is no nearest visible box"),
        (within("box", 999.9999), "there is a nearest visible box"),
        (beyond("box", 504.4), "there is no nearest visible box within 504"),
        (within("box", 504.4), "there is a nearest visible box within 504"),
        (beyond("x", 999.9999), "there is no X"),
        (within("x", 999.9999), "there is an X"),
    ],
)
def test_a_bound_near_the_default_tells_whether_there_is_a_target(condition: Condition, words: str) -> None:
    assert condition_words(condition, FORAGER, FORAGING) == words


def test_a_target_that_is_far_but_there_is_told_without_the_default() -> None:
    guard = (beyond("box", 4.5), within("box", 999.9999))
    assert guard_words(guard, FORAGER, FORAGING) == "farther than 4.5 from nearest visible box"


def test_where_there_is_no_target_nothing_else_is_told_of_it() -> None:
    guard = (arc("ahead", -10, 10), beyond("box", 999.9999), yes("sees"))
    assert guard_words(guard, FORAGER, FORAGING) == "there is no nearest visible box and sees a box"


def test_arcs_that_overlap_in_two_are_told_one_by_one() -> None:
    guard = (arc("toward", -100, 100), arc("toward", 90, -90))
    assert guard_words(guard, FORAGER, FORAGING) == (
        "deposit lies between -100 and 100 degrees and deposit does not lie between -90 and 90 degrees"
    )


def test_tests_that_no_value_passes_are_told_one_by_one() -> None:
    guard = (beyond("away", 9.0), within("away", 5.0), yes("sees"), no("sees"))
    assert guard_words(guard, FORAGER, FORAGING) == (
        "farther than 9 from deposit and within 5 of deposit and sees a box and sees no box"
    )


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        (yes("help"), "someone needs help"),
        (yes("any"), "someone is attached to a box"),
        (no("any"), "nobody is attached to a box"),
        (yes("all"), "everyone is attached to a box"),
        (no("all"), "not everyone is attached to a box"),
        (yes("full one"), "the box of someone is full"),
        (beyond("count", 2.5), "3 or more agents see a box"),
        (within("count", 1.5), "at most 1 agent sees a box"),
        (beyond("count", 0.5), "someone sees a box"),
        (within("count", 0.5), "nobody sees a box"),
        (yes("direct"), "a subsidiary has finished"),
        (no("direct"), "no subsidiary has finished"),
        (no("all done"), "not every subsidiary is done"),
        (within("mean", 5.0), "the agents on average are within 5 of deposit"),
        (beyond("share", 0.5), "more than 50% of the agents see a box"),
        (within("min", 5.0), "someone is within 5 of deposit"),
        (beyond("min", 5.0), "everyone is farther than 5 from deposit"),
        (within("max", 5.0), "everyone is within 5 of deposit"),
        (beyond("max", 5.0), "someone is farther than 5 from deposit"),
    ],
)
def test_tests_of_a_controller(condition: Condition, words: str) -> None:
    assert condition_words(condition, FORAGER, FORAGING) == words


@pytest.mark.parametrize(
    ("guard", "words"),
    [
        ((beyond("count", 1.5), within("count", 4.5)), "2 to 4 agents see a box"),
        ((beyond("count", 2.5), within("count", 3.5)), "3 agents see a box"),
        (
            (beyond("min", 2.0), within("min", 5.0)),
            "everyone is farther than 2 from deposit and someone is within 5 of deposit",
        ),
        (
            (beyond("share", 0.25), within("share", 0.5)),
            "more than 25% and at most 50% of the agents see a box",
        ),
    ],
)
def test_ranges_of_a_controller(guard: Guard, words: str) -> None:
    assert guard_words(guard, FORAGER, FORAGING) == words


# ------------------------------------------------------------------------------------------------- clauses


@pytest.mark.parametrize(
    ("guard", "words"),
    [
        ((no("sees"),), "it sees no box that still needs pullers"),
        ((within("away", 5.0),), "it is within 5 of deposit"),
        ((within("x", 5.0),), "it is within 5 of deposit"),
        ((arc("toward", -10, 10),), "deposit lies between -10 and 10 degrees"),
        ((yes("full"),), "its box is full"),
        ((no("full"),), "its box lacks pullers"),
        ((yes("done"),), "Goto is done"),
        ((no("failed"),), "Goto has not failed"),
        ((yes("odd"),), "Goto has raised odd"),
        ((beyond("ticks", 20.5),), "it has been in Goto for more than 20 ticks"),
        ((no("any"),), "nobody in Group 3 is attached to a box"),
        ((yes("direct"),), "a subsidiary of Group 3 has finished"),
        ((yes("help"),), "someone needs help"),
    ],
)
def test_clauses_of_an_explanation(guard: Guard, words: str) -> None:
    assert guard_words(guard, FORAGER, FORAGING, EXPLAINED) == words


# ------------------------------------------------------------------------------------------ without phrases


@pytest.mark.parametrize(
    ("source", "condition", "words"),
    [
        (Sense("SeesABox"), yes("f"), "SeesABox"),
        (Sense("SeesABox"), no("f"), "not SeesABox"),
        (Sense("DistanceTo", DEPOSIT), within("f", 2.0), "DistanceTo(deposit) is at most 2"),
        (Sense("DistanceTo", DEPOSIT), beyond("f", 2.0), "DistanceTo(deposit) is above 2"),
        (Sense("DirectionTo", DEPOSIT), arc("f", -10, 10), "DirectionTo(deposit) is between -10 and 10 degrees"),
        (Sense("DirectionTo", DEPOSIT), arc("f", 10, 10 + 1e-12), "DirectionTo(deposit) is 10 degrees"),
        (Sense("Ground"), Condition(Equals("f", 1.0)), "Ground is sand"),
        (Sense("Ground"), Condition(Equals("f", 1.0), wanted=False), "Ground is not sand"),
        (Statistic(Operation.ANY, Sense("SeesABox")), yes("f"), "any SeesABox"),
        (Statistic(Operation.COUNT, Sense("Ground")), beyond("f", 2.5), "count Ground is above 2.5"),
    ],
)  # fmt: skip
def test_without_phrases_the_features_name_tells(source: Source, condition: Condition, words: str) -> None:
    made = Automaton("a", "A", features=(FeatureUse("f", source),))
    assert condition_words(condition, made, samples.vocabulary()) == words


def test_a_name_that_the_user_gave_is_told() -> None:
    made = Automaton("a", "A", features=(FeatureUse("f", Sense("SeesABox"), "box near"),))
    assert condition_words(no("f"), made, samples.vocabulary()) == "not box near"
    assert condition_words(no("f"), made, samples.vocabulary(), Speech(clause=True)) == "box near is false"


CHASE = Automaton(
    "c",
    "C",
    features=(
        FeatureUse("gap", Sense("Gap", {"a": Ground("home"), "b": Ground("nearest hare")})),
        FeatureUse("third", Sense("Third")),
        FeatureUse("hour", Sense("Clock")),
        FeatureUse("alone", Sense("Alone")),
    ),
)


@pytest.mark.parametrize(
    ("guard", "words", "clause"),
    [
        ((within("gap", 5.0),), "home is within 5 of nearest hare", ""),
        ((yes("third"),), "in the middle", "it is in the middle"),
        ((no("third"),), "not in the middle", "it is not in the middle"),
        ((no("third"), Condition(Equals("third", 0.0), wanted=False)), "in the right", "it is in the right"),
        ((Condition(InArc("hour", -3.0, 2.0)),), "it is between -3 and 2 hours", ""),
        ((Condition(InArc("hour", 4.0, -4.0)),), "Clock is not between -4 and 4 hours", ""),
        ((yes("alone"),), "alone", "it is alone"),
        ((no("alone"),), "in company", "it is in company"),
    ],
)
def test_the_second_scenario(guard: Guard, words: str, clause: str) -> None:
    vocabulary = chase.scenario.vocabulary
    assert guard_words(guard, CHASE, vocabulary) == words
    assert guard_words(guard, CHASE, vocabulary, Speech(clause=True)) == (clause or words)


@pytest.mark.parametrize("phrase", ["{", "{}", "{0}", "{x!r}", "{value.real}", "%s", "near {nobody}", " "])
def test_any_phrase_can_be_told(phrase: str) -> None:
    feature = Feature(
        "F", FeatureKind.CONTINUOUS, phrases=Phrases(phrase, phrase, phrase, phrase, phrase, phrase)
    )
    vocabulary = Vocabulary(features={"F": feature})
    made = Automaton("a", "A", features=(FeatureUse("f", Sense("F")),))
    for condition in (within("f", 2.0), beyond("f", 2.0), yes("f")):
        for speech in (Speech(), EXPLAINED):
            assert "F is" in condition_words(condition, made, vocabulary, speech)
