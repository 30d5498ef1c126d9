"""What was found, as files: the figure (SVG, PNG, PDF), the numbers (CSV), the report (Markdown)."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from ...core.errors import StorageError, UnderstudyError
from ...core.storage import file_is_there
from ...core.storage.atomic import WriteError, change_files
from ...engine.experiments.data import curves_csv, runs_csv
from ...engine.experiments.report import Files, markdown
from ..documents.asking import Answer, Question
from ..documents.choosing import choose_file
from ..drawing.curve_painting import painted
from ..drawing.experiment_chart import chart_of
from ..forms.buttons import text_button

if TYPE_CHECKING:
    from ...engine.experiments.findings import Findings
    from .study import Study
    from .window import ExperimentsWindow


class Exporting:
    """Buttons that write files."""

    def __init__(self, window: ExperimentsWindow) -> None:
        self._window = window
        self.buttons = tuple(
            text_button(text, tip, act)
            for text, tip, act in (
                ("Figure…", "Write the figure as SVG, PNG or PDF", self.choose_figure),
                ("Data…", "Write all runs as CSV, and the curves beside them", self.choose_data),
                ("Report…", "Write tables, tests and verdicts as Markdown", self.choose_report),
            )
        )

    def refresh(self, found: Findings | None) -> None:
        """There is something to write as soon as a run has ended."""
        ready = found is not None and any(summary.runs for summary in found.summaries)
        for button in self.buttons:
            button.setEnabled(ready)

    # ------------------------------------------------------------------------------------------- choosing

    def choose_figure(self) -> None:
        """Ask where the figure goes."""
        self._ask("Write the figure", "svg", "SVG (*.svg);;PNG (*.png);;PDF (*.pdf)", self.write_figure)

    def choose_data(self) -> None:
        """Ask where the numbers go."""
        self._ask("Write the data", "csv", "CSV (*.csv)", self._ask_for_curves)

    def choose_report(self) -> None:
        """Ask where the report goes."""
        self._ask("Write the report", "md", "Markdown (*.md)", self.write_report)

    def _ask(self, title: str, ending: str, kinds: str, write: Callable[[Path], None]) -> None:
        study = self._window.study
        if study is None:
            return
        choose_file(self._window, title, study.folder / f"{study.path.stem}.{ending}", kinds, write)

    def _ask_for_curves(self, path: Path) -> None:
        """The dialog has asked whether one file may be replaced, but there are two."""
        beside = _curves_beside(path)
        if file_is_there(path) or not file_is_there(beside):
            self.write_data(path)
            return
        text = f"{beside} is there already, and the curves go there. What is in it would be gone."
        answers = Answer("Replace", partial(self.write_data, path)), Answer("Cancel")
        Question(self._window, self._window.studio.theme, "Replace the file?", text, answers).ask()

    # -------------------------------------------------------------------------------------------- writing

    def write_figure(self, path: Path) -> None:
        """Draw the figure into a file; its ending says how."""
        found = self._found()
        if path.suffix not in (".svg", ".png", ".pdf"):
            self._failed(StorageError(f"{path}: a figure ends with .svg, .png or .pdf"))
            return
        content = painted(chart_of(found), path.suffix, dark=self._window.studio.theme.is_dark)
        self._write({path: content})

    def write_data(self, path: Path) -> None:
        """Write a line a run, and the curves into a second file beside it."""
        found, rows = self._found(), () if self._window.kept is None else tuple(self._window.kept.rows)

        def content() -> dict[Path, bytes]:
            return {
                path: runs_csv(found.experiment, rows).encode(),
                _curves_beside(path): curves_csv(found).encode(),
            }

        self._window.background.do(content, self._write, self._failed)

    def write_report(self, path: Path) -> None:
        """Write the report."""
        study = self._study()
        command = f"understudy experiment PROJECT {study.declared.name}"
        text = markdown(self._found(), Files(study.path, path), command)
        self._write({path: text.encode()})

    def _found(self) -> Findings:
        assert self._window.pages.found is not None
        return self._window.pages.found

    def _study(self) -> Study:
        assert self._window.study is not None
        return self._window.study

    def _write(self, contents: dict[Path, bytes]) -> None:
        self._window.background.do(
            partial(_written, contents),
            self._written,
            self._failed,
        )

    def _written(self, names: str) -> None:
        self._window.studio.say(f"written: {names}")
        self._window.controls.tell(f"written: {names}")

    def _failed(self, error: UnderstudyError) -> None:
        self._window.studio.warn(str(error))
        self._window.controls.tell(str(error))


def _curves_beside(path: Path) -> Path:
    """Where the curves go if the runs go to *path*."""
    return path.with_name(f"{path.stem}-curves.csv")


def _written(contents: dict[Path, bytes]) -> str:
    """Write files, all of them or none; returns their names."""
    try:
        change_files(contents, ())
    except WriteError as error:
        why = error.error.strerror or error.error
        raise StorageError(f"{error.path}: cannot be written: {why}") from error
    return ", ".join(str(path) for path in contents)
