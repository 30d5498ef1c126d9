"""How ticks are dealt out: on an injected clock, with ticks that cost what the test says."""

from dataclasses import dataclass

import pytest

from app.engine.pace import MOST_BEHIND, SLICE, WINDOW, Pace


@dataclass
class FakeSession:
    """Something to deal out ticks to."""

    speed: float | None = 1.0
    due: int = 0
    revision: int = 0
    acknowledged: int = 1
    mode: str = "running"
    stopped: bool = False

    @property
    def playing(self) -> bool:
        return (self.speed != 0.0 or self.due > 0) and not self.stopped


class Loop:
    """The thread's loop without a thread: sleeps, deals out, works, shows.

    Attributes:
        slices: Seconds that each round worked.
    """

    def __init__(
        self, session: FakeSession, cost: float = 1e-5, showing: float = 1e-3, late: float = 0.0
    ) -> None:
        self.now = 100.0
        self.session = session
        self.cost, self.showing, self.late = cost, showing, late
        self.pace = Pace(lambda: self.now)
        self.ticks = self.rounds = 0
        self.slices: list[float] = []

    def go_on(self, seconds: float) -> int:
        """Let the loop run for some seconds; the ticks that passed meanwhile."""
        before, end = self.ticks, self.now + seconds
        while self.now < end:
            delay = self.pace.delay(self.session)
            if delay is None:
                self.now = end
                break
            self.now += delay + self.late * (delay > 0.0)
            self.round()
        return self.ticks - before

    def round(self) -> int:
        """One round."""
        self.rounds += 1
        ticks = self.pace.ticks(self.session)
        if ticks:
            self.now += ticks * self.cost
            self.slices.append(ticks * self.cost)
            self.pace.passed(ticks)
            self.session.due = max(0, self.session.due - ticks)
        self.now += self.showing
        self.ticks += ticks
        return ticks


@pytest.mark.parametrize("late", [0.0, 0.004])
@pytest.mark.parametrize("speed", [0.1, 0.5, 1.0, 1.5, 2.0, 7.0, 60.0, 1000.0])
def test_a_speed_of_one_is_sixty_ticks_a_second_and_others_in_proportion_within_a_percent(
    speed: float, late: float
) -> None:
    loop = Loop(FakeSession(speed), cost=1e-6, late=late)
    loop.go_on(1.0)  # to get going
    seconds = max(20.0, 20.0 / speed)
    assert loop.go_on(seconds) == pytest.approx(60.0 * speed * seconds, rel=0.01)


def test_a_world_that_just_keeps_up_is_on_time() -> None:
    loop = Loop(FakeSession(1.0), cost=0.012)
    loop.go_on(1.0)
    assert loop.go_on(20.0) == pytest.approx(1200, rel=0.01)


def test_a_world_that_cannot_keep_up_is_not_chased() -> None:
    loop = Loop(FakeSession(10.0), cost=0.01)
    loop.go_on(10.0)
    loop.cost = 1e-6  # all at once it could
    ticks = loop.go_on(0.5)
    assert ticks <= 600 * (0.5 + MOST_BEHIND) + 1


def test_a_computer_that_slept_is_not_chased() -> None:
    loop = Loop(FakeSession(1.0))
    loop.go_on(1.0)
    loop.now += 3600.0
    assert loop.go_on(1.0) <= 60 * (1.0 + MOST_BEHIND) + 1


def test_a_slow_world_never_owes_ticks_when_it_plays_again() -> None:
    loop = Loop(FakeSession(1.0))
    loop.go_on(1.0)
    loop.session.speed = 0.0
    loop.round()
    loop.now += 10.0
    loop.session.speed = 1.0
    assert loop.round() == 0
    assert loop.go_on(1.0) == pytest.approx(60, abs=1)


def test_between_ticks_the_loop_sleeps() -> None:
    loop = Loop(FakeSession(1.0), cost=1e-5, showing=1e-5)
    loop.go_on(10.0)
    assert loop.rounds <= 620


def test_at_high_speed_the_loop_rests_a_slice_between_rounds_instead_of_waking_for_each_tick() -> None:
    loop = Loop(FakeSession(1000.0), cost=1e-7)
    loop.go_on(10.0)
    assert loop.rounds <= 10.0 / SLICE + 2


def test_at_very_low_speed_the_loop_sleeps_until_the_next_tick() -> None:
    loop = Loop(FakeSession(0.01))
    assert loop.go_on(100.0) == pytest.approx(60, abs=1)
    assert loop.rounds <= 150


def test_no_delay_is_given_while_paused() -> None:
    assert Loop(FakeSession(0.0)).pace.delay(FakeSession(0.0)) is None


def test_as_fast_as_it_can_uses_the_whole_slice() -> None:
    loop = Loop(FakeSession(None), cost=1e-5, showing=0.0)
    loop.go_on(1.0)
    assert loop.ticks * loop.cost > 0.99
    assert loop.slices[-1] == pytest.approx(SLICE, rel=0.01)
    assert loop.pace.delay(loop.session) == 0.0


@pytest.mark.parametrize("cost", [1e-6, 1e-4, 4e-3, 0.2])
def test_as_fast_as_it_can_answers_commands_after_a_slice_or_a_single_tick(cost: float) -> None:
    loop = Loop(FakeSession(None), cost=cost)
    loop.go_on(5.0)
    assert max(loop.slices) <= max(SLICE, cost) * 1.01


def test_ticks_that_get_dearer_after_a_command_do_not_make_a_long_slice() -> None:
    loop = Loop(FakeSession(None), cost=1e-5)
    loop.go_on(1.0)
    loop.session.acknowledged += 1
    loop.cost = 0.1
    loop.go_on(1.0)
    assert max(loop.slices) <= 0.11


@pytest.mark.parametrize("change", ["revision", "mode"])
def test_ticks_that_get_dearer_after_learning_do_not_make_a_long_slice(change: str) -> None:
    loop = Loop(FakeSession(None), cost=1e-5)
    loop.go_on(1.0)
    setattr(loop.session, change, "another")
    loop.cost = 0.1
    loop.go_on(1.0)
    assert max(loop.slices) <= 0.11


def test_a_step_passes_just_its_ticks_without_waiting() -> None:
    loop = Loop(FakeSession(0.0, due=250), cost=1e-5, showing=0.0)
    assert loop.go_on(0.1) == 250
    assert loop.pace.delay(loop.session) is None


def test_the_rate_is_measured_over_half_a_second_or_so() -> None:
    loop = Loop(FakeSession(1.0))
    loop.go_on(WINDOW + 0.2)
    assert loop.pace.rate == pytest.approx(60.0, rel=0.05)
    loop.session.speed = 5.0
    loop.go_on(2 * WINDOW + 0.2)
    assert loop.pace.rate == pytest.approx(300.0, rel=0.05)


def test_the_rate_is_zero_once_all_ticks_have_passed_that_were_due() -> None:
    loop = Loop(FakeSession(speed=0.0, due=5_000), cost=1e-3)
    loop.go_on(2.0)
    assert loop.pace.rate > 0.0
    loop.go_on(30.0)
    assert loop.session.due == 0
    assert loop.pace.rate == 0.0


def test_the_rate_is_zero_when_paused() -> None:
    loop = Loop(FakeSession(1.0))
    loop.go_on(1.0)
    loop.session.speed = 0.0
    loop.round()
    assert loop.pace.rate == 0.0
