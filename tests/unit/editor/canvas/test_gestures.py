"""Gestures of the canvas as state machines, driven as a hand would, against a stage that only takes notes."""

from __future__ import annotations

from app.editor.canvas.gestures import Button, Choosing, Gesture, Pointer, Resting


class Notes:
    """A stage with one entity, number 7, at (50, 50), with which number 8 is moved."""

    def __init__(self, *, running: bool = False) -> None:
        self.said: list[tuple[object, ...]] = []
        self.running = running
        self.choosable = True

    def held_at(self, at: Pointer) -> tuple[int, ...]:
        return (7, 8) if abs(at.x - 50) < 10 and abs(at.y - 50) < 10 else ()

    def cannot_drag(self) -> str:
        return "pause first" if self.running else ""

    def click(self, at: Pointer) -> None:
        self.said.append(("click", at.x, at.y, at.adds))

    def choose(self, at: Pointer) -> bool:
        self.said.append(("choose", at.x, at.y))
        return self.choosable and bool(self.held_at(at))

    def give_up_choosing(self) -> None:
        self.said.append(("gave up",))

    def menu(self, at: Pointer) -> None:
        self.said.append(("menu", at.x, at.y))

    def pan(self, dx: float, dy: float) -> None:
        self.said.append(("pan", dx, dy))

    def show_band(self, first: Pointer, last: Pointer) -> None:
        self.said.append(("band", first.x, first.y, last.x, last.y))

    def take_band(self, first: Pointer, last: Pointer) -> None:
        self.said.append(("take", first.x, first.y, last.x, last.y))

    def drop_band(self) -> None:
        self.said.append(("drop band",))

    def preview(self, held: tuple[int, ...], at: Pointer) -> None:
        self.said.append(("preview", held, at.x, at.y))

    def put(self, held: tuple[int, ...], at: Pointer) -> None:
        self.said.append(("put", held, at.x, at.y))

    def drop_preview(self) -> None:
        self.said.append(("drop preview",))

    def say(self, why: str) -> None:
        self.said.append(("say", why))


class Driver:
    """A hand on a stage: each act gives the driver again."""

    def __init__(self, *, running: bool = False, gesture: Gesture | None = None) -> None:
        self.stage = Notes(running=running)
        self.gesture: Gesture = gesture or Resting()

    def pointer_down(self, x: float, y: float, button: Button = Button.LEFT, *, pans: bool = False) -> Driver:
        self.gesture = self.gesture.press(self.stage, button, Pointer(x, y, pans=pans))
        return self

    def pointer_move(self, x: float, y: float) -> Driver:
        self.gesture = self.gesture.move(self.stage, Pointer(x, y))
        return self

    def pointer_up(self, x: float, y: float) -> Driver:
        self.gesture = self.gesture.release(self.stage, Pointer(x, y))
        return self

    def escape(self) -> Driver:
        self.gesture = self.gesture.cancel(self.stage)
        return self

    def expect(self, *said: tuple[object, ...]) -> Driver:
        assert self.stage.said == list(said)
        return self


def test_a_press_that_hardly_moves_is_a_click() -> None:
    Driver().pointer_down(50, 50).pointer_move(52, 51).pointer_up(52, 51).expect(("click", 50, 50, False))


def test_a_drag_of_an_entity_previews_and_puts_it_once() -> None:
    driver = Driver().pointer_down(50, 50).pointer_move(70, 50).pointer_move(90, 60).pointer_up(90, 60)
    both = (7, 8)
    driver.expect(("preview", both, 70, 50), ("preview", both, 90, 60), ("put", both, 90, 60))
    assert driver.gesture == Resting()


def test_a_canceled_drag_puts_nothing_however_the_mouse_goes_on() -> None:
    driver = (
        Driver().pointer_down(50, 50).pointer_move(70, 50).escape().pointer_move(99, 99).pointer_up(99, 99)
    )
    driver.expect(("preview", (7, 8), 70, 50), ("drop preview",))
    assert driver.gesture == Resting()


def test_while_time_passes_a_drag_says_why_not_and_once() -> None:
    driver = (
        Driver(running=True).pointer_down(50, 50).pointer_move(70, 50).pointer_move(80, 50).pointer_up(80, 50)
    )
    driver.expect(("say", "pause first"))


def test_a_drag_over_the_ground_pulls_a_band_open() -> None:
    Driver().pointer_down(0, 0).pointer_move(20, 30).pointer_up(25, 35).expect(
        ("band", 0, 0, 20, 30), ("take", 0, 0, 25, 35)
    )


def test_a_canceled_band_selects_nothing() -> None:
    Driver().pointer_down(0, 0).pointer_move(20, 30).escape().pointer_up(20, 30).expect(
        ("band", 0, 0, 20, 30), ("drop band",)
    )


def test_middle_and_right_drags_and_space_move_the_view() -> None:
    Driver().pointer_down(0, 0, Button.MIDDLE).pointer_move(3, 4).pointer_up(3, 4).expect(("pan", 3, 4))
    Driver().pointer_down(0, 0, Button.RIGHT).pointer_move(9, 4).pointer_up(9, 4).expect(("pan", 9, 4))
    Driver().pointer_down(50, 50, pans=True).pointer_move(60, 50).pointer_up(60, 50).expect(("pan", 10, 0))


def test_a_right_click_that_does_not_move_asks_for_the_menu() -> None:
    Driver().pointer_down(5, 6, Button.RIGHT).pointer_up(5, 6).expect(("menu", 5, 6))


def test_choosing_goes_on_until_something_was_chosen_and_the_view_can_be_moved_meanwhile() -> None:
    driver = Driver(gesture=Choosing()).pointer_down(0, 0).pointer_up(0, 0)
    driver.pointer_down(0, 0, Button.MIDDLE).pointer_move(5, 0).pointer_up(5, 0)
    driver.pointer_down(50, 50).pointer_up(50, 50)
    driver.expect(("choose", 0, 0), ("pan", 5, 0), ("choose", 50, 50))
    assert driver.gesture == Resting()


def test_choosing_can_be_given_up() -> None:
    driver = Driver(gesture=Choosing()).escape().expect(("gave up",))
    assert driver.gesture == Resting()
