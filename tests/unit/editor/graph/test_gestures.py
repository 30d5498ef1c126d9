"""What the hand does on the graph, gesture by gesture."""

from app.editor.graph.arrangement import Point
from app.editor.graph.gestures import Dragging, Idle, Linking, Pressed
from app.editor.graph.state_item import Path

STATE: Path = ("wander",)


class Journal:
    """A board that writes down what is asked of it."""

    def __init__(self) -> None:
        self.acts: list[object] = []

    def drag(self, path: Path, by: Point) -> None:
        self.acts.append(("drag", path, by))

    def drop(self, path: Path, by: Point) -> None:
        self.acts.append(("drop", path, by))

    def stretch(self, source: Path, to: Point) -> None:
        self.acts.append(("stretch", source, to))

    def link(self, source: Path, to: Point) -> None:
        self.acts.append(("link", source, to))

    def settle(self) -> None:
        self.acts.append("settle")


def test_a_click_moves_nothing() -> None:
    board = Journal()
    gesture = Pressed(board, STATE, (10.0, 10.0)).move((12.0, 11.0)).release((12.0, 11.0))
    assert isinstance(gesture, Idle)
    assert board.acts == []


def test_a_drag_begins_once_the_pointer_is_far_enough_and_ends_where_it_is_released() -> None:
    board = Journal()
    gesture = Pressed(board, STATE, (10.0, 10.0)).move((20.0, 10.0))
    assert isinstance(gesture, Dragging)
    assert isinstance(gesture.release((30.0, 15.0)), Idle)
    assert board.acts == [("drag", STATE, (10.0, 0.0)), ("drop", STATE, (20.0, 5.0))]


def test_a_drag_that_is_cancelled_leaves_all_as_it_was() -> None:
    board = Journal()
    gesture = Pressed(board, STATE, (0.0, 0.0)).move((20.0, 0.0)).cancel()
    assert isinstance(gesture, Idle)
    assert board.acts[-1] == "settle"
    assert gesture.release((20.0, 0.0)) == gesture


def test_a_link_follows_the_pointer_and_ends_at_what_is_there() -> None:
    board = Journal()
    gesture = Linking(board, STATE).move((5.0, 5.0)).release((9.0, 9.0))
    assert isinstance(gesture, Idle)
    assert board.acts == [("stretch", STATE, (5.0, 5.0)), "settle", ("link", STATE, (9.0, 9.0))]


def test_a_link_that_is_cancelled_is_none() -> None:
    board = Journal()
    Linking(board, STATE).move((5.0, 5.0)).cancel()
    assert board.acts == [("stretch", STATE, (5.0, 5.0)), "settle"]
