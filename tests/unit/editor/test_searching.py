"""Searching by words, as all searches of the window do."""

import pytest

from app.editor.searching import has_words, words_in


@pytest.mark.parametrize("query", ["box nearest", "NEAREST Box", " near  bo ", ""])
def test_words_are_found_in_any_order_whatever_their_case(query: str) -> None:
    assert has_words(words_in(query), "distance to the Nearest box")


def test_every_word_has_to_be_there_and_in_one_text() -> None:
    assert has_words(words_in("squad 17"), "Agent 17", "squad")
    assert not has_words(words_in("squad 18"), "Agent 17", "squad")
    assert not has_words(words_in("17squad"), "Agent 17", "squad")


@pytest.mark.parametrize(("query", "found"), [("17", True), ("7", False), ("20", True), ("box3", True)])
def test_a_number_is_looked_for_where_one_begins(query: str, found: bool) -> None:
    assert has_words(words_in(query), "Agent 17, arm 0020, box3") is found


def test_a_word_of_which_nothing_was_typed_yet_is_anywhere() -> None:
    assert has_words(["box", ""], "a box")
