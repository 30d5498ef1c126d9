"""Transitions by hand: drawn, guarded, ordered, and made from what was learned."""

from functools import partial
from itertools import combinations

from PySide6.QtCore import QPoint, QRect, QRectF, Qt
from PySide6.QtWidgets import QComboBox, QScrollArea, QStyle, QStyleOptionComboBox, QToolButton, QWidget

from app.core.automaton import START
from app.core.conditions import AtMost, Condition, Equals
from app.editor.graph.edge_item import label_size
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from tests.gui.conftest import PATIENCE
from tests.gui.graph.author import Author, automaton

AUTHORED = BehaviorKey("authored-agent", "forage")
CORNER = QPoint(140, 90)
COMBO, EDIT_FIELD = QStyle.ComplexControl.CC_ComboBox, QStyle.SubControl.SC_ComboBoxEditField


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


def test_what_has_the_keys_in_a_form_is_in_sight(author: Author) -> None:
    author.show(AUTHORED)
    author.panel.resize(330, 420)
    author.link("Wander", "ReturnWithBox")
    author.test("DistanceTo(nearest visible box)")
    author.test("DistanceTo(deposit)")  # by now the form is higher than its place
    author.key(Qt.Key.Key_Escape)
    author.key(Qt.Key.Key_F2)
    author.come_back()
    (area,) = [each for each in author.panel.form.findChildren(QScrollArea) if each.isVisible()]

    def in_sight(field: QWidget) -> bool:
        shown = QRect(field.mapTo(area, QPoint(0, 0)), field.size())
        return area.viewport().rect().contains(shown)

    author.qtbot.waitUntil(lambda: area.verticalScrollBar().maximum() > 0)
    first, last = author.block.probability, author.row(1).numbers[0]
    for field, other in ((first, last), (last, first), (first, last)):
        field.setFocus()
        author.qtbot.waitUntil(partial(in_sight, field))
        assert not in_sight(other)


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


def test_in_a_narrow_panel_what_is_tested_can_be_read_in_full(author: Author) -> None:
    author.panel.resize(340, 600)
    author.show(AUTHORED)
    author.link("Wander", "ReturnWithBox")
    for number, what in enumerate(("IAmAttachedToABox", "DistanceTo(deposit)", "DirectionTo(deposit)")):
        author.test(what)
        box = author.row(number).what
        needed = box.fontMetrics().horizontalAdvance(what)
        assert box.style().subControlRect(COMBO, shown(box), EDIT_FIELD, box).width() >= needed


def shown(box: QComboBox) -> QStyleOptionComboBox:
    option = QStyleOptionComboBox()
    option.initFrom(box)
    return option
