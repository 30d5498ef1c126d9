"""Ctrl-C while others are at work: noted, and kept from the processes that are started."""

import signal
import subprocess
import sys

import pytest

from app.engine.interrupts import deaf_processes, noted_interrupts


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


def test_a_process_that_is_started_meanwhile_outlives_it() -> None:
    words = [sys.executable, "-c", "import signal; signal.raise_signal(signal.SIGINT); print('went on')"]
    with deaf_processes():
        deaf = subprocess.run(words, capture_output=True, text=True, check=False)
    assert deaf.stdout == "went on\n"
    other = subprocess.run(words, capture_output=True, text=True, check=False)
    assert other.stdout == ""
