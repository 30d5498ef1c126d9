"""What tests of the command line share: a terminal that is never told how far long work is, however slow the machine."""

import pytest

from app.cli import console


@pytest.fixture(autouse=True)
def no_lines_of_progress(monkeypatch: pytest.MonkeyPatch) -> None:
    """They come by the clock, where work takes ten seconds; what they say is tested on a clock of its own."""
    monkeypatch.setattr(console, "QUIET", float("inf"))
