"""A newcomer builds the hand-coded forager with mouse and keys alone, and it does what the shipped one does."""

from collections.abc import Iterator
from functools import partial

import pytest
from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QDialogButtonBox
from pytestqt.qtbot import QtBot

from app.core.edits import add_arm, add_type
from app.core.hierarchy import from_table
from app.core.project import Arm, Project, Value
from app.editor.graph.condition_row import ConditionRow
from app.editor.graph.panel import GraphPanel
from app.editor.library.new_automaton import NewAutomatonDialog
from app.editor.library.panel import LibraryPanel
from app.editor.studio import Studio
from app.engine.runs import run, treatment
from app.sim.scenario import Scenario
from tests.gui.conftest import PATIENCE
from tests.gui.graph.author import LEFT, Author

MINE, TICKS, SEED = "mine", 4_000, 7
CORNERS = [QPoint(120, 60), QPoint(560, 60), QPoint(120, 300), QPoint(560, 300), QPoint(340, 380)]


@pytest.fixture
def library(studio: Studio, qtbot: QtBot) -> Iterator[LibraryPanel]:
    """The library with a node type that has no behaviors yet."""
    studio.settings.learns_by_itself = False
    studio.document.do(add_type, MINE)
    studio.document.do(add_arm, Arm("mine", from_table((4,), (MINE,)), "Forage"))
    studio.document.do(add_arm, Arm("theirs", from_table((4,), ("authored-agent",)), "Forage"))
    panel = LibraryPanel(studio)
    qtbot.addWidget(panel)
    panel.show()
    yield panel
    panel.hide()


def new(author: Author, library: LibraryPanel, name: str, *, parameter: bool = False) -> None:
    """Make an automaton in the library's dialog; it is shown then."""
    author.trigger("behavior.new")
    dialog = next(found for found in library.findChildren(NewAutomatonDialog) if found.isVisible())
    if dialog.general.types.currentText() != MINE:
        author.choose(dialog.general.types, MINE)
    if parameter:
        author.qtbot.mouseClick(dialog.general.add, LEFT)
    dialog.general.name.selectAll()
    author.qtbot.keyClicks(dialog.general.name, name)
    author.qtbot.mouseClick(dialog.buttons.button(QDialogButtonBox.StandardButton.Ok), LEFT)
    author.qtbot.waitUntil(lambda: _shown(author.panel) == name, timeout=PATIENCE)
    author.settle()


def _shown(panel: GraphPanel) -> str:
    root = panel.root
    automaton = None if root is None else panel.studio.document.automaton(root.type, root.id)
    return "" if automaton is None else automaton.name


def drop(author: Author, name: str, place: QPoint) -> None:
    """Drag a behavior from the library."""
    found = author.panel.studio.document.project.library(MINE).by_name(name)
    author.drop({"type": MINE, "id": found.id if found is not None else "", "name": name}, place)


def states(author: Author, *names: str) -> None:
    """Drag several behaviors."""
    for name, place in zip(names, CORNERS, strict=False):
        drop(author, name, place)


def when(what: str, how: str = "", *numbers: str) -> partial[None]:
    """A test for the rule that was drawn last."""

    def compare(author: Author, row: ConditionRow) -> None:
        if how and row.how.currentText() != how:
            author.choose(row.how, how)

    def test(author: Author) -> None:
        place = len(author.block.rows)
        author.test(what)
        compare(author, author.row(place))
        for number, text in enumerate(numbers):
            author.type_number(author.row(place).numbers[number], text)

    return partial(test)


def rule(author: Author, source: str, target: str, *tests: partial[None], percent: str = "") -> None:
    """Draw a transition and say when."""
    author.link(source, target)
    for test in tests:
        test(author)
    if percent:
        author.type_number(author.block.probability, percent)


def build_wander(author: Author, library: LibraryPanel) -> None:
    new(author, library, "Wander")
    states(author, "Forward", "RotateLeft", "RotateRight")
    rule(author, "Start", "Forward")
    rule(author, "Forward", "RotateLeft", percent="0.5")
    rule(author, "Forward", "RotateRight", percent="0.5")
    rule(author, "RotateLeft", "Forward", percent="3")
    rule(author, "RotateRight", "Forward", percent="3")


def build_goto(author: Author, library: LibraryPanel) -> None:
    new(author, library, "Goto", parameter=True)
    states(author, "Forward", "RotateLeft", "RotateRight", "Done")
    for source in ("Start", "Forward", "RotateLeft", "RotateRight"):
        rule(author, source, "Done", when("DistanceTo(X)", "more than", "500"))
        rule(author, source, "Done", when("DistanceTo(X)", "at most", "0.3"))
        ahead = "-3.437746770785", "3.437746770785"
        rule(author, source, "Forward", when("DirectionTo(X)", "between", *ahead))
        rule(author, source, "RotateLeft", when("DirectionTo(X)", "between", "0", "180"))
        rule(author, source, "RotateRight")


def build_return(author: Author, library: LibraryPanel) -> None:
    new(author, library, "ReturnWithBox")
    box = "nearest visible box"
    states(author, "Goto", "GrabBox")
    author.click(author.named("Goto"))
    author.choose(author.panel.form.state.slots["X"], box)
    drop(author, "Goto", CORNERS[2])
    author.choose(author.panel.form.state.slots["X"], "deposit")
    drop(author, "ReleaseBoxAndFinish", CORNERS[3])
    drop(author, "Done", CORNERS[4])
    near, home = f"Goto({box})", "Goto(deposit)"
    far = when(f"DistanceTo({box})", "more than", "500")
    attached = when("IAmAttachedToABox")
    rule(author, "Start", home, attached)
    rule(author, "Start", "Done", far)
    rule(author, "Start", near)
    rule(author, near, "Done", far)
    rule(author, near, "GrabBox", when(f"DistanceTo({box})", "at most", "4.5"))
    rule(author, "GrabBox", home, attached)
    rule(author, "GrabBox", near)
    rule(author, home, "ReleaseBoxAndFinish", when("IAmAttachedToABox", "is attached to no box"))


def build_forage(author: Author, library: LibraryPanel) -> None:
    new(author, library, "Forage")
    states(author, "Wander", "ReturnWithBox")
    rule(author, "Start", "Wander")
    rule(author, "Wander", "ReturnWithBox", when("ICanSeeABox"))
    rule(author, "ReturnWithBox", "Wander", when("done"))


def test_a_newcomer_builds_the_hand_coded_forager(
    author: Author, library: LibraryPanel, studio: Studio
) -> None:
    for build in (build_wander, build_goto, build_return, build_forage):
        build(author, library)
    project, scenario = studio.document.project, studio.document.scenario
    results = [outcome(project, arm, scenario) for arm in ("mine", "theirs")]
    assert results[0] == results[1]


def outcome(project: Project, arm: str, scenario: Scenario) -> object:
    """How a world looks after some time, on the engine that needs no compiling."""
    settings: dict[str, Value] = {"engine": "reference", "world.boxes": 20}
    made = treatment(project, scenario, project.arm(arm), settings)
    result = run(made, SEED, TICKS)
    return result.measures, result.curve, result.world
