"""What is to be done soon is done once, after all that is going on, or when it is needed."""

from functools import partial

import pytest
from PySide6.QtCore import QCoreApplication, QObject, Qt, Signal
from PySide6.QtWidgets import QApplication, QLineEdit, QWidget
from pytestqt.qtbot import QtBot

from app.editor.soon import Later, Soon, catch_up


@pytest.fixture
def done() -> list[str]:
    return []


@pytest.fixture
def soon(qapp: QApplication, done: list[str]) -> Soon:
    return Soon(qapp, lambda: done.append("it"))


def until_done(soon: Soon) -> None:
    """Have time for all that is due, in as many spells as it takes on a slow machine."""
    while soon.is_due:
        QCoreApplication.processEvents()


def test_it_is_done_once_however_often_it_is_asked_for(soon: Soon, done: list[str]) -> None:
    for _ in range(3):
        soon.ask()
    assert (soon.is_due, done) == (True, [])
    until_done(soon)
    assert done == ["it"]


def test_it_is_done_after_what_came_later_and_can_ask_for_it_too(soon: Soon, done: list[str]) -> None:
    class Sender(QObject):
        sent = Signal()

    sender = Sender()
    sender.sent.connect(lambda: done.append("other"), Qt.ConnectionType.QueuedConnection)
    sender.sent.connect(soon.ask, Qt.ConnectionType.QueuedConnection)
    soon.ask()
    sender.sent.emit()
    until_done(soon)
    assert done == ["other", "it"]


def test_after_a_spell_of_it_what_has_come_meanwhile_is_dealt_with_first(
    soon: Soon, done: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    class Sender(QObject):
        sent = Signal()

    monkeypatch.setattr("app.editor.soon.SPELL", 0.0)
    sender = Sender()
    sender.sent.connect(lambda: done.append("other"), Qt.ConnectionType.QueuedConnection)
    first = Soon(soon, sender.sent.emit)
    first.ask()
    soon.ask()
    until_done(soon)
    assert done == ["other", "it"]


def test_what_is_needed_now_is_done_now_and_not_again(soon: Soon, done: list[str]) -> None:
    soon.ask()
    catch_up()
    QCoreApplication.processEvents()
    assert done == ["it"]


def test_what_leads_to_more_is_done_with_that(soon: Soon, done: list[str]) -> None:
    first = Soon(soon, soon.ask)
    first.ask()
    catch_up()
    assert done == ["it"]


def test_what_was_put_off_can_be_given_up_and_asked_for_again(soon: Soon, done: list[str]) -> None:
    soon.ask()
    soon.forget()
    catch_up()
    assert done == []
    soon.ask()
    catch_up()
    assert done == ["it"]


def test_nothing_is_done_for_who_is_gone(qapp: QApplication, done: list[str]) -> None:
    owner = QObject()
    soon = Soon(owner, lambda: done.append("it"))
    soon.ask()
    del owner, soon
    catch_up()
    assert done == []


def test_a_key_waits_for_what_the_panel_that_gets_it_has_put_off_and_for_what_concerns_all_keys(
    qtbot: QtBot, soon: Soon, done: list[str]
) -> None:
    panels = [QWidget(), QWidget()]
    field = QLineEdit(panels[0])
    for name, panel in zip(("own", "other"), panels, strict=True):
        qtbot.addWidget(panel)
        Soon(panel, partial(done.append, name)).ask()
    Soon(panels[1], lambda: done.append("keys"), everywhere=True).ask()
    soon.ask()
    catch_up(field)
    assert done == ["own", "keys", "it"]
    catch_up(panels[1])
    assert done == ["own", "keys", "it", "other"]


# --------------------------------------------------------------------------------------------- what can wait


def test_what_can_wait_is_done_once_after_its_time(qapp: QApplication, done: list[str], qtbot: QtBot) -> None:
    later = Later(qapp, lambda: done.append("it"), 1)
    for _ in range(3):
        later.ask()
    assert later.is_due
    qtbot.waitUntil(lambda: not later.is_due)
    assert done == ["it"]


def test_no_key_waits_for_what_can_wait(qapp: QApplication, done: list[str]) -> None:
    later = Later(qapp, lambda: done.append("it"))
    later.ask()
    catch_up()
    assert (later.is_due, done) == (True, [])
    until_done(later)
    assert done == ["it"]


def test_what_is_due_before_the_next_key_is_done_first(
    soon: Soon, qapp: QApplication, done: list[str]
) -> None:
    later = Later(qapp, lambda: done.append("later"))
    later.ask()
    soon.ask()
    until_done(later)
    assert done == ["it", "later"]


def test_what_can_wait_can_be_hurried_and_given_up(qapp: QApplication, done: list[str]) -> None:
    later = Later(qapp, lambda: done.append("it"), 3_600_000)
    later.ask()
    later.hurry()
    until_done(later)
    assert done == ["it"]
    later.ask()
    later.forget()
    QCoreApplication.processEvents()
    assert (later.is_due, done) == (False, ["it"])


def test_between_two_that_can_wait_whatever_has_come_is_dealt_with(
    qapp: QApplication, done: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    class Sender(QObject):
        sent = Signal()

    monkeypatch.setattr("app.editor.soon.SPELL", 0.0)
    sender = Sender()
    sender.sent.connect(lambda: done.append("other"), Qt.ConnectionType.QueuedConnection)
    first, second = Later(qapp, sender.sent.emit), Later(qapp, lambda: done.append("it"))
    first.ask()
    second.ask()
    until_done(second)
    assert done == ["other", "it"]
