"""The published schemas are those of the records."""

from pathlib import Path

import pytest

from app.core.storage.json_schemas import json_schemas, write

PUBLISHED = Path(__file__).parents[4] / "resources" / "schemas"


@pytest.mark.parametrize("name", sorted(json_schemas()))
def test_a_published_schema_is_current(name: str) -> None:
    advice = "run: python -m app.core.storage.json_schemas resources/schemas"
    assert (PUBLISHED / name).read_bytes() == json_schemas()[name], advice


def test_nothing_else_is_published() -> None:
    assert {path.name for path in PUBLISHED.iterdir()} == set(json_schemas())


def test_writing_them_makes_their_folder(tmp_path: Path) -> None:
    write(tmp_path / "schemas")
    assert {path.name: path.read_bytes() for path in (tmp_path / "schemas").iterdir()} == json_schemas()
