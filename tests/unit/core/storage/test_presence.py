"""Places that the system does not let anybody look at hold nothing."""

from pathlib import Path

from app.core.storage import file_is_there, folder_is_there


def test_files_and_folders_are_told_apart(tmp_path: Path) -> None:
    file = tmp_path / "a"
    file.write_bytes(b"")
    assert (file_is_there(file), folder_is_there(file)) == (True, False)
    assert (file_is_there(tmp_path), folder_is_there(tmp_path)) == (False, True)
    assert not file_is_there(tmp_path / "b")


def test_where_the_system_refuses_to_look_nothing_is_there(tmp_path: Path) -> None:
    refused = tmp_path / ("n" * 300) / "a"
    assert not file_is_there(refused)
    assert not folder_is_there(refused)
