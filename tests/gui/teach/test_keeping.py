"""What the hand does in a lesson is kept as a demonstration of the project, which plays it again."""

from PySide6.QtCore import QPoint, Qt

from app.core.project import Demonstration, Project
from app.engine.commands import MoveEntities, Reset
from app.engine.demonstrations import recreate
from app.engine.snapshots import Mode
from app.learner.trainer import fingerprint
from tests.gui.teach.hand import CONTROL, LEFT, SHIFT, Hand

WANDER = ("agent", "wander")


def project(hand: Hand) -> Project:
    return hand.studio.document.project


def kept(hand: Hand) -> list[str]:
    """The ids of the demonstrations of Wander that the shipped project lacks."""
    return [d.id for d in project(hand).demonstrations if d.automaton == "wander"][1:]


def newest(hand: Hand) -> Demonstration:
    return project(hand).demonstrations[-1]


def wait_until_learned(hand: Hand) -> None:
    """Let no time pass before what is run was learned from the examples that there are."""
    hand.wait(lambda: hand.automaton.learned_from == fingerprint(hand.automaton, hand.examples))
    hand.settle()


def test_a_lesson_in_the_window_is_played_again_without_it(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.hold(6)
    hand.pick("RotateLeft")
    hand.hold(4)
    hand.pick("Forward")
    hand.test()
    hand.hold(3)
    hand.pick("RotateRight")
    hand.hold(2)
    made = newest(hand)
    assert kept(hand) == [made.id] == ["wander-2"]
    assert "kept" in hand.page.badge.text()
    again = recreate(project(hand), hand.studio.document.scenario, [WANDER])
    assert again.examples_of(*WANDER) == hand.examples
    assert again.library("agent").get("wander").learned_from != ""


def test_a_lesson_in_which_a_pick_was_done_again_later_than_it_was_taken_back_is_kept(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.hold(4)
    hand.pick("RotateLeft")
    hand.hold(3)
    hand.undo()
    hand.hold(2)
    hand.act(lambda: hand.key(Qt.Key.Key_Z, CONTROL | SHIFT))
    hand.settle()
    hand.hold(2)
    hand.pick("Forward")
    hand.hold(2)
    assert "no demonstration" not in hand.page.badge.text()
    assert [act.act for act in newest(hand).picks] == ["teach", "pick", "pick", "undo", "redo", "pick"]
    again = recreate(project(hand), hand.studio.document.scenario, [WANDER])
    assert again.examples_of(*WANDER) == hand.examples


def test_a_pick_that_was_taken_back_and_done_again_in_a_test_is_kept(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.hold(4)
    hand.pick("RotateLeft")
    hand.hold(3)
    hand.test()
    hand.hold(2)
    hand.undo()
    wait_until_learned(hand)
    hand.hold(2)
    hand.act(lambda: hand.key(Qt.Key.Key_Z, CONTROL | SHIFT))
    wait_until_learned(hand)
    hand.hold(2)
    hand.pick("RotateRight")
    hand.hold(2)
    assert hand.studio.teaching.keeping.obstacle == ""
    assert {"test", "undo", "redo"} <= {act.act for act in newest(hand).picks}
    again = recreate(project(hand), hand.studio.document.scenario, [WANDER])
    assert again.examples_of(*WANDER) == hand.examples


def test_an_agent_that_was_dragged_in_a_lesson_is_dragged_again(hand: Hand) -> None:
    hand.studio.actions["canvas.fit"].trigger()
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.hold(3)
    canvas, entity = hand.window.canvas, hand.snapshot.place.agents.index("agent-3")
    x, y = (float(hand.snapshot.columns[name][entity]) for name in "xy")
    start, end = (
        QPoint(*(round(float(v)) for v in canvas.looking.camera.to_view(x + off, y))) for off in (0.0, 12.0)
    )
    hand.qtbot.mousePress(canvas, LEFT, pos=start)
    hand.qtbot.mouseMove(canvas, pos=(start + end) / 2)
    hand.qtbot.mouseMove(canvas, pos=end)
    hand.act(lambda: hand.qtbot.mouseRelease(canvas, LEFT, pos=end))
    assert float(hand.snapshot.columns["x"][entity]) > x + 6.0
    hand.pick("RotateLeft")
    hand.hold(2)
    assert "kept" in hand.page.badge.text()
    assert "move" in [act.act for act in newest(hand).picks]
    again = recreate(project(hand), hand.studio.document.scenario, [WANDER])
    assert again.examples_of(*WANDER) == hand.examples
    assert again.moments == project(hand).moments


def test_a_pick_and_its_place_in_the_demonstration_are_one_step(hand: Hand) -> None:
    untouched = project(hand)
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.hold(2)
    first = newest(hand)
    hand.pick("RotateLeft")
    hand.hold(2)
    assert len(newest(hand).picks) == 3
    hand.undo()
    assert newest(hand) == first
    hand.undo()
    assert kept(hand) == []
    assert project(hand).demonstrations == untouched.demonstrations


def test_where_it_would_not_do_the_same_it_is_not_kept_and_that_is_said(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.hold(2)
    assert kept(hand) == ["wander-2"]
    hand.act(lambda: hand.studio.bridge.send(MoveEntities({3: (10.0, 10.0)})))
    hand.hold(1)
    hand.undo()
    hand.pick("RotateLeft")
    assert kept(hand) == []
    assert "no demonstration" in hand.page.badge.text()
    assert "learned from like all else" in hand.page.badge.toolTip()
    assert "moved back" in hand.page.badge.toolTip()


def test_keeping_is_switched_off_before_a_lesson(hand: Hand) -> None:
    hand.show("Wander", "agent-3")
    hand.click(hand.panel.idle.keep)
    hand.wait(lambda: not hand.studio.actions["teach.keep"].isChecked())
    hand.key(Qt.Key.Key_T)
    hand.wait(lambda: hand.studio.mode is Mode.TEACHING)
    hand.pick("Forward")
    assert kept(hand) == []


def test_examples_of_lessons_that_were_not_kept_are_no_prey_of_one_that_is(hand: Hand) -> None:
    hand.studio.teaching.keeping.set_on(on=False)
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.hold(2)
    hand.key(Qt.Key.Key_Escape)
    hand.wait(lambda: hand.studio.mode is Mode.RUNNING)
    hand.act(lambda: hand.studio.bridge.send(Reset()))
    hand.studio.teaching.keeping.set_on(on=True)
    hand.settle()
    assert not hand.panel.idle.keep.isEnabled()
    assert "from no demonstration" in hand.panel.idle.keep.toolTip()
    hand.qtbot.mouseClick(hand.panel.idle.keep, LEFT)
    assert not hand.panel.idle.keep.isChecked()


def test_teaching_goes_on_after_a_test_in_the_same_demonstration(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.hold(3)
    hand.test()
    hand.hold(2)
    hand.key(Qt.Key.Key_T)
    hand.wait(lambda: hand.studio.mode is Mode.TEACHING)
    hand.settle()
    hand.pick("RotateLeft")
    assert kept(hand) == ["wander-2"]
    assert [act.act for act in newest(hand).picks] == ["teach", "pick", "test", "teach", "pick"]
