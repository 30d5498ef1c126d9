import pytest

from app.cli.wording import counted, number, percent, unknown


def test_an_unknown_word_is_answered_with_what_there_is() -> None:
    assert unknown("arm", "xyz", ["left", "right"]) == "there is no arm 'xyz'; there are: left, right"


@pytest.mark.parametrize(
    ("word", "known", "meant"),
    [
        ("trian", ["train", "run"], "train"),
        ("goto", ["agent/Goto", "agent/Wander"], "agent/Goto"),
        ("boxes", ["world.boxes", "world.width"], "world.boxes"),
        ("world.bxes", ["world.boxes", "world.width"], "world.boxes"),
        ("FORAGE", ["Forage"], "Forage"),
    ],
)
def test_a_near_match_is_offered_whatever_its_case_and_prefix(
    word: str, known: list[str], meant: str
) -> None:
    assert f"(did you mean {meant!r}?)" in unknown("thing", word, known)


def test_what_only_stands_in_the_same_place_is_not_offered() -> None:
    assert "did you mean" not in unknown("setting", "world.nope", ["world.boxes", "world.width"])


def test_names_with_commas_stand_in_quotes() -> None:
    said = unknown("figure", "x", ["one tick", "one tick, compiled"])
    assert said.endswith("there are: 'one tick', 'one tick, compiled'")


def test_where_there_is_nothing_that_is_said() -> None:
    assert unknown("arm", "x", []).endswith("there are: none")


def test_one_is_counted_in_the_singular() -> None:
    assert (counted(1, "run"), counted(2, "run"), counted(1000, "box", "boxes")) == (
        "1 run",
        "2 runs",
        "1,000 boxes",
    )


@pytest.mark.parametrize(
    ("value", "words"),
    [(12.0, "12"), (10.5, "10.5"), (12345.0, "12,345"), (12345.678, "12,345.7"), (2 / 3, "0.6667")],
)
def test_numbers_are_short(value: float, words: str) -> None:
    assert number(value) == words


def test_a_share_that_is_not_known_is_a_dash() -> None:
    assert (percent(None), percent(0.5)) == ("–", "50%")
