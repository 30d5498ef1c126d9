"""What was found goes into files by clicks, and a run of another project opens in a window of its own."""

import json
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QFileDialog, QMenu, QPushButton
from pytestqt.qtbot import QtBot

from app.editor.application import RunWindows
from app.editor.documents.asking import Question
from app.editor.experiments.builder import ExperimentBuilder
from app.editor.experiments.window import ExperimentsWindow
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE, said
from tests.gui.experiments.looking import MANY, finished, small, told

LEFT = Qt.MouseButton.LeftButton
Shown = tuple[MainWindow, ExperimentsWindow]


def others(main: MainWindow) -> list[MainWindow]:
    """Windows besides this one."""
    there = QApplication.topLevelWidgets()
    return [w for w in there if isinstance(w, MainWindow) and w is not main and w.isVisible()]


def save_as_proposed(window: ExperimentsWindow, qtbot: QtBot, button: str) -> None:
    """Run, then write what was found under the name that is proposed."""
    small(window, runs=1)
    qtbot.mouseClick(window.controls.run, LEFT)
    qtbot.waitUntil(lambda: finished(window) and not window.background.busy, timeout=3 * PATIENCE)
    write = next(b for b in window.pages.exporting.buttons if b.text() == button)
    qtbot.waitUntil(write.isEnabled)
    qtbot.mouseClick(write, LEFT)
    (dialog,) = window.findChildren(QFileDialog)
    box = dialog.findChild(QDialogButtonBox)
    assert isinstance(box, QDialogButtonBox)
    qtbot.mouseClick(box.button(QDialogButtonBox.StandardButton.Save), LEFT)


@pytest.mark.parametrize(
    ("button", "names"),
    [
        ("Figure…", ["figure3-200-ticks.svg"]),
        ("Data…", ["figure3-200-ticks.csv", "figure3-200-ticks-curves.csv"]),
        ("Report…", ["figure3-200-ticks.md"]),
    ],
)
def test_what_was_found_is_written_where_the_dialog_says(
    shown: Shown, qtbot: QtBot, button: str, names: list[str]
) -> None:
    _, window = shown
    save_as_proposed(window, qtbot, button)
    qtbot.waitUntil(lambda: told(window, "Written:"))
    assert window.study is not None
    assert [(window.study.folder / name).stat().st_size > 0 for name in names] == [True] * len(names)


def test_curves_that_are_there_are_replaced_only_if_the_user_says_so(shown: Shown, qtbot: QtBot) -> None:
    _, window = shown
    small(window, runs=1)
    assert window.study is not None
    there = window.study.folder / "figure3-200-ticks-curves.csv"
    there.parent.mkdir(exist_ok=True)
    there.write_text("mine")
    save_as_proposed(window, qtbot, "Data…")
    (question,) = window.findChildren(Question)
    assert str(there) in question.text
    qtbot.mouseClick(question.buttons[1], LEFT)
    assert there.read_text() == "mine"
    save_as_proposed(window, qtbot, "Data…")
    question = window.findChildren(Question)[-1]
    qtbot.mouseClick(question.buttons[0], LEFT)
    qtbot.waitUntil(lambda: told(window, "Written:"))
    assert there.read_text() != "mine"


def test_while_an_experiment_runs_it_says_how_long_it_will_take(shown: Shown, qtbot: QtBot) -> None:
    _, window = shown
    small(window, runs=MANY)
    window.controls.ticks.setValue(2000)
    qtbot.mouseClick(window.controls.run, LEFT)
    qtbot.waitUntil(
        lambda: told(window, f"of {4 * MANY:,} runs, ") and told(window, " left"), timeout=3 * PATIENCE
    )
    qtbot.mouseClick(window.controls.cancel, LEFT)
    qtbot.waitUntil(lambda: told(window, "Cancelled;"), timeout=3 * PATIENCE)


def test_a_run_is_opened_at_the_tick_that_is_typed(shown: Shown, qtbot: QtBot) -> None:
    main, window = shown
    small(window, runs=1)
    qtbot.mouseClick(window.controls.run, LEFT)
    page = window.pages.runs
    qtbot.waitUntil(lambda: page.model.rowCount() == 4, timeout=3 * PATIENCE)
    window.pages.setCurrentWidget(page)
    page.tick.selectAll()
    qtbot.keyClicks(page.tick, "77")
    at = page.table.visualRect(page.model.index(1, 0)).center()
    qtbot.mouseClick(page.table.viewport(), LEFT, pos=at)
    row = page.chosen
    assert row is not None
    qtbot.mouseDClick(page.table.viewport(), LEFT, pos=at)

    def there() -> tuple[int, int]:
        snapshot = main.studio.snapshot
        return (-1, -1) if snapshot is None else (snapshot.seed, snapshot.tick)

    qtbot.waitUntil(lambda: there() == (row.seed, 77))


def test_a_run_of_another_forest_opens_in_a_window_of_its_own(
    shown: Shown, qapp: QApplication, qtbot: QtBot, folder: Path
) -> None:
    main, window = shown
    windows = RunWindows(qapp, main)
    path = folder / "experiments" / "figure3.json"
    read = json.loads(path.read_text())
    small_groups = {"name": "sizes", "setting": "sizes", "values": [[2, 3]]}
    few = {**read, "arms": read["arms"][1:2], "claims": [], "factors": [small_groups]}
    path.write_text(json.dumps({**few, "runs": 1, "ticks": 200, "points": 2}))
    window.listing.choose("open")
    window.listing.choose("figure3")
    qtbot.mouseClick(window.controls.run, LEFT)
    qtbot.waitUntil(lambda: window.pages.runs.model.rowCount() == 1, timeout=3 * PATIENCE)
    page = window.pages.runs
    window.pages.setCurrentWidget(page)
    page.table.selectRow(0)
    row = page.chosen
    assert row is not None
    qtbot.keyClick(page.table, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: bool(window.findChildren(Question)))
    (asked,) = window.findChildren(Question)
    qtbot.mouseClick(next(b for b in asked.findChildren(QPushButton) if b.text() == "Open it"), LEFT)
    qtbot.waitUntil(lambda: len(others(main)) == 1)
    (other,) = others(main)
    qtbot.waitUntil(lambda: other.studio.snapshot is not None and other.studio.snapshot.tick == 200)
    snapshot = other.studio.snapshot
    assert snapshot is not None
    assert (snapshot.seed, len(snapshot.place.agents)) == (row.seed, 6)
    assert {name: snapshot.measures[name] for name in row.measures} == row.measures
    windows.close()
    qtbot.waitUntil(lambda: not others(main))


def test_an_experiment_is_begun_from_the_menu(shown: Shown, qtbot: QtBot) -> None:
    main, window = shown
    menu = next(action.menu() for action in main.menuBar().actions() if said(action) == "Experiment")
    assert isinstance(menu, QMenu)
    menu.popup(main.mapToGlobal(main.rect().topLeft()))
    entry = next(action for action in menu.actions() if said(action) == "New experiment…")
    qtbot.mouseClick(menu, LEFT, pos=menu.actionGeometry(entry).center())
    qtbot.waitUntil(lambda: bool(window.findChildren(ExperimentBuilder)))
    (builder,) = window.findChildren(ExperimentBuilder)
    qtbot.keyClick(builder, Qt.Key.Key_Escape)
