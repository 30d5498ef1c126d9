"""Threads for the tests, closed after them."""

from collections.abc import Callable, Iterator
from threading import Condition
from time import monotonic

import pytest

from app.engine.learning import WorkerLearner
from app.engine.session import Session
from app.engine.thread import EngineThread
from tests.corridor import corridor, project
from tests.driver import UNCOMPILED
from tests.unit.engine.threads import Make


@pytest.fixture
def start() -> Iterator[Make]:
    """Makes threads, and closes them."""
    made: list[EngineThread] = []

    def make(
        kind: type[Session] = Session, clock: Callable[[], float] = monotonic, wake: Condition | None = None
    ) -> EngineThread:
        def session(nudge: Callable[[], None]) -> Session:
            return kind(project(), corridor, "alone", learner=WorkerLearner(nudge), settings=UNCOMPILED)

        thread = EngineThread(session, clock, wake)
        made.append(thread)
        return thread

    yield make
    for thread in made:
        thread.close()
