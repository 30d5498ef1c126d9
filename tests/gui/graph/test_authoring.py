"""Automata are made on the graph by mouse and keys: states, transitions, guards, order, copies."""

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QLineEdit

from app.core.automaton import START, Basic, Nested, RaiseFlag
from app.core.edits import add_automaton
from app.core.features import Ground, Parameter
from app.editor.graph.panel import GraphPanel
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from tests.gui.graph.author import Author, automaton

AUTHORED = BehaviorKey("authored-agent", "forage")
CORNER = QPoint(140, 90)


def test_a_behavior_that_is_dropped_becomes_a_state_where_it_fell(blank: BehaviorKey, author: Author) -> None:
    author.drop({"type": "authored-agent", "id": "wander", "name": "Wander"}, CORNER)
    state = automaton(author).states[-1]
    assert state.content == Nested("wander")
    assert (author.at((state.id,)) - CORNER).manhattanLength() <= 3


def test_a_basic_behavior_can_be_dropped_as_well(blank: BehaviorKey, author: Author) -> None:
    author.drop({"type": "authored-agent", "id": "", "basic": "Forward"}, CORNER)
    assert automaton(author).states[-1].content == Basic("Forward")


def test_dropping_and_placing_is_one_step_to_undo(blank: BehaviorKey, author: Author, studio: Studio) -> None:
    author.drop({"type": "authored-agent", "id": "", "basic": "Forward"}, CORNER)
    assert studio.document.history.undo_text == "Add state Forward to Mine"
    studio.undo()
    assert len(automaton(author).states) == 1
    assert not studio.document.project.layouts


def test_an_automaton_cannot_be_dropped_into_itself(author: Author, studio: Studio) -> None:
    told: list[str] = []
    studio.said.connect(lambda message: told.append(message.text))
    author.show(BehaviorKey("authored-agent", "goto"))
    author.drop({"type": "authored-agent", "id": "forage", "name": "Forage"}, CORNER)
    author.drop({"type": "authored-agent", "id": "goto", "name": "Goto"}, CORNER)
    assert len(automaton(author).states) == 5
    assert any("recursion is not permitted" in text for text in told)


def test_the_menu_offers_only_what_a_state_can_hold(author: Author) -> None:
    author.show(BehaviorKey("authored-agent", "return-with-box"))
    author.trigger("graph.add_state")
    menu = author.panel.menu
    assert menu is not None
    offered = [action.text() for action in menu.actions()]
    assert {"Goto(X)", "Wander", "Forward", "⚑ done", "⚑ failed"} <= set(offered)
    assert not {"Forage", "ReturnWithBox"} & set(offered)
    menu.close()


def test_a_long_menu_of_states_is_searched_by_typing(
    blank: BehaviorKey, author: Author, studio: Studio
) -> None:
    for number in range(200):
        studio.document.do(add_automaton, blank.type, f"Behavior {number}")
    studio.document.do(add_automaton, blank.type, "Pick & drop")
    author.settle()
    author.trigger("graph.add_state")
    menu = author.panel.menu
    assert menu is not None
    offered = [action.text() for action in menu.actions() if action.text().startswith("Behavior")]
    assert offered[1:3] == ["Behavior 1", "Behavior 2"]
    assert menu.width() < menu.height() < 700  # one column, on every screen
    seen = [action.text() for action in menu.actions() if action.isVisible()]
    assert seen[seen.index("Automata") + 1 :][:3] == ["Behavior 0", "Behavior 1", "Behavior 2"]
    assert {"199 more: type to find them", "Forward", "⚑ done"} < set(seen)
    field = menu.findChild(QLineEdit)
    assert isinstance(field, QLineEdit)
    author.qtbot.waitUntil(lambda: menu.focusWidget() is field)
    author.qtbot.keyClicks(field, "drop & k")
    assert [entry.text() for entry in menu.actions() if entry.isVisible()][1:] == [
        "Pick && drop",
        "⚑ another flag…",
    ]
    field.clear()
    author.qtbot.keyClicks(field, "behavior 1")
    author.qtbot.waitUntil(lambda: menu.height() < 700)
    assert any(action.text() == "95 more: type on to find them" for action in menu.actions())
    field.clear()
    author.qtbot.keyClicks(field, "behavior 2")
    left = [action.text() for action in menu.actions() if action.isVisible() and action.text()]
    assert left == ["Behavior 2", *(f"Behavior 2{n}" for n in range(10)), "⚑ another flag…"]
    author.qtbot.keyClick(field, Qt.Key.Key_Down)
    author.qtbot.keyClick(field, Qt.Key.Key_Return)
    author.settle()
    assert [state.content for state in automaton(author).states[1:]] == [Nested("behavior-20")]


def test_a_slot_that_is_open_is_asked_for_and_bound(blank: BehaviorKey, author: Author) -> None:
    author.add_state("Goto(X)")
    form = author.panel.form
    assert form.isVisible()
    assert author.panel.scene.states["goto",].look.problem == "error"
    author.choose(form.state.slots["X"], "X (parameter)")
    assert automaton(author).state("goto").content == Nested("goto", {"X": Parameter("X")})
    author.choose(form.state.slots["X"], "deposit")
    assert automaton(author).state("goto").content == Nested("goto", {"X": Ground("deposit")})


def test_a_flag_can_be_added_and_named(blank: BehaviorKey, author: Author) -> None:
    author.add_state("⚑ done")
    author.click(author.named("done"))
    author.key(Qt.Key.Key_F2)
    field = author.panel.form.state.flag
    field.selectAll()
    author.qtbot.keyClicks(field, "lost")
    author.qtbot.keyClick(field, Qt.Key.Key_Return)
    assert automaton(author).states[-1].content == RaiseFlag("lost")


def test_a_state_can_be_named_and_noted(blank: BehaviorKey, author: Author) -> None:
    author.add_state("Forward")
    author.click(author.named("Forward"))
    author.key(Qt.Key.Key_Return)
    form = author.panel.form.state
    author.qtbot.keyClicks(form.name, "Walk")
    author.qtbot.keyClick(form.name, Qt.Key.Key_Return)
    author.qtbot.keyClicks(form.note, "straight on")
    author.qtbot.keyClick(form.note, Qt.Key.Key_Return)
    author.settle()
    state = automaton(author).states[-1]
    assert (state.name, state.note) == ("Walk", "straight on")


def test_the_keys_begin_in_what_a_new_state_leaves_open(blank: BehaviorKey, author: Author) -> None:
    author.add_state("Goto(X)")
    author.come_back()
    form = author.panel.form.state
    author.qtbot.waitUntil(form.slots["X"].hasFocus)
    author.qtbot.keyClick(form.slots["X"], Qt.Key.Key_Tab)
    author.qtbot.waitUntil(form.name.hasFocus)


def test_problems_show_at_their_place_as_they_arise(
    panel: GraphPanel, blank: BehaviorKey, author: Author
) -> None:
    author.add_state("Forward")
    author.add_state("RotateLeft")
    author.link("Start", "Forward")
    item = panel.scene.states["rotate-left",]
    assert item.look.problem == "warning"
    assert "never entered" in item.toolTip()
    author.link("Forward", "RotateLeft")
    assert "never entered" not in panel.scene.states["rotate-left",].toolTip()


def test_what_mends_a_problem_is_offered_at_its_place(author: Author, studio: Studio) -> None:
    author.show(AUTHORED)
    author.link("Start", "ReturnWithBox")
    assert author.panel.scene.edges[(), START, "return-with-box"].problem == "warning"
    author.panel.view.menu_wanted.emit(author.panel.view.mapToGlobal(CORNER))
    menu = author.panel.menu
    assert menu is not None
    author.pick(menu, "Fix: remove the rule")
    assert [rule.target for rule in automaton(author).rules_of(START)] == ["wander"]
    assert studio.document.history.undo_text == "Remove the rule"


def test_escape_closes_the_form_from_a_list_of_choices_too(blank: BehaviorKey, author: Author) -> None:
    author.add_state("Goto(X)")
    author.come_back()
    slot = author.panel.form.state.slots["X"]
    author.qtbot.waitUntil(slot.hasFocus)
    author.qtbot.keyClick(slot, Qt.Key.Key_Escape)
    assert not slot.view().isVisible()
    assert not author.panel.form.isVisible()


def test_escape_closes_the_form_from_the_graph_as_from_its_fields(author: Author) -> None:
    form = author.panel.form
    author.click(author.named("Wander"))
    author.key(Qt.Key.Key_F2)
    assert form.isVisible()
    author.key(Qt.Key.Key_Escape)
    assert not form.isVisible()
    author.key(Qt.Key.Key_F2)
    author.qtbot.keyClick(form.state.name, Qt.Key.Key_Escape)
    assert not form.isVisible()
