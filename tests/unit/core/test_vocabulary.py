import pytest

from app.core.errors import ScenarioError
from app.core.vocabulary import BasicBehavior, Vocabulary
from tests.samples import vocabulary


@pytest.mark.parametrize(
    ("behavior", "once"),
    [
        (BasicBehavior("Forward"), False),
        (BasicBehavior("GrabBox", one_shot=True), True),
        (BasicBehavior("Done", raises="done"), True),
        (BasicBehavior("Forage", derived=True), False),
    ],
)
def test_one_shots_and_flag_raisers_run_once(behavior: BasicBehavior, once: bool) -> None:
    assert behavior.runs_once is once


def test_words_are_found_by_name() -> None:
    words = vocabulary()
    assert words.behavior("GrabBox").one_shot
    assert words.feature("DistanceTo").default == 1000.0
    assert words.target("biggest-attached-agent").level == 2


@pytest.mark.parametrize(
    ("find", "message"),
    [
        (Vocabulary.behavior, "there is no basic behavior 'fly'; there are: Done, Face, Forward"),
        (Vocabulary.feature, "there is no feature 'fly'; there are: DirectionTo, DistanceTo"),
        (Vocabulary.target, "there is no target 'fly'; there are: biggest-attached-agent, closest"),
    ],
)
def test_a_word_that_does_not_exist_is_refused_with_those_that_do(find, message: str) -> None:
    with pytest.raises(ScenarioError, match=message):
        find(vocabulary(), "fly")


def test_an_empty_vocabulary_says_so() -> None:
    with pytest.raises(ScenarioError, match="there are: none"):
        Vocabulary().feature("Anything")
