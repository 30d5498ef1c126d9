"""Learning beside the session: in a worker that can be given up, with answers that carry their revision."""

from collections.abc import Callable
from threading import Event
from typing import Any

import pytest

from app.core.edits import rename_state
from app.engine import learning, worker
from app.engine.commands import Teach
from app.engine.commands import Test as LearnAndTest
from app.engine.learning import Answer, InlineLearner, Question, WorkerLearner
from app.engine.snapshots import Mode, Refused
from app.learner.builder import LearningCancelled
from app.learner.trainer import Learned, learn
from tests.corridor import corridor
from tests.driver import Driver

PATIENCE = 60.0


def question(automaton: str = "Shuttle", revision: int = 1) -> Question:
    driver = Driver().teach("agent-1", "Shuttle").pick("up").advance()
    return Question(revision, driver.project, corridor.vocabulary, "agent", automaton)


class Bell:
    """Rings when an answer has come."""

    def __init__(self) -> None:
        self._rang = Event()

    def __call__(self) -> None:
        self._rang.set()

    def wait(self) -> None:
        assert self._rang.wait(PATIENCE)
        self._rang.clear()


class Gate:
    """Stands in for `learn`: works until the test opens the gate, or it is told to stop."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.begun, self.cancelled = Event(), Event()
        self._stirred = stirred = Event()
        self._learn: Callable[..., Learned] = learn

        class Stop(Event):
            """What a learner tells its worker to stop by; it wakes who waits at the gate."""

            def set(self) -> None:
                super().set()
                stirred.set()

        monkeypatch.setattr(learning, "learn", self)
        monkeypatch.setattr(worker, "Event", Stop)

    def open(self) -> None:
        """Let who waits go on."""
        self._stirred.set()

    def __call__(self, *args: Any, cancelled: Callable[[], bool], **kwargs: Any) -> Learned:
        self.begun.set()
        assert self._stirred.wait(PATIENCE)
        self._stirred.clear()
        if cancelled():
            self.cancelled.set()
            raise LearningCancelled
        return self._learn(*args, cancelled=cancelled, **kwargs)


@pytest.fixture
def gate(monkeypatch: pytest.MonkeyPatch) -> Gate:
    return Gate(monkeypatch)


def test_learning_inline_answers_at_once_and_once() -> None:
    learner = InlineLearner()
    asked = question()
    learner.ask(asked)
    (answer,) = learner.answers()
    assert answer.question is asked
    assert answer.learned is not None
    assert learner.answers() == []
    learner.close()


def test_a_worker_answers_when_it_is_done_and_wakes_who_asked() -> None:
    bell = Bell()
    learner = WorkerLearner(bell)
    asked = question()
    learner.ask(asked)
    bell.wait()
    (answer,) = learner.answers()
    assert answer.question is asked
    assert answer.learned is not None
    assert learner.answers() == []
    learner.close()


def test_a_worker_gives_no_answer_before_it_is_done(gate: Gate) -> None:
    bell = Bell()
    learner = WorkerLearner(bell)
    learner.ask(question())
    assert gate.begun.wait(PATIENCE)
    assert learner.answers() == []
    gate.open()
    bell.wait()
    assert len(learner.answers()) == 1
    learner.close()


def test_an_earlier_question_is_given_up_for_a_new_one(gate: Gate) -> None:
    bell = Bell()
    learner = WorkerLearner(bell)
    learner.ask(question(revision=1))
    assert gate.begun.wait(PATIENCE)
    learner.ask(question(revision=2))
    assert gate.cancelled.wait(PATIENCE)
    gate.open()
    answers: list[Answer] = []
    while not answers:
        bell.wait()
        answers = learner.answers()
    assert [a.question.revision for a in answers] == [2]
    learner.close()


def test_closing_while_it_learns_gives_up_and_leaves_no_thread(gate: Gate) -> None:
    learner = WorkerLearner()
    learner.ask(question())
    assert gate.begun.wait(PATIENCE)
    learner.close()
    assert gate.cancelled.is_set()


def test_what_cannot_be_learned_is_answered_with_the_reason() -> None:
    answer = learning.answer(question("Seek"))
    assert answer.learned is None
    assert "'Seek' has no examples to learn from" in answer.problem


def test_a_worker_that_breaks_down_answers_with_what_happened(monkeypatch: pytest.MonkeyPatch) -> None:
    def break_down(*args: object, **kwargs: object) -> Learned:
        raise RuntimeError("out of luck")

    monkeypatch.setattr(learning, "learn", break_down)
    bell = Bell()
    learner = WorkerLearner(bell)
    learner.ask(question())
    bell.wait()
    assert [answer.problem for answer in learner.answers()] == ["learning failed: RuntimeError: out of luck"]
    learner.close()


# ---------------------------------------------------------------------------------------------- in a session


class HandLearner:
    """Answers when the test says so."""

    def __init__(self) -> None:
        self.asked: list[Question] = []
        self._ready: list[Answer] = []

    def ask(self, question: Question) -> None:
        self.asked.append(question)

    def answer(self, number: int = -1) -> None:
        self._ready.append(learning.answer(self.asked[number]))

    def answers(self) -> list[Answer]:
        ready, self._ready = self._ready, []
        return ready

    def close(self) -> None:
        pass


def learning_session() -> tuple[Driver, HandLearner]:
    learner = HandLearner()
    driver = Driver(learner=learner).teach("agent-1", "Shuttle").pick("up").advance()
    driver.send(LearnAndTest())
    return driver, learner


def test_a_session_waits_for_the_answer() -> None:
    driver, learner = learning_session()
    assert driver.mode is Mode.LEARNING
    assert driver.advance(5).snapshot.tick == 1
    learner.answer()
    assert driver.advance().mode is Mode.TESTING
    assert driver.snapshot.tick == 2


def test_an_answer_with_an_old_revision_is_dropped_and_asked_anew() -> None:
    driver, learner = learning_session()
    driver.pick("down")
    learner.answer(0)
    driver.advance()
    assert (driver.mode, driver.automaton.learned) == (Mode.LEARNING, {})
    assert [asked.revision for asked in learner.asked] == [1, 2]
    learner.answer(1)
    driver.advance()
    assert driver.mode is Mode.TESTING
    assert set(driver.automaton.learned) == {"start", "up", "down"}


def test_an_edit_of_the_caller_while_it_learns_makes_the_answer_old() -> None:
    driver, learner = learning_session()
    driver.edit(rename_state, "agent", "Shuttle", "up", "Onward")
    learner.answer()
    assert driver.advance().mode is Mode.LEARNING
    assert learner.asked[-1].project is driver.session.project


def test_an_answer_that_nobody_waits_for_any_more_is_dropped() -> None:
    driver, learner = learning_session()
    driver.teach("agent-2", "Shuttle")
    learner.answer()
    driver.advance()
    assert (driver.mode, driver.automaton.learned) == (Mode.TEACHING, {})


def test_an_answer_about_another_lesson_is_dropped() -> None:
    driver, learner = learning_session()
    driver.teach("agent-1", "Seek", target="lamp").send(LearnAndTest())
    learner.answer(0)
    driver.advance()
    assert driver.mode is Mode.LEARNING
    assert driver.project.library("agent").get("Shuttle").learned == {}


def test_asking_twice_asks_again() -> None:
    driver, learner = learning_session()
    driver.send(LearnAndTest())
    learner.answer(0)
    assert driver.advance().mode is Mode.LEARNING
    learner.answer(1)
    assert driver.advance().mode is Mode.TESTING


def test_a_refusal_to_learn_carries_the_ticket_of_the_test() -> None:
    learner = HandLearner()
    driver = Driver(learner=learner).teach("agent-1", "Shuttle")
    ticket = driver.session.send(LearnAndTest())
    driver.session.send(Teach("agent", "Nowhere", ("agent-1",)))
    driver.session.events()
    learner.answer()
    driver.session.settle()
    (refusal,) = driver.session.events()
    assert isinstance(refusal, Refused)
    assert refusal.ticket == ticket
    assert driver.mode is Mode.TEACHING


def test_closing_a_session_closes_its_learner(gate: Gate) -> None:
    driver = Driver(learner=WorkerLearner()).teach("agent-1", "Shuttle").pick("up").advance()
    driver.send(LearnAndTest())
    assert gate.begun.wait(PATIENCE)
    driver.session.close()
    assert gate.cancelled.is_set()
