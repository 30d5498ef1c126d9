"""The size of text and controls: what is offered, and what becomes of the choice."""

from pathlib import Path

import pytest

from app.editor.settings import Settings
from app.editor.size import FACTOR, size_in_force, sizes_that_fit, use_size


def test_a_size_is_kept_and_in_force_from_the_next_start_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(FACTOR, "")
    monkeypatch.delenv(FACTOR)
    Settings(tmp_path / "s.ini").size_percent = 125
    use_size(Settings(tmp_path / "s.ini").size_percent)
    assert size_in_force() == 125


def test_what_the_shell_says_comes_first(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(FACTOR, "2")
    use_size(125)
    assert size_in_force() == 200


@pytest.mark.parametrize(
    ("width", "now", "chosen", "offered"),
    [
        (1280, 100, 100, (100, 110)),
        (1920, 100, 100, (100, 110, 125, 150, 175)),
        (960, 200, 200, (100, 110, 125, 150, 175, 200)),
        (800, 100, 150, (100, 150)),
    ],
)
def test_only_sizes_at_which_the_window_fits_are_offered(
    width: int, now: int, chosen: int, offered: tuple[int, ...]
) -> None:
    assert sizes_that_fit(width, now, chosen) == offered


def test_a_size_beyond_all_reason_is_brought_back(tmp_path: Path) -> None:
    settings = Settings(tmp_path / "s.ini")
    settings.size_percent = 1_000_000
    assert settings.size_percent == 200
