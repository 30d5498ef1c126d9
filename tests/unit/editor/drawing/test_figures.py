"""What figures promise without drawing: formats, and errors that say what is missing."""

import signal
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path
from typing import Self

import pytest

from app.editor.drawing import figures
from app.editor.drawing.figures import Figure, FigureError, Series, draw, refuse_format
from app.editor.palette import DARK, LIGHT, OKABE_ITO, Palette

FIGURE = Figure("t", "s", "x", "y", (Series("a", 0, (0.0, 1.0), (0.0, 1.0)),))


class Process:
    """A painter that no process stands behind."""

    def __init__(self, *_: object, **__: object) -> None: ...

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None: ...

    def submit(self, *_: object) -> "Process":
        return self

    def result(self) -> tuple[bytes, str]:
        return b"", "Qt cannot be loaded (libEGL.so.1: cannot open shared object file)"


@pytest.mark.parametrize("name", ["x.png", "x.SVG", "x.pdf"])
def test_known_endings_can_be_drawn(name: str) -> None:
    refuse_format(Path(name))


@pytest.mark.parametrize("name", ["x.gif", "x", "png"])
def test_other_endings_are_refused_with_those_that_can(name: str) -> None:
    with pytest.raises(FigureError, match=r"\.png, \.svg, \.pdf"):
        refuse_format(Path(name))


def test_a_file_that_cannot_be_written_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(figures, "_painted", lambda *_, **__: b"content")
    (tmp_path / "folder.png").mkdir()
    with pytest.raises(FigureError, match=r"folder.png: cannot be written: Is a directory"):
        draw(FIGURE, tmp_path / "folder.png")


def test_a_qt_that_cannot_be_loaded_is_told_with_what_is_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(figures, "ProcessPoolExecutor", Process)
    with pytest.raises(FigureError, match=r"libEGL\.so\.1.*understudy doctor"):
        draw(FIGURE, tmp_path / "x.png")
    assert not (tmp_path / "x.png").exists()

    def broken(_: Process) -> tuple[bytes, str]:
        raise BrokenProcessPool

    monkeypatch.setattr(Process, "result", broken)
    with pytest.raises(FigureError, match="Qt could not start"):
        draw(FIGURE, tmp_path / "x.png")


def luminance(color: str) -> float:
    channels = [int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a: str, b: str) -> float:
    high, low = sorted((luminance(a), luminance(b)), reverse=True)
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize("palette", [DARK, LIGHT], ids=["dark", "light"])
@pytest.mark.parametrize("ink", ["text", "dim"])
@pytest.mark.parametrize("ground", ["background", "panel", "raised", "canvas"])
def test_text_stands_out_from_every_ground(palette: Palette, ink: str, ground: str) -> None:
    assert contrast(getattr(palette, ink), getattr(palette, ground)) >= 4.5


@pytest.mark.parametrize("palette", [DARK, LIGHT], ids=["dark", "light"])
def test_the_first_lines_of_a_chart_stand_out_and_are_told_apart_by_the_color_blind(palette: Palette) -> None:
    assert set(palette.lines) <= set(OKABE_ITO)
    assert len(set(palette.lines)) == len(palette.lines)
    assert all(contrast(color, palette.panel) >= 3 for color in palette.lines[:3])


def test_ctrl_c_is_heeded_once_the_painter_is_done_which_never_hears_of_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    masked: list[bool] = []

    class Pressed(Process):
        def submit(self, *_: object) -> Process:
            masked.append(signal.SIGINT in signal.pthread_sigmask(signal.SIG_BLOCK, ()))
            return self

        def result(self) -> tuple[bytes, str]:
            signal.raise_signal(signal.SIGINT)
            masked.append(signal.SIGINT in signal.pthread_sigmask(signal.SIG_BLOCK, ()))
            return b"content", ""

    monkeypatch.setattr(figures, "ProcessPoolExecutor", Pressed)
    with pytest.raises(KeyboardInterrupt):
        draw(FIGURE, tmp_path / "x.png")
    assert masked == [True, False]
    assert not (tmp_path / "x.png").exists()
