"""Importing in the window: what a file would bring is shown, and comes as one step."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialogButtonBox, QFileDialog, QLineEdit, QMenu, QPushButton
from pytestqt.qtbot import QtBot

from app.core.edits import add_automaton, delete_automaton, rename_automaton
from app.core.project import Project
from app.editor.exporting.import_dialog import ImportDialog
from app.editor.studio import Studio
from app.editor.window.main_window import MainWindow
from app.export.bundle import bundle_of_arm, bundle_of_behavior
from app.export.library_file import Exported, content, write
from app.sim.scenario import Scenario
from app.sim.scenarios import shipped
from tests.gui.conftest import PATIENCE, said

ALT_CONTROL = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier
Opening = Callable[[Path], ImportDialog]


@pytest.fixture
def scenario() -> Scenario:
    return shipped("foraging")


@pytest.fixture
def exported(foraging: Project, scenario: Scenario, tmp_path: Path) -> Path:
    """The arm with one level of controllers, in a file."""
    write(Exported(bundle_of_arm(foraging, scenario, "one level")), tmp_path / "one-level.json")
    return tmp_path / "one-level.json"


@pytest.fixture
def studio(studio: Studio, foraging: Project, scenario: Scenario, qtbot: QtBot) -> Studio:
    """A studio on a project with the arm of fifty agents, and nothing that they could learn from."""
    bare = replace(
        foraging,
        libraries={},
        examples={},
        demonstrations=(),
        moments={},
        layouts={},
        types=foraging.types[:1],
        arms=(replace(foraging.arms[0], top="Forward"),),
    )
    studio.open(bare, scenario, None)
    return studio


def press(window: MainWindow, key: Qt.Key, modifiers: Qt.KeyboardModifier, qtbot: QtBot) -> None:
    """Press a shortcut of the window, which is active again after a dialog."""
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow, timeout=PATIENCE)
    qtbot.keyClick(window, key, modifiers)


@pytest.fixture
def importing(window: MainWindow, qtbot: QtBot) -> Opening:
    """Opens the dialog as a user does: by the key, the name of the file, and Open."""

    def ask(path: Path) -> ImportDialog:
        press(window, Qt.Key.Key_I, ALT_CONTROL, qtbot)
        qtbot.waitUntil(lambda: bool(window.findChildren(QFileDialog)), timeout=PATIENCE)
        (chooser,) = window.findChildren(QFileDialog)
        field = chooser.findChild(QLineEdit, "fileNameEdit")
        assert isinstance(field, QLineEdit)
        field.setText(str(path))  # as if pasted: what is typed is completed, which takes its time
        box = chooser.findChild(QDialogButtonBox)
        assert isinstance(box, QDialogButtonBox)
        qtbot.mouseClick(box.button(QDialogButtonBox.StandardButton.Open), Qt.MouseButton.LeftButton)
        qtbot.waitUntil(lambda: bool(window.findChildren(ImportDialog)), timeout=PATIENCE)
        (dialog,) = window.findChildren(ImportDialog)
        return dialog

    return ask


def rows(dialog: ImportDialog) -> dict[str, str]:
    """What the table says becomes of each behavior."""
    table = dialog.table
    cells = [[table.item(row, column) for column in (0, 2)] for row in range(table.rowCount())]
    return {name.text(): fate.text() for name, fate in cells if name is not None and fate is not None}


def press_import(dialog: ImportDialog, qtbot: QtBot) -> None:
    qtbot.waitUntil(dialog.ok.isEnabled, timeout=PATIENCE)
    qtbot.mouseClick(dialog.ok, Qt.MouseButton.LeftButton)


def arm_shown(window: MainWindow) -> str:
    snapshot = window.studio.snapshot
    return "" if snapshot is None else snapshot.arm


def test_an_arm_comes_with_all_it_uses_as_one_step_that_is_undone(
    window: MainWindow,
    importing: Opening,
    exported: Path,
    qtbot: QtBot,
    foraging: Project,
    scenario: Scenario,
) -> None:
    document = window.studio.document
    before = document.project
    dialog = importing(exported)
    qtbot.waitUntil(lambda: rows(dialog).get("ControlForage") == "new", timeout=PATIENCE)
    assert "“one level”: 50 agents under 10 controllers" in dialog.arm.text()
    assert dialog.arm.isChecked()
    assert "New node type: group." in dialog.note.text()
    with qtbot.waitSignal(window.messages.shown, timeout=PATIENCE) as shown:
        press_import(dialog, qtbot)
    assert shown.args is not None
    assert "imported 5 new behaviors and the arm 'one level'" in shown.args[0]
    again = bundle_of_arm(document.project, scenario, "one level")
    assert content(Exported(again)) == content(Exported(bundle_of_arm(foraging, scenario, "one level")))
    assert document.history.undo_text == "Import Goto, ReturnWithBox, Wander, 2 more and the arm 'one level'"
    chosen = window.studio.selection.behavior
    assert chosen is not None
    assert (chosen.type, chosen.id) == ("group", "control-forage")
    (show,) = [b for b in window.messages.findChildren(QPushButton) if b.text() == "Show its world"]
    qtbot.mouseClick(show, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: arm_shown(window) == "one level", timeout=PATIENCE)
    press(window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier, qtbot)
    assert document.project is before


def test_without_the_arm_only_behaviors_come(
    window: MainWindow, importing: Opening, exported: Path, qtbot: QtBot
) -> None:
    document = window.studio.document
    dialog = importing(exported)
    qtbot.waitUntil(dialog.arm.isChecked, timeout=PATIENCE)
    qtbot.keyClick(dialog.arm, Qt.Key.Key_Space)
    press_import(dialog, qtbot)
    assert [arm.name for arm in document.project.arms] == ["independent"]
    assert document.project.library("agent").by_name("Forage") is not None


def test_of_a_behavior_s_file_only_the_behavior_comes_unless_its_arm_is_wanted(
    window: MainWindow,
    importing: Opening,
    tmp_path: Path,
    foraging: Project,
    scenario: Scenario,
    qtbot: QtBot,
) -> None:
    write(Exported(bundle_of_behavior(foraging, scenario, "agent", "wander")), tmp_path / "wander.json")
    dialog = importing(tmp_path / "wander.json")
    qtbot.waitUntil(lambda: rows(dialog).get("Wander") == "new", timeout=PATIENCE)
    assert "“Wander”" in dialog.arm.text()
    assert not dialog.arm.isChecked()
    press_import(dialog, qtbot)
    assert [arm.name for arm in window.studio.document.project.arms] == ["independent"]


def test_what_shares_a_name_and_what_is_here_is_said_before(
    window: MainWindow, importing: Opening, exported: Path, qtbot: QtBot
) -> None:
    document = window.studio.document
    document.do(add_automaton, "agent", "Wander", ["whither"])
    dialog = importing(exported)
    qtbot.waitUntil(lambda: rows(dialog).get("Wander", "").startswith("new, as Wander 2"), timeout=PATIENCE)
    press_import(dialog, qtbot)
    qtbot.waitUntil(lambda: not window.findChildren(ImportDialog), timeout=PATIENCE)
    dialog = importing(exported)
    qtbot.waitUntil(lambda: rows(dialog).get("Goto") == "here already, the same", timeout=PATIENCE)
    dialog.reject()


def test_where_all_of_it_is_here_nothing_can_be_imported(
    window: MainWindow, importing: Opening, exported: Path, qtbot: QtBot
) -> None:
    dialog = importing(exported)
    qtbot.waitUntil(dialog.arm.isChecked, timeout=PATIENCE)
    qtbot.keyClick(dialog.arm, Qt.Key.Key_Space)
    press_import(dialog, qtbot)
    qtbot.waitUntil(lambda: not window.findChildren(ImportDialog), timeout=PATIENCE)
    dialog = importing(exported)
    qtbot.waitUntil(dialog.ok.isEnabled, timeout=PATIENCE)  # since the arm is not here yet
    qtbot.keyClick(dialog.arm, Qt.Key.Key_Space)
    assert dialog.note.text() == "All of it is in the project already."
    assert not dialog.ok.isEnabled()
    dialog.reject()


def test_a_bad_file_is_told_and_another_name_can_be_typed(
    window: MainWindow, importing: Opening, exported: Path, tmp_path: Path, qtbot: QtBot
) -> None:
    (tmp_path / "bad.json").write_text('{"name": "x"}')
    dialog = importing(tmp_path / "bad.json")
    qtbot.waitUntil(lambda: "this is no export of Understudy" in dialog.trouble.text(), timeout=PATIENCE)
    assert not dialog.ok.isEnabled()
    dialog.path.selectAll()
    qtbot.keyClicks(dialog.path, str(exported))
    qtbot.keyClick(dialog.path, Qt.Key.Key_Tab)
    qtbot.waitUntil(lambda: "Forage" in rows(dialog), timeout=PATIENCE)
    assert not dialog.trouble.isVisible()
    qtbot.mouseClick(dialog.path, Qt.MouseButton.LeftButton)
    dialog.path.selectAll()
    qtbot.keyClick(dialog.path, Qt.Key.Key_Delete)
    qtbot.keyClick(dialog.path, Qt.Key.Key_Tab)
    qtbot.waitUntil(lambda: "Name the file to import" in dialog.trouble.text(), timeout=PATIENCE)
    assert not dialog.ok.isEnabled()
    dialog.reject()


def test_what_the_project_cannot_offer_is_named(
    window: MainWindow,
    importing: Opening,
    tmp_path: Path,
    foraging: Project,
    scenario: Scenario,
    qtbot: QtBot,
) -> None:
    source = bundle_of_behavior(foraging, scenario, "agent", "wander")
    text = content(Exported(source)).decode()
    text = text.replace('"RotateLeft"', '"Hover"').replace('"scenario": "foraging"', '"scenario": "drones"')
    (tmp_path / "drones.json").write_text(text)
    dialog = importing(tmp_path / "drones.json")
    qtbot.waitUntil(lambda: "basic behaviors: Hover" in dialog.trouble.text(), timeout=PATIENCE)
    assert "of the scenario 'drones'" in dialog.trouble.text()
    dialog.reject()


def test_a_change_of_the_project_meanwhile_is_taken_into_account(
    window: MainWindow, importing: Opening, exported: Path, qtbot: QtBot
) -> None:
    document = window.studio.document
    new = document.do(add_automaton, "agent", "Wander", ["whither"])
    dialog = importing(exported)
    qtbot.waitUntil(lambda: rows(dialog).get("Wander", "").startswith("new, as"), timeout=PATIENCE)
    document.do(rename_automaton, "agent", new, "Else")
    qtbot.waitUntil(lambda: rows(dialog).get("Wander") == "new", timeout=PATIENCE)
    document.do(delete_automaton, "agent", new)
    press_import(dialog, qtbot)
    assert document.project.library("agent").by_name("Wander") is not None


def test_import_and_export_stand_before_close_and_quit(window: MainWindow) -> None:
    menu = window.menuBar().actions()[0].menu()
    assert isinstance(menu, QMenu)
    texts = [said(action) for action in menu.actions()]
    assert texts.index("Import behaviors…") < texts.index("Export…") < texts.index("Close project")
    assert texts[-1] == "Quit"
