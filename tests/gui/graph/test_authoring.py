"""Automata are made on the graph by mouse and keys: states, transitions, guards, order, copies."""

from itertools import combinations

import pytest
from PySide6.QtCore import QPoint, QRect, QRectF, Qt
from PySide6.QtWidgets import QScrollArea, QToolButton

from app.core.automaton import START, Automaton, Basic, Nested, RaiseFlag
from app.core.conditions import AtMost, Condition, Equals
from app.core.edits import add_automaton, add_state, duplicate_automaton
from app.core.features import Ground, Parameter
from app.editor.graph.edge_item import label_size
from app.editor.graph.editing import LEARNED_COPIED
from app.editor.graph.panel import GraphPanel
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from tests.gui.conftest import PATIENCE
from tests.gui.graph.author import CTRL, Author

AUTHORED = BehaviorKey("authored-agent", "forage")
CORNER = QPoint(140, 90)


@pytest.fixture
def blank(studio: Studio, author: Author) -> BehaviorKey:
    """An automaton without states, shown."""
    made = studio.document.do(add_automaton, "authored-agent", "Mine", ("X",))
    key = BehaviorKey("authored-agent", made)
    author.show(key)
    return key


def automaton(author: Author) -> Automaton:
    root = author.panel.root
    assert root is not None
    found = author.panel.studio.document.automaton(root.type, root.id)
    assert found is not None
    return found


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


def test_dragging_from_the_handle_draws_a_transition_and_asks_when(
    blank: BehaviorKey, author: Author
) -> None:
    author.add_state("Forward")
    author.link("Start", "Forward")
    (rule,) = automaton(author).rules
    assert (rule.source, rule.target, rule.guard, rule.probability) == (START, "forward", (), 1.0)
    assert author.panel.form.isVisible()


def test_a_transition_can_be_drawn_by_keys(blank: BehaviorKey, author: Author, studio: Studio) -> None:
    author.add_state("Forward")
    author.click(author.named("Start"))
    author.trigger("graph.link")
    author.qtbot.keyClick(author.panel.view, Qt.Key.Key_Down)
    author.key(Qt.Key.Key_Return)
    assert [(rule.source, rule.target) for rule in automaton(author).rules] == [(START, "forward")]


def test_escape_gives_up_drawing_a_transition(blank: BehaviorKey, author: Author, studio: Studio) -> None:
    author.add_state("Forward")
    author.click(author.named("Start"))
    author.trigger("graph.link")
    author.qtbot.keyClick(author.panel.view, Qt.Key.Key_Escape)
    author.click(author.named("Forward"))
    assert automaton(author).rules == ()


def test_a_transition_that_ends_nowhere_is_none(blank: BehaviorKey, author: Author) -> None:
    path = author.named("Start")
    author.qtbot.mouseMove(author.panel.view.viewport(), author.at(path))
    author.drag(author.at(path, author.panel.scene.states[path].handle_at()), CORNER)
    assert automaton(author).rules == ()


def test_guards_are_made_of_what_there_is(author: Author) -> None:
    author.show(AUTHORED)
    author.link("Wander", "ReturnWithBox")
    author.test("done")
    author.test("DistanceTo(deposit)", lambda row: author.type_number(row.numbers[0], "12.5"))
    rule = automaton(author).rules[-1]
    feature = rule.guard[1].test.feature
    assert rule.guard == (Condition(Equals("done", 1.0)), Condition(AtMost(feature, 12.5)))
    author.choose(author.row(0).how, "done")
    author.choose(author.row(1).how, "more than")
    assert [condition.wanted for condition in automaton(author).rules[-1].guard] == [True, False]


def test_probability_order_and_removal(author: Author, studio: Studio) -> None:
    author.show(AUTHORED)
    author.link("Wander", "ReturnWithBox")
    author.type_number(author.block.probability, "25")
    assert automaton(author).rules[-1].probability == 0.25
    author.press(author.block.earlier)
    assert [rule.probability for rule in automaton(author).rules_of("wander")] == [0.25, 1.0]
    author.press(author.panel.form.rules.blocks[0].removal)
    assert [rule.probability for rule in automaton(author).rules_of("wander")] == [1.0]


def test_a_rule_is_made_by_keys_alone_and_they_go_on_where_it_goes_on(
    blank: BehaviorKey, author: Author
) -> None:
    author.add_state("Forward")
    author.link("Start", "Forward")
    author.come_back()
    author.qtbot.waitUntil(author.block.add.hasFocus)
    assert author.block.add.text() == "Only when …"
    author.block.add.click()  # as Enter does in the window
    author.settle()
    author.qtbot.waitUntil(author.row(0).what.hasFocus)
    author.choose(author.row(0).what, "DistanceTo(deposit)")
    author.come_back()
    author.qtbot.waitUntil(author.row(0).what.hasFocus)
    author.row(0).removed.emit()
    author.settle()
    assert not automaton(author).rules[0].guard


def test_tab_goes_through_a_rule_as_it_is_read(author: Author) -> None:
    author.show(AUTHORED)
    author.link("Wander", "ReturnWithBox")
    author.test("DistanceTo(deposit)")
    block, row = author.block, author.row(0)
    wanted = [row.what, row.how, row.numbers[0]]
    author.qtbot.waitUntil(row.numbers[0].isVisible)
    row.what.setFocus()
    found = []
    for _ in wanted:
        found.append(author.panel.focusWidget())
        author.qtbot.keyClick(author.panel.focusWidget(), Qt.Key.Key_Tab)
    assert found == wanted
    while author.panel.focusWidget() is not block.add:  # what removes the test comes first
        author.qtbot.keyClick(author.panel.focusWidget(), Qt.Key.Key_Tab)
    author.qtbot.keyClick(block.add, Qt.Key.Key_Tab)
    assert author.panel.focusWidget() is author.panel.form.rules.more


def test_what_closes_a_form_covers_nothing_of_it(author: Author) -> None:
    author.click(author.named("Wander"))
    author.key(Qt.Key.Key_F2)
    strip = author.panel.form
    (close,) = [b for b in strip.findChildren(QToolButton) if b.accessibleName() == "Close the form"]
    (area,) = [a for a in strip.findChildren(QScrollArea) if a.isVisible()]
    ours, theirs = (QRect(w.mapTo(strip, QPoint(0, 0)), w.size()) for w in (close, area))
    assert not ours.intersects(theirs)
    author.press(close)
    assert not strip.isVisible()


def test_keys_stay_on_a_rule_that_is_tried_earlier(author: Author) -> None:
    author.show(AUTHORED)
    author.link("Wander", "ReturnWithBox")
    last = author.block.rule.id
    author.block.earlier.setFocus()
    author.block.earlier.click()
    author.settle()
    moved = next(block for block in author.panel.form.rules.blocks if block.rule.id == last)
    assert (moved.order, moved.earlier.isEnabled()) == (1, False)
    author.qtbot.waitUntil(moved.later.hasFocus)


def test_the_form_of_a_state_lists_its_rules_in_order_and_alt_with_an_arrow_moves_them(
    author: Author, studio: Studio
) -> None:
    author.show(AUTHORED)
    author.link("Wander", "Wander")
    author.click(author.named("Wander"))
    author.key(Qt.Key.Key_F2)
    rules = author.panel.form.state.rules
    before = [rule.id for rule in automaton(author).rules_of("wander")]
    assert [rules.list.item(row).text() for row in range(rules.list.count())] == [
        "1.  sees a box → ReturnWithBox",
        "2.  otherwise → Wander",
    ]
    rules.choose(before[1])
    author.qtbot.keyClick(rules.list, Qt.Key.Key_Up, Qt.KeyboardModifier.AltModifier)
    author.settle()
    assert [rule.id for rule in automaton(author).rules_of("wander")] == before[::-1]
    assert rules.current == before[1]
    author.qtbot.keyClick(rules.list, Qt.Key.Key_Delete)
    author.settle()
    assert [rule.id for rule in automaton(author).rules_of("wander")] == before[:1]


def test_the_keys_begin_in_what_a_new_state_leaves_open(blank: BehaviorKey, author: Author) -> None:
    author.add_state("Goto(X)")
    author.come_back()
    form = author.panel.form.state
    author.qtbot.waitUntil(form.slots["X"].hasFocus)
    author.qtbot.keyClick(form.slots["X"], Qt.Key.Key_Tab)
    author.qtbot.waitUntil(form.name.hasFocus)


def test_words_at_transitions_between_states_that_were_dropped_do_not_cover_each_other(
    blank: BehaviorKey, author: Author
) -> None:
    for name, place in (("Forward", QPoint(0, 90)), ("RotateLeft", QPoint(120, 0))):
        start = author.at(author.named("Start"))
        author.drop({"type": "authored-agent", "id": "", "basic": name}, start + place)
    author.link("Start", "Forward")
    author.link("Forward", "RotateLeft")
    level = author.panel.scene.levels[()]
    boxes = [
        QRectF(x - width / 2, y - height / 2, width, height)
        for key, run in level.runs.items()
        for (x, y), (width, height) in [(run.label, label_size(level.labels[key]))]
    ]
    assert not [(a, b) for a, b in combinations(boxes, 2) if a.intersects(b)]


def test_a_number_that_is_typed_is_one_step_to_undo(author: Author, studio: Studio) -> None:
    author.show(AUTHORED)
    author.link("Wander", "ReturnWithBox")
    steps = len(studio.document.history.steps)
    author.type_number(author.block.probability, "12.5")
    assert len(studio.document.history.steps) == steps + 1


def test_delete_removes_a_state_with_its_transitions(author: Author) -> None:
    author.show(AUTHORED)
    author.click(author.named("Wander"))
    author.key(Qt.Key.Key_Delete)
    assert [state.id for state in automaton(author).states] == [START, "return-with-box"]


def test_deleting_a_learned_transition_prunes_it_and_it_can_be_taken_back(
    author: Author, studio: Studio
) -> None:
    author.click_edge("wander", "return-with-box")
    author.key(Qt.Key.Key_Delete)
    edge = author.panel.scene.edges[(), "wander", "return-with-box"].edge
    assert edge.is_pruned
    assert studio.document.history.undo_text == "Prune the transition Wander → ReturnWithBox of Forage"
    author.click_edge("wander", "return-with-box")
    author.trigger("graph.unprune")
    assert author.panel.scene.edges[(), "wander", "return-with-box"].edge.is_open


def test_states_are_duplicated_with_their_transitions(author: Author) -> None:
    author.show(AUTHORED)
    author.click(author.named("Wander"))
    author.click(("return-with-box",), keys=CTRL)
    author.key(Qt.Key.Key_D, CTRL)
    found = automaton(author)
    assert len(found.states) == 5
    assert len(found.rules) == 5
    assert len(author.panel.scene.selected) == 2


@pytest.mark.parametrize("by_hand", [False, True])
def test_duplicates_cover_no_state(author: Author, by_hand: bool) -> None:
    if by_hand:
        place = author.at(author.named("Wander"))
        author.drag(place, place + QPoint(12, 0))
    author.click(author.named("Wander"))
    author.click(("return-with-box",), keys=CTRL)
    author.key(Qt.Key.Key_D, CTRL)
    level = author.panel.scene.levels[()]
    assert len(level.places) == 5
    boxes = [
        QRectF(x - width / 2, y - height / 2, width, height)
        for state, (x, y) in level.places.items()
        for width, height in [level.sizes[state]]
    ]
    assert not [(a, b) for a, b in combinations(boxes, 2) if a.intersects(b)]


def test_states_are_copied_into_another_automaton(author: Author, blank: BehaviorKey) -> None:
    author.show(AUTHORED)
    author.click(author.named("Wander"))
    author.click(("return-with-box",), keys=CTRL)
    author.key(Qt.Key.Key_C, CTRL)
    author.show(blank)
    author.key(Qt.Key.Key_V, CTRL)
    found = automaton(author)
    assert [state.content for state in found.states[1:]] == [Nested("wander"), Nested("return-with-box")]
    assert [(rule.source, rule.target) for rule in found.rules] == [
        ("wander", "return-with-box"),
        ("return-with-box", "wander"),
    ]


def test_what_copied_states_learned_comes_along_as_rules(author: Author, studio: Studio) -> None:
    top = studio.document.do(add_automaton, "agent", "Top")
    author.click(author.named("Wander"))
    author.click(("return-with-box",), keys=CTRL)
    author.key(Qt.Key.Key_C, CTRL)
    author.show(BehaviorKey("agent", top))
    with author.qtbot.waitSignal(studio.said) as said:
        author.key(Qt.Key.Key_V, CTRL)
    assert said.args is not None
    assert said.args[0].text == LEARNED_COPIED
    shown = {key[1:]: item.edge.rules[0].words for key, item in author.panel.scene.edges.items()}
    assert shown["wander", "return-with-box"] == "sees a box"
    assert shown["return-with-box", "wander"] == "done"


def test_states_of_an_automaton_that_is_gone_are_not_pasted_which_is_said(
    author: Author, studio: Studio, blank: BehaviorKey
) -> None:
    gone = studio.document.do(add_automaton, "agent", "Gone")
    studio.document.do(add_state, "agent", gone, Basic("Forward"))
    author.show(BehaviorKey("agent", gone))
    author.click(author.named("Forward"))
    author.key(Qt.Key.Key_C, CTRL)
    studio.undo()
    studio.undo()
    author.show(blank)
    with author.qtbot.waitSignal(studio.said) as said:
        author.key(Qt.Key.Key_V, CTRL)
    assert said.args is not None
    assert gone in said.args[0].text
    assert len(automaton(author).states) == 1


def test_states_copied_to_another_node_type_bring_along_what_that_lacks(
    author: Author, blank: BehaviorKey, studio: Studio
) -> None:
    stroll = studio.document.do(duplicate_automaton, "agent", "wander", "Stroll")
    top = studio.document.do(add_automaton, "agent", "Top")
    for held in ("forage", stroll):
        studio.document.do(add_state, "agent", top, Nested(held))
    author.show(BehaviorKey("agent", top))
    author.click(("forage",))
    author.click(("stroll",), keys=CTRL)
    author.key(Qt.Key.Key_C, CTRL)
    author.show(blank)
    with author.qtbot.waitSignal(studio.said) as said:
        author.key(Qt.Key.Key_V, CTRL)
    assert said.args is not None
    assert said.args[0].text == "Stroll came along to authored-agent, since the states hold it"
    assert [state.content for state in automaton(author).states[1:]] == [Nested("forage"), Nested("stroll")]
    assert len(studio.document.project.examples_of("authored-agent", "stroll")) == 10
    studio.undo()
    assert studio.document.automaton("authored-agent", "stroll") is None


def test_what_the_other_node_type_cannot_see_stays_behind_and_it_is_said(
    author: Author, studio: Studio
) -> None:
    group = BehaviorKey("group", studio.document.do(add_automaton, "group", "Lead"))
    author.click(author.named("Wander"))
    author.click(("return-with-box",), keys=CTRL)
    author.key(Qt.Key.Key_C, CTRL)
    author.show(group)
    with author.qtbot.waitSignal(studio.said) as said:
        author.key(Qt.Key.Key_V, CTRL)
    assert said.args is not None
    words = "transitions that look at ICanSeeABox did not: group cannot see that"
    assert said.args[0].text == f"{LEARNED_COPIED}; {words}"
    found = studio.document.automaton("group", group.id)
    assert found is not None
    assert [use.shown for use in found.features] == ["done"]


def test_what_rules_say_already_is_not_offered_to_become_rules_again(author: Author, studio: Studio) -> None:
    author.click(author.named("Wander"))
    author.trigger("graph.author")
    author.qtbot.waitUntil(lambda: not studio.actions["graph.author"].isEnabled(), timeout=PATIENCE)
    author.trigger("graph.unauthor")
    author.qtbot.waitUntil(studio.actions["graph.author"].isEnabled, timeout=PATIENCE)


def test_what_was_learned_becomes_rules_and_back(author: Author, studio: Studio) -> None:
    author.click(author.named("Wander"))
    author.trigger("graph.author")
    assert [rule.target for rule in automaton(author).rules_of("wander")] == ["return-with-box", "wander"]
    author.trigger("graph.unauthor")
    assert automaton(author).rules == ()


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
