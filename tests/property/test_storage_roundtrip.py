"""What is saved is what is loaded, value for value and byte for byte, for projects of every shape."""

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from app.core.errors import StorageError
from app.core.examples import Moment
from app.core.project import Project
from app.core.storage import load, moment_hash, save
from app.core.storage.moments import decoded, encoded
from app.core.storage.text import TextError, parsed, written
from tests.strategies import finite, moments, projects, words
from tests.unit.core.storage.folders import contents

any_project = projects() | projects(checked=False)
#: A project takes a tenth of a second to draw.
few = settings(max_examples=30, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large])
documents = st.dictionaries(
    words,
    st.recursive(
        st.none() | st.booleans() | st.integers() | finite | words,
        lambda inner: st.lists(inner, max_size=40) | st.dictionaries(words, inner, max_size=4),
        max_leaves=30,
    ),
    max_size=4,
)


@contextlib.contextmanager
def new_folder() -> Iterator[Path]:
    """A folder of its own for every project that hypothesis tries, not waited for to reach the disk."""
    with TemporaryDirectory() as base, pytest.MonkeyPatch.context() as patched:
        patched.setattr(os, "fsync", lambda _handle: None)
        yield Path(base) / "project"


@few
@given(any_project)
def test_a_loaded_project_is_the_one_that_was_saved_and_is_saved_to_the_same_bytes(project: Project) -> None:
    with new_folder() as folder:
        save(project, folder)
        loaded = load(folder)
        assert loaded == project
        other = folder.with_name("other")
        save(loaded, other)
        assert contents(other) == contents(folder)


@settings(few, max_examples=15)
@given(any_project, any_project, st.booleans())
def test_a_folder_holds_what_was_saved_last_and_nothing_else(
    first: Project, second: Project, knows_the_first: bool
) -> None:
    with new_folder() as folder:
        save(first, folder)
        save(second, folder, first if knows_the_first else None)
        assert load(folder) == second
        fresh = folder.with_name("fresh")
        save(second, fresh)
        assert contents(folder) == contents(fresh)


@given(moments)
def test_a_moment_comes_back_with_its_name(moment: Moment) -> None:
    back = decoded(encoded(moment))
    assert back == moment
    assert moment_hash(back) == moment_hash(moment)


@given(documents)
def test_a_document_comes_back_and_has_one_text(document: dict[str, Any]) -> None:
    text = written(document)
    assert parsed(text) == document
    assert written(parsed(text)) == text


@given(documents, st.floats(0, 1, exclude_max=True))
def test_a_text_that_is_cut_short_is_no_document(document: dict[str, Any], share: float) -> None:
    text = written(document).rstrip()
    with pytest.raises(TextError):
        parsed(text[: int(len(text) * share)])


@given(st.binary(max_size=40) | st.text('{}[]",:012eE.-\\unltrasNI', max_size=40).map(str.encode))
def test_any_bytes_are_a_document_or_refused(data: bytes) -> None:
    with contextlib.suppress(TextError):
        parsed(data)


@given(st.binary(max_size=200))
def test_any_bytes_that_are_no_moment_are_refused(data: bytes) -> None:
    with pytest.raises(StorageError):
        decoded(data)
