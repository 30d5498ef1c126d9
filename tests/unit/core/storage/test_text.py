"""One text for one document, made to be read in a diff."""

import json

import pytest

from app.core.storage.text import WIDTH, TextError, parsed, written


def lines(document: dict[str, object]) -> list[str]:
    return written(document).decode().splitlines()


def test_keys_are_sorted_and_the_file_ends_with_a_line_end() -> None:
    assert written({"b": 1, "a": {"d": 1, "c": 2}}) == b'{\n  "a": {"c": 2, "d": 1},\n  "b": 1\n}\n'


def test_the_order_in_which_keys_were_put_in_does_not_matter() -> None:
    assert written({"a": 1, "b": {"c": 1, "d": 2}}) == written({"b": {"d": 2, "c": 1}, "a": 1})


def test_what_is_empty_stays_on_its_line() -> None:
    assert lines({"a": {}, "b": [], "examples": []}) == [
        "{",
        '  "a": {},',
        '  "b": [],',
        '  "examples": []',
        "}",
    ]


def test_each_item_of_the_documents_arrays_begins_a_line() -> None:
    assert lines({"rules": [{"id": "1"}, {"id": "2"}]}) == [
        "{",
        '  "rules": [',
        '    {"id": "1"},',
        '    {"id": "2"}',
        "  ]",
        "}",
    ]


def test_long_objects_are_spread_over_lines() -> None:
    inner = {"first": "x" * 60, "second": "y" * 60}
    assert lines({"states": [inner]}) == [
        "{",
        '  "states": [',
        "    {",
        f'      "first": "{"x" * 60}",',
        f'      "second": "{"y" * 60}"',
        "    }",
        "  ]",
        "}",
    ]


def test_examples_and_picks_take_a_line_each_however_long() -> None:
    long = {"a": "x" * 200}
    assert lines({"examples": [long, long]})[2:4] == [f"    {json.dumps(long)},", f"    {json.dumps(long)}"]
    assert lines({"picks": [{"tick": 1}]})[2] == '    {"tick": 1}'


def test_long_rows_of_numbers_fill_their_lines() -> None:
    found = lines({"tree": {"a": list(range(200)), "inner": {}}})
    assert all(len(line) <= WIDTH for line in found)
    assert len(found) < 20


def test_letters_of_all_alphabets_stay_readable() -> None:
    assert lines({"name": "größe 目标"})[1] == '  "name": "größe 目标"'


@pytest.mark.parametrize("number", [0.1, 1e300, 5e-324, -0.0, 1.0, 123456789.123456789, 2**63])
def test_numbers_come_back_exactly(number: float) -> None:
    [back] = parsed(written({"a": [number]}))["a"]
    assert (back, type(back), str(back)) == (number, type(number), str(number))


@pytest.mark.parametrize("number", [float("nan"), float("inf"), float("-inf")])
def test_numbers_that_json_does_not_know_are_never_written(number: float) -> None:
    with pytest.raises(ValueError, match="Out of range float values"):
        written({"a": number})


@pytest.mark.parametrize("document", [{"a": [{"b": "\ud800"}]}, {"a": [{"\udfff": 1}]}])
def test_half_a_character_is_named_with_its_place(document: dict[str, object]) -> None:
    with pytest.raises(TextError) as writing:
        written(document)
    with pytest.raises(TextError) as reading:
        parsed(json.dumps(document).encode())
    assert writing.value.where == reading.value.where
    assert writing.value.where.startswith("a[0]")


def test_a_whole_character_may_be_written_in_two_halves() -> None:
    assert parsed(rb'{"a": "\ud83d\ude00"}') == {"a": "😀"}


def test_wherever_a_text_is_cut_it_is_said_to_be_cut_short() -> None:
    text = rb'{"a": [true, null, -1.5e-7, "x\n\u00e9", {"b": {}}, false]}'
    for length in range(1, len(text)):
        with pytest.raises(TextError, match="cut short"):
            parsed(text[:length])
