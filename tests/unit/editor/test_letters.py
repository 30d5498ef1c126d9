"""Every entry of a menu has a letter of its own, the one that is looked for first where it can be."""

import pytest

from app.editor.letters import letters_of, marked, plain, unmarked


def test_the_first_letter_is_taken_where_no_other_has_it_and_another_initial_where_one_has() -> None:
    texts = ["New project…", "Open…", "Open recent", "Save", "Save as…"]
    assert letters_of(texts) == ("n", "o", "r", "s", "a")


def test_an_initial_of_a_small_word_comes_after_that_of_another() -> None:
    assert letters_of(["Reset", "Reset with the next seed"]) == ("r", "n")


def test_letters_that_are_taken_are_given_to_nobody() -> None:
    assert letters_of(["File", "Edit"], taken="F") == ("i", "e")


def test_who_has_no_other_letter_gets_that_of_one_who_has() -> None:
    letters = letters_of(["ab", "a", "b"])
    assert set(letters) == {"a", "b", ""}
    assert letters_of(["Able", "A"]) == ("b", "a")


def test_a_text_without_a_letter_that_keyboards_have_gets_none() -> None:
    assert letters_of(["⚑", "…", "İ", ""]) == ("", "", "", "")


@pytest.mark.parametrize(
    ("text", "letter", "expected"),
    [
        ("Save as…", "a", "Save &as…"),
        ("Experiment", "x", "E&xperiment"),
        ("R&D", "d", "R&&&D"),
        ("R&D", "", "R&&D"),
        ("Undo: Rename a to b", "q", "Undo: Rename a to b"),
        ("İz of box", "b", "İz of &box"),
        ("İzmir", "m", "İz&mir"),
    ],
)
def test_a_letter_is_marked_where_a_word_begins_and_ampersands_are_shown(
    text: str, letter: str, expected: str
) -> None:
    assert marked(text, letter) == expected


def test_a_name_is_shown_as_it_is() -> None:
    assert plain("R&D") == "R&&D"


@pytest.mark.parametrize("text", ["Save as…", "R&D", "R && D", "&", ""])
def test_what_qt_has_taken_says_what_was_given(text: str) -> None:
    assert unmarked(plain(text)) == text
    assert unmarked(marked(text, "d")) == text
