"""The window of experiments as a user handles it."""

import json
from pathlib import Path

from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtWidgets import QComboBox, QDialogButtonBox, QPushButton, QTableView
from pytestqt.qtbot import QtBot

from app.core.edits import note_project, set_world
from app.editor.documents.asking import Question
from app.editor.experiments.builder import ExperimentBuilder
from app.editor.experiments.window import ExperimentsWindow
from app.editor.forms.choosing import Chooser
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE
from tests.gui.documents.desk import answer, question
from tests.gui.experiments.looking import MANY, finished, made, small, told
from tests.patient_bot import have_done_what_is_due


def test_the_experiments_of_the_project_are_listed(shown: tuple[MainWindow, ExperimentsWindow]) -> None:
    _, window = shown
    names = [window.listing.list.item(row).text() for row in range(window.listing.list.count())]
    assert names == ["figure3", "figure4", "open", "original", "paper", "samples"]
    assert window.title.text().startswith("Figure 3")


def test_running_fills_curves_tables_and_verdicts_and_running_again_has_nothing_to_do(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot
) -> None:
    _, window = shown
    small(window)
    qtbot.mouseClick(window.controls.run, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: finished(window), timeout=3 * PATIENCE)
    qtbot.waitUntil(lambda: window.pages.runs.model.rowCount() == 8, timeout=PATIENCE)
    assert len(window.pages.curves.names) == 4
    window.pages.setCurrentIndex(1)
    assert window.pages.arms.rowCount() == 4
    window.pages.setCurrentIndex(2)
    assert window.pages.claims.rowCount() > 0
    assert told(window, "Finished: 8 runs")
    qtbot.waitUntil(lambda: not window.background.busy, timeout=PATIENCE)
    before = made(window)
    look = window.running.look
    seen: list[tuple[int, int]] = []
    window.running.changed.connect(
        lambda: seen.append((window.pages.runs.model.rowCount(), window.controls.bar.value()))
    )
    qtbot.mouseClick(window.controls.run, Qt.MouseButton.LeftButton)
    assert seen == [(8, 0)], "while runs begin, those that are there stay in sight, and the bar says none"
    assert told(window, "Beginning: 8 runs")
    qtbot.waitUntil(lambda: finished(window) and window.running.look is not look, timeout=3 * PATIENCE)
    assert min(rows for rows, _ in seen) == 8
    qtbot.waitUntil(lambda: not window.background.busy, timeout=PATIENCE)
    assert made(window) == before


def test_more_runs_than_the_experiment_says_are_there_the_next_day(
    shown: tuple[MainWindow, ExperimentsWindow], folder: Path, qtbot: QtBot
) -> None:
    _, window = shown
    path = folder / "experiments" / "figure3.json"
    path.write_text(json.dumps({**json.loads(path.read_text()), "runs": 1, "ticks": 200, "points": 2}))
    window.listing.choose("open")
    window.listing.choose("figure3")
    window.controls.runs.setValue(2)
    window.begin()
    qtbot.waitUntil(lambda: finished(window) and not window.background.busy, timeout=3 * PATIENCE)
    window.listing.choose("open")
    window.listing.choose("figure3")
    qtbot.waitUntil(lambda: told(window, "Finished: 8 runs"), timeout=PATIENCE)
    assert window.controls.runs.value() == 2
    window.pages.compare.list.item(0).setCheckState(Qt.CheckState.Checked)
    qtbot.waitUntil(lambda: window.pages.compare.model.rowCount() == 4, timeout=PATIENCE)
    assert {window.pages.compare.model.row(number)[3] for number in range(4)} == {"2"}
    window.controls.runs.setValue(1)
    qtbot.waitUntil(lambda: told(window, "Finished: 4 runs"), timeout=PATIENCE)


def test_a_run_is_opened_in_the_world_at_a_tick_with_the_numbers_it_had(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot
) -> None:
    main, window = shown
    small(window, runs=1)
    window.begin()
    qtbot.waitUntil(lambda: window.pages.runs.model.rowCount() == 4, timeout=3 * PATIENCE)
    window.pages.setCurrentWidget(window.pages.runs)
    window.pages.runs.table.selectRow(1)
    row = window.pages.runs.chosen
    assert row is not None
    qtbot.mouseClick(window.pages.runs.open_button, Qt.MouseButton.LeftButton)

    def there() -> bool:
        snapshot = main.studio.snapshot
        return snapshot is not None and (snapshot.seed, snapshot.tick) == (row.seed, 200)

    qtbot.waitUntil(there, timeout=PATIENCE)
    assert main.studio.snapshot is not None
    measures = main.studio.snapshot.measures
    assert {name: measures[name] for name in row.measures} == row.measures


def test_an_experiment_is_paused_resumed_and_cancelled_and_keeps_what_is_finished(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot
) -> None:
    main, window = shown
    window.listing.choose("figure3")
    window.controls.ticks.setValue(2000)
    window.controls.runs.setValue(MANY)
    qtbot.keyClick(window, Qt.Key.Key_F5)
    qtbot.waitUntil(lambda: bool(window.pages.curves.names), timeout=3 * PATIENCE)
    with qtbot.waitSignal(window.studio.said, timeout=PATIENCE) as said:
        window.close()
    assert "goes on in the background" in said.args[0].text
    assert main.experiments.show() is window
    qtbot.mouseClick(window.controls.pause, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: told(window, "Paused at"), timeout=PATIENCE)
    assert window.controls.pause.text() == "Resume"
    pause, run = (
        button.icon().pixmap(16).toImage() for button in (window.controls.pause, window.controls.run)
    )
    assert pause == run  # it goes on
    assert window.pages.runs.model.rowCount() > 0
    qtbot.mouseClick(window.controls.pause, Qt.MouseButton.LeftButton)
    qtbot.mouseClick(window.controls.cancel, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(window.controls.run.isEnabled, timeout=3 * PATIENCE)
    qtbot.waitUntil(lambda: not window.background.busy, timeout=PATIENCE)
    assert len(made(window)) == window.pages.runs.model.rowCount() > 0


def test_leaving_while_an_experiment_runs_says_what_becomes_of_it_and_can_keep_it_running(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot
) -> None:
    main, window = shown
    window.listing.choose("figure3")
    window.controls.ticks.setValue(2000)
    window.controls.runs.setValue(MANY)
    qtbot.keyClick(window, Qt.Key.Key_F5)
    qtbot.waitUntil(lambda: window.pages.runs.model.rowCount() > 0, timeout=3 * PATIENCE)
    main.close()
    asked = question(main, qtbot)
    assert "'figure3' is under way" in asked.text
    assert f"of {4 * MANY:,} runs" in asked.text
    assert "Finished runs are kept" in asked.text
    qtbot.keyClick(asked, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: not main.files.is_asking, timeout=PATIENCE)
    qtbot.keyClick(window, Qt.Key.Key_Q, Qt.KeyboardModifier.ControlModifier)
    answer(main, qtbot, "Keep it running")
    assert main.isVisible()
    assert window.running.is_on
    main.studio.document.do(note_project, "changed")
    main.close()
    asked = question(main, qtbot)
    assert "unsaved changes" in asked.text
    assert "'figure3' is under way" in asked.text, "one question says all that there is"
    answer(main, qtbot, "Cancel")
    main.studio.document.undo()
    with qtbot.waitSignal(main.closed, timeout=PATIENCE):
        main.close()
        answer(main, qtbot, "Stop it")
    assert not window.running.is_on


def test_while_one_runs_others_are_looked_at_and_what_it_has_found_so_far_is_written(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot, tmp_path: Path
) -> None:
    _, window = shown
    small(window, "figure4", runs=1)
    window.begin()
    qtbot.waitUntil(lambda: finished(window), timeout=3 * PATIENCE)
    window.listing.choose("figure3")
    window.controls.ticks.setValue(2000)
    window.controls.runs.setValue(MANY)
    window.begin()
    qtbot.waitUntil(lambda: window.pages.runs.model.rowCount() > 0, timeout=3 * PATIENCE)
    window.pages.exporting.write_data(tmp_path / "x.csv")
    qtbot.waitUntil((tmp_path / "x-curves.csv").exists, timeout=PATIENCE)
    assert len((tmp_path / "x.csv").read_text().splitlines()) > 1
    window.listing.choose("figure4")
    qtbot.waitUntil(lambda: told(window, "Figure3 is running"), timeout=PATIENCE)
    window.controls.ticks.setValue(200)
    window.listing.choose("figure3")
    assert window.controls.ticks.value() == 2000
    qtbot.waitUntil(lambda: told(window, f"of {4 * MANY:,} runs"), timeout=PATIENCE)


def test_the_runs_are_sorted_by_what_they_came_to_and_the_chosen_one_stays_chosen(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot
) -> None:
    _, window = shown
    small(window, runs=3)
    window.begin()
    qtbot.waitUntil(lambda: finished(window) and not window.background.busy, timeout=3 * PATIENCE)
    page = window.pages.runs
    window.pages.setCurrentWidget(page)
    page.table.selectRow(2)
    chosen = page.chosen
    assert chosen is not None
    header = page.table.horizontalHeader()
    seed = QPoint(header.sectionViewportPosition(2) + 10, header.height() // 2)
    for descending in (False, True):
        qtbot.mouseClick(header.viewport(), Qt.MouseButton.LeftButton, pos=seed)
        seeds = [row.seed for row in page.model.rows]
        assert seeds == sorted(seeds, reverse=descending)
        assert page.chosen == chosen
    for key, row in ((Qt.Key.Key_End, -1), (Qt.Key.Key_Home, 0)):
        qtbot.keyClick(page.table, key)
        assert page.chosen == page.model.rows[row]


def test_an_experiment_is_built_by_hand_and_runs(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot, folder: Path
) -> None:
    _, window = shown
    qtbot.mouseClick(window.listing.new, Qt.MouseButton.LeftButton)
    (builder,) = window.findChildren(ExperimentBuilder)
    qtbot.keyClicks(builder.title, "Few boxes")
    for field, text in ((builder.ticks, "100"), (builder.runs, "2")):
        qtbot.keyClick(field, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
        qtbot.keyClicks(field, text)
    for row in range(1, builder.arms.count()):
        builder.arms.item(row).setCheckState(Qt.CheckState.Unchecked)
    builder.add_factor("", "1, 2")
    box = builder.factors.cellWidget(0, 0)
    assert isinstance(box, Chooser)
    qtbot.mouseClick(box.field, Qt.MouseButton.LeftButton)
    completer = box.completer()
    assert completer is not None
    assert completer.completionCount() == len(builder.settings())  # a click shows all that can be varied
    qtbot.keyClicks(box.field, "boxes")
    ok = builder.buttons.button(QDialogButtonBox.StandardButton.Ok)
    with qtbot.waitSignal(builder.kept, timeout=PATIENCE):
        qtbot.mouseClick(ok, Qt.MouseButton.LeftButton)
    assert (folder / "experiments" / "few-boxes.json").is_file()
    assert window.title.text() == "Few boxes"
    window.begin()
    qtbot.waitUntil(lambda: window.pages.runs.model.rowCount() == 4, timeout=3 * PATIENCE)


def test_a_new_claim_is_about_the_first_arms_that_take_part_and_one_arm_alone_never_stalls(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot, folder: Path
) -> None:
    _, window = shown
    qtbot.mouseClick(window.listing.new, Qt.MouseButton.LeftButton)
    (builder,) = window.findChildren(ExperimentBuilder)
    qtbot.keyClicks(builder.title, "Claims")
    builder.arms.item(0).setCheckState(Qt.CheckState.Unchecked)
    builder.tabs.setCurrentIndex(3)
    more = next(b for b in builder.findChildren(QPushButton) if b.text() == "Add a row" and b.isVisible())
    for _ in range(2):
        qtbot.mouseClick(more, Qt.MouseButton.LeftButton)
    says, other = builder.claims.cellWidget(1, 1), builder.claims.cellWidget(1, 2)
    assert isinstance(says, QComboBox)
    assert other is not None
    assert other.isEnabled()
    says.setCurrentText("never stalls")
    assert not other.isEnabled()
    with qtbot.waitSignal(builder.kept, timeout=PATIENCE):
        qtbot.mouseClick(
            builder.buttons.button(QDialogButtonBox.StandardButton.Ok), Qt.MouseButton.LeftButton
        )
    made = json.loads((folder / "experiments" / "claims.json").read_text())["claims"]
    first, second = (builder.arms.item(row).text() for row in (1, 2))
    assert (made[0]["greater"], made[0]["less"]) == (first, second)
    assert made[1]["never_stalls"] == first


def test_what_cannot_be_is_said_in_the_dialog(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot
) -> None:
    _, window = shown
    window.listing.build()
    (builder,) = window.findChildren(ExperimentBuilder)
    builder.name.setText("figure3")
    qtbot.mouseClick(builder.buttons.button(QDialogButtonBox.StandardButton.Ok), Qt.MouseButton.LeftButton)
    assert "there is an experiment 'figure3' already" in builder.trouble.text().replace("There", "there")
    builder.reject()


def test_figure_data_and_report_are_written(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot, tmp_path: Path
) -> None:
    _, window = shown
    small(window, runs=1)
    window.begin()
    qtbot.waitUntil(lambda: window.pages.runs.model.rowCount() == 4, timeout=3 * PATIENCE)
    for ending in ("svg", "png"):
        window.pages.exporting.write_figure(tmp_path / f"x.{ending}")
        qtbot.waitUntil((tmp_path / f"x.{ending}").exists, timeout=PATIENCE)
    window.pages.exporting.write_data(tmp_path / "x.csv")
    qtbot.waitUntil((tmp_path / "x-curves.csv").exists, timeout=PATIENCE)
    window.pages.exporting.write_report(tmp_path / "x.md")
    qtbot.waitUntil((tmp_path / "x.md").exists, timeout=PATIENCE)
    qtbot.waitUntil(lambda: told(window, "Written:"), timeout=PATIENCE)
    qtbot.waitUntil(lambda: not window.background.busy, timeout=PATIENCE)
    assert len((tmp_path / "x.csv").read_text().splitlines()) == 5


def test_results_of_several_experiments_stand_side_by_side(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot, folder: Path
) -> None:
    _, window = shown
    file = folder / "experiments" / "figure3.json"
    file.write_text(json.dumps({**json.loads(file.read_text()), "ticks": 200, "runs": 1}))
    window.listing.choose("figure4")
    small(window, runs=1)
    window.begin()
    qtbot.waitUntil(lambda: window.pages.runs.model.rowCount() == 4, timeout=3 * PATIENCE)
    compare = window.pages.compare
    compare.list.item(0).setCheckState(Qt.CheckState.Checked)
    qtbot.waitUntil(lambda: compare.model.rowCount() == 4, timeout=PATIENCE)
    across = range(compare.model.columnCount())
    head = [compare.model.headerData(column, Qt.Orientation.Horizontal) for column in across]
    assert head[:4] == ["experiment", "arm", "ticks", "runs"], "no empty column where nothing is varied"
    compare.list.item(1).setCheckState(Qt.CheckState.Checked)
    qtbot.waitUntil(lambda: "figure4 has not been run yet" in compare.told.text(), timeout=PATIENCE)


def test_runs_of_another_length_stand_side_by_side_with_the_others(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot
) -> None:
    _, window = shown
    small(window, runs=1)
    window.begin()
    qtbot.waitUntil(lambda: window.pages.runs.model.rowCount() == 4, timeout=3 * PATIENCE)
    compare = window.pages.compare
    window.pages.setCurrentWidget(compare)
    ticks = window.controls.ticks.value()
    found = compare.list.findItems(f"at {ticks:,} ticks", Qt.MatchFlag.MatchContains)
    assert [item.toolTip() for item in found] == [f"{window.listing.current}, {ticks:,} ticks"]
    window.listing.choose("figure4")
    window.listing.choose("figure3")
    qtbot.waitUntil(lambda: told(window, "there are runs of 200 ticks"), timeout=PATIENCE)
    found[0].setCheckState(Qt.CheckState.Checked)
    qtbot.waitUntil(lambda: compare.model.rowCount() == 4, timeout=PATIENCE)


def test_the_words_of_a_claim_are_seen_in_full(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot
) -> None:
    _, window = shown
    small(window, runs=1)
    window.begin()
    qtbot.waitUntil(lambda: window.pages.runs.model.rowCount() == 4, timeout=3 * PATIENCE)
    claims = next(view for view in window.findChildren(QTableView) if view.accessibleName() == "claims")
    window.pages.setCurrentWidget(claims)
    have_done_what_is_due()
    for row in range(claims.model().rowCount()):
        index = claims.model().index(row, 0)
        room = claims.visualRect(index).adjusted(4, 0, -4, 0)
        flags = Qt.TextFlag.TextWordWrap
        needed = claims.fontMetrics().boundingRect(QRect(0, 0, room.width(), 1000), flags, index.data())
        assert needed.height() <= room.height()


def test_results_of_the_project_as_it_was_can_be_put_aside(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot, folder: Path
) -> None:
    main, window = shown
    small(window, runs=1)
    window.begin()
    qtbot.waitUntil(lambda: finished(window) and not window.background.busy, timeout=3 * PATIENCE)
    main.studio.document.do(set_world, "", {"boxes": 7})
    window.begin()
    qtbot.waitUntil(lambda: bool(window.findChildren(Question)), timeout=PATIENCE)
    (question,) = window.findChildren(Question)
    qtbot.mouseClick(question.buttons[0], Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: finished(window), timeout=3 * PATIENCE)
    assert list((folder / "results").glob("figure3-200-ticks-until-*.sqlite"))
