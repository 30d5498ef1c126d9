"""Ctrl-C while others are at work: noted, and kept from the processes that are started."""

import signal
import subprocess
import sys

import pytest

from app.engine.interrupts import deaf_processes, ended_by_a_second, noted_interrupts


def test_ctrl_c_is_noted_and_raises_nothing() -> None:
    with noted_interrupts() as interrupts:
        assert not interrupts.came
        signal.raise_signal(signal.SIGINT)
        assert interrupts.came


def test_afterwards_it_raises_again() -> None:
    with noted_interrupts():
        pass
    with pytest.raises(KeyboardInterrupt):
        signal.raise_signal(signal.SIGINT)


def test_where_nothing_else_is_said_a_second_means_what_the_first_did() -> None:
    with noted_interrupts() as interrupts:
        for _ in range(2):
            signal.raise_signal(signal.SIGINT)
    assert interrupts.came


def test_a_second_ends_what_the_first_was_noted_for() -> None:
    ended: list[bool] = []
    with ended_by_a_second(lambda: ended.append(True)), noted_interrupts() as interrupts:
        signal.raise_signal(signal.SIGINT)
        assert (interrupts.came, ended) == (True, [])
        signal.raise_signal(signal.SIGINT)
        assert ended


def test_a_second_ends_what_goes_on_after_the_first_was_noted() -> None:
    ended: list[bool] = []
    with ended_by_a_second(lambda: ended.append(True)):
        with noted_interrupts():
            signal.raise_signal(signal.SIGINT)
        signal.raise_signal(signal.SIGINT)
    assert ended


def test_a_second_while_the_first_is_dealt_with_is_no_exception() -> None:
    ended: list[bool] = []
    with ended_by_a_second(lambda: ended.append(True)):
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
        signal.raise_signal(signal.SIGINT)
    assert ended


def test_each_time_the_first_is_the_first_again() -> None:
    for _ in range(2):
        with ended_by_a_second(lambda: None), pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)


def test_who_has_pressed_it_once_is_not_heard_while_the_program_is_on_its_way_out() -> None:
    before = signal.getsignal(signal.SIGINT)
    try:
        with ended_by_a_second(lambda: None, last=True), pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
        signal.raise_signal(signal.SIGINT)
    finally:
        signal.signal(signal.SIGINT, before)


def test_a_process_that_is_started_meanwhile_outlives_it() -> None:
    words = [sys.executable, "-c", "import signal; signal.raise_signal(signal.SIGINT); print('went on')"]
    with deaf_processes():
        deaf = subprocess.run(words, capture_output=True, text=True, check=False)
    assert deaf.stdout == "went on\n"
    other = subprocess.run(words, capture_output=True, text=True, check=False)
    assert other.stdout == ""
