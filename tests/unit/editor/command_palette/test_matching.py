"""Finding things by all the words that were typed, or names by a few letters."""

import pytest

from app.editor.command_palette.matching import letter_places, matching, places, score

NAMES = ["forage", "forward", "goto", "controlforage"]


@pytest.mark.parametrize(
    ("letters", "text", "found"),
    [
        ("rwb", "ReturnWithBox", (0, 6, 10)),
        ("a17", "agent-17", (0, 6, 7)),
        ("xyz", "ReturnWithBox", ()),
        ("", "anything", ()),
        ("x", "İx", (1,)),
        ("it", "İts", ()),
    ],
)
def test_letters_are_found_where_words_begin(letters: str, text: str, found: tuple[int, ...]) -> None:
    assert letter_places(letters, text) == found


@pytest.mark.parametrize(
    ("words", "name", "found"),
    [
        (("box",), "ReturnWithBox", (10, 11, 12)),
        (("box",), "Mailbox, box", (9, 10, 11)),
        (("go",), "İİ goto", (3, 4)),
        (("theme", "dark"), "Dark theme", (0, 1, 2, 3, 5, 6, 7, 8, 9)),
        (("slow", "speed"), "Slower", (0, 1, 2, 3)),
        (("rwb",), "ReturnWithBox", (0, 6, 10)),
        (("pause",), "Play", ()),
    ],
)
def test_what_was_typed_is_marked_where_it_stands_in_a_name(
    words: tuple[str, ...], name: str, found: tuple[int, ...]
) -> None:
    assert places(words, name) == found


@pytest.mark.parametrize(
    ("query", "better", "worse"),
    [
        ("goto", "Goto", "Go to the beginning"),
        ("save", "Save", "Save as…"),
        ("save as", "Save as…", "As saved"),
        ("box", "boxes", "big boxes"),
        ("box", "big boxes", "Mailbox"),
        ("rwb", "ReturnWithBox", "Draw the web"),
        ("agent 1", "Agent 1", "Agent 10"),
    ],
)
def test_what_fits_better_comes_first(query: str, better: str, worse: str) -> None:
    assert score(query.split(), better) > score(query.split(), worse)


def test_a_name_with_a_word_comes_before_others_that_are_only_told_by_it() -> None:
    told = score(["speed"], "Faster", "fast speed up Double the speed")
    assert score(["speed"], "Speed limit") > told > score(["speed"], "Lone seeped")


def test_every_word_is_found_in_any_order_in_the_name_or_in_what_else_is_known() -> None:
    others = ["carries boxes home", "moves on", "a box or a place", ""]
    assert matching(["for", "box"], NAMES, others, range(4)) == [0]
    assert matching(["box", "for"], NAMES, others, range(4)) == [0]
    assert matching(["box"], NAMES, others, range(4)) == [0, 2]
    assert matching(["box", "wheel"], NAMES, others, range(4)) == []


def test_a_search_may_be_narrowed_to_what_was_found_before() -> None:
    assert matching(["for"], NAMES, (), range(4)) == [0, 1, 3]
    assert matching(["forag"], NAMES, (), [0, 1, 3]) == [0, 3]


def test_letters_with_a_meaning_in_patterns_are_only_letters() -> None:
    assert matching(["(x"], ["goto(x)", "gotox"], (), range(2)) == [0]
    assert matching(["g]^-x"], ["g ] ^ - x", "g-x"], (), range(2)) == [0]


def test_a_number_is_found_where_one_begins_but_its_digits_may_be_letters_of_a_name() -> None:
    names = ["agent 17", "agent 117", "agent 7"]
    assert matching(["17"], names, (), range(3)) == [0, 1]
    assert score(["17"], "Agent 17") > score(["17"], "Agent 170") > score(["17"], "Agent 117")
