"""Finding names by a few letters."""

import pytest

from app.editor.command_palette.matching import matching, places, score


@pytest.mark.parametrize(
    ("letters", "text", "found"),
    [
        ("rwb", "ReturnWithBox", (0, 6, 10)),
        ("box", "ReturnWithBox", (10, 11, 12)),
        ("a17", "agent-17", (0, 6, 7)),
        ("BOX", "grab box", (5, 6, 7)),
        ("xyz", "ReturnWithBox", ()),
        ("", "anything", ()),
        ("x", "İx", (1,)),
        ("go", "İİ goto", (3, 4)),
        ("it", "İts", ()),
    ],
)
def test_letters_are_found_where_words_begin(letters: str, text: str, found: tuple[int, ...]) -> None:
    assert places(letters, text) == found


@pytest.mark.parametrize(
    ("letters", "better", "worse"),
    [
        ("goto", "Goto", "Go to the beginning"),
        ("save", "Save", "Save as…"),
        ("box", "boxes", "big boxes"),
        ("rwb", "ReturnWithBox", "Draw the web"),
    ],
)
def test_what_fits_better_comes_first(letters: str, better: str, worse: str) -> None:
    assert score(letters, better) > score(letters, worse)


def test_a_search_may_be_narrowed_to_what_was_found_before() -> None:
    texts = ["Forage", "Forward", "Goto", "ControlForage"]
    assert matching("for", texts) == [0, 1, 3]
    assert matching("forag", texts, among=[0, 1, 3]) == [0, 3]


def test_letters_with_a_meaning_in_patterns_are_only_letters() -> None:
    assert matching("(x", ["Goto(X)", "Gotox"]) == [0]
