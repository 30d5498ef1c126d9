"""Long work in a thread of its own, of which only what was asked for last still counts."""

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, wait
from threading import Event, current_thread
from typing import Any

import pytest

from app.engine.worker import Worker

PATIENCE = 60.0


class _Slow(ThreadPoolExecutor):
    """Takes so long to take work on that quick work could be done by then."""

    def submit(self, *arguments: Any, **options: Any) -> Future[Any]:
        future = super().submit(*arguments, **options)
        wait([future], timeout=0.05)
        return future


def test_who_asks_has_finished_asking_when_the_answer_comes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.engine.worker.ThreadPoolExecutor", _Slow)
    told_in, told = list[str](), Event()

    def ready() -> None:
        told_in.append(current_thread().name)
        told.set()

    def double(number: int, _cancelled: Callable[[], bool]) -> int:
        return 2 * number

    worker = Worker(double, lambda _question, _why: -1, ready, "worker")
    worker.ask(4)
    assert told.wait(PATIENCE)
    assert told_in == ["worker_0"]
    assert worker.answers() == [8]
    assert worker.answers() == []
    worker.close()
