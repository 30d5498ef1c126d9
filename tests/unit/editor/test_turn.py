"""Work waits for the next turn where this one was long, but is done in the end."""

from time import thread_time

import pytest
from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QApplication

from app.editor.soon import Soon
from app.editor.turn import LONG, MOST, Patience, is_long


def work() -> None:
    """Be busy for longer than a turn should take."""
    end = thread_time() + 2 * LONG
    while thread_time() < end:
        pass


def test_a_turn_is_long_once_enough_was_done_in_it(qapp: QApplication) -> None:
    is_long()  # from now on turns are told apart
    QCoreApplication.processEvents()
    work()
    assert is_long()
    QCoreApplication.processEvents()
    assert not is_long()


def test_work_waits_while_turns_are_long_and_no_more_than_so_often(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.editor.turn.is_long", lambda: True)
    patience = Patience()
    for _ in range(2):
        assert [patience.waits() for _ in range(MOST + 1)] == [True] * MOST + [False]
    monkeypatch.setattr("app.editor.turn.is_long", lambda: False)
    assert not patience.waits()


def test_what_is_to_be_done_soon_is_left_to_the_next_turn_after_a_long_one(
    qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> None:
    long, done = [True], list[str]()
    monkeypatch.setattr("app.editor.turn.is_long", lambda: long[0])
    soon = Soon(qapp, lambda: done.append("it"))
    soon.ask()
    QCoreApplication.processEvents()
    assert done == []
    long[0] = False
    while soon.is_due:
        QCoreApplication.processEvents()
    assert done == ["it"]
