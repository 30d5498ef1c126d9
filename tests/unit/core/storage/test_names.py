"""A name that one system allows must be allowed on all."""

import pytest

from app.core.naming import slug
from app.core.storage import file_name_problem, type_name_problem
from app.core.storage.names import LONGEST


@pytest.mark.parametrize(
    "name", ["goto", "return-with-box", "x.y", "a b", "größe", "目标", "x" * LONGEST, "console"]
)
def test_ordinary_names_are_fine(name: str) -> None:
    assert file_name_problem(name) == ""
    assert type_name_problem(name) == ""


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("", "it is empty"),
        ("..", "it begins with a dot"),
        (".hidden", "it begins with a dot"),
        ("end.", "ends with a dot or a space"),
        ("end ", "ends with a dot or a space"),
        ("a/b", "it holds '/'"),
        ("a\\b", r"it holds '\\'"),
        ("a:b", "it holds ':'"),
        ("a\nb", r"it holds '\n'"),
        ("a\0b", r"it holds '\x00'"),
        ("NUL", "some systems keep it for a device"),
        ("com1.old", "some systems keep it for a device"),
        ("x" * (LONGEST + 1), "it is longer than 120 bytes"),
        ("目" * 50, "it is longer than 120 bytes"),
    ],
)
def test_a_name_that_some_system_refuses_is_refused(name: str, message: str) -> None:
    assert message in file_name_problem(name)


def test_a_type_cannot_be_called_like_the_folder_of_moments() -> None:
    assert file_name_problem("moments") == ""
    assert "examples/moments" in type_name_problem("Moments")


@pytest.mark.parametrize("name", ["", "ReturnWithBox", "../../etc", "Größe", "目标", "a" * 500])
def test_ids_made_from_names_can_be_file_names(name: str) -> None:
    assert file_name_problem(slug(name)) == ""
