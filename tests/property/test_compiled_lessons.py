"""Tests of what was learned pass compiled, with the same results: who left what, what it saw, and the moment of that."""

from random import Random
from unittest.mock import patch

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.core.project import Arm, LevelTable, Project
from app.engine import departures
from app.engine.ask import Asking
from app.engine.commands import AskMe, LetGo, Others, Pick, RedoPick, ShouldNotHaveLeft, Teach, UndoPick
from app.engine.commands import Test as LearnAndTest
from app.engine.session import Session
from app.engine.snapshots import Mode
from app.sim.reference import ReferenceEngine
from app.sim.scenarios.foraging import scenario as foraging
from tests import foragers
from tests.property.test_session import Hand
from tests.samples import AGENT, GROUP, SQUAD, TYPES

SEEDS = st.integers(0, 1 << 32)
#: What is tested in which arm, and a state that is picked before.
TAUGHT = (
    ("alone", AGENT, "Wander", "forward"),
    ("alone", AGENT, "Goto", "forward"),
    ("alone", AGENT, "Forage", "wander"),
    ("groups", AGENT, "Wander", "left"),
    ("groups", GROUP, "ControlForage", "search"),
    ("squads", GROUP, "ControlForage", "search"),
    ("squads", AGENT, "Forage", "wander"),
)


def project() -> Project:
    arms = (
        Arm("alone", LevelTable((5,), (AGENT,)), "Forage"),
        Arm("groups", LevelTable((2, 3), (GROUP, AGENT)), "ControlForage"),
        Arm("squads", LevelTable((2, 2, 2), (SQUAD, GROUP, AGENT)), "ControlForage2"),
    )
    return Project("Foragers", "foraging", TYPES, libraries=foragers.libraries(), arms=arms)


class Mender:
    """Has an automaton tested, and mends what went wrong."""

    def __init__(self, engine: str, taught: tuple[str, str, str, str], others: Others) -> None:
        arm, kind, automaton, state = taught
        world = {f"world.{name}": value for name, value in foragers.BUSY.items()}
        self.session = Session(project(), foraging, arm, 7, settings={**world, "engine": engine})
        self.session.advance(30)
        nodes = [node for node in self.session.snapshot().place.ids if node.startswith(kind)]
        arguments = {"target": "deposit"} if automaton == "Goto" else {}
        self.session.send(Teach(kind, automaton, tuple(nodes[:1]), arguments, others))
        self.session.send(Pick(nodes[0], state))
        self.session.advance(2)
        self.session.send(LearnAndTest())
        self.nodes = nodes

    def act(self, random: Random) -> None:
        """Let time pass; mend something; take that back, some of it not after all, or go on testing without."""
        self.session.advance(random.choice((1, 2, 5, 30)))
        for node in random.sample(self.nodes, min(2, len(self.nodes))):
            self.session.send(ShouldNotHaveLeft(node))
        if random.random() < 0.8:
            while (lesson := self.session.snapshot().lesson) and lesson.acts > 1:
                self.session.send(UndoPick())
            for _ in range(random.randint(0, 2)):
                self.session.send(RedoPick())


@settings(max_examples=40)
@given(SEEDS, st.sampled_from(TAUGHT), st.sampled_from(Others))
def test_a_test_is_the_same_compiled(seed: int, taught: tuple[str, str, str, str], others: Others) -> None:
    compare(seed, taught, others)


@settings(max_examples=15)
@given(SEEDS, st.sampled_from(TAUGHT))
def test_a_test_is_the_same_compiled_where_little_can_be_remembered(
    seed: int, taught: tuple[str, str, str, str]
) -> None:
    with patch.object(departures, "MOST_NODES", 20), patch.object(departures, "MOST_UNASKED", 20):
        compare(seed, taught, Others.RUN)


def compare(seed: int, taught: tuple[str, str, str, str], others: Others) -> None:
    """Test and mend in both engines."""
    pair = [Mender(engine, taught, others) for engine in ("reference", "compiled")]
    for step in range(6):
        for mender in pair:
            mender.act(Random(seed + step))
        wanted, found = pair[0].session, pair[1].session
        assert found.snapshot() == wanted.snapshot()
        assert found.snapshot().mode is Mode.TESTING
        assert found.events() == wanted.events()
    assert pair[1].session.project == pair[0].session.project


@settings(max_examples=25)
@given(SEEDS, st.sampled_from(TAUGHT), st.sampled_from((0.45, 0.6, 1.0)))
def test_looking_only_where_a_state_may_be_in_doubt_asks_the_same(
    seed: int, taught: tuple[str, str, str, str], below: float
) -> None:
    everywhere, there = (Mender(engine, taught, Others.RUN) for engine in ("reference", "compiled"))
    random = Random(seed)
    for mender in (everywhere, there):
        mender.session.advance()
        mender.session.send(AskMe(tuple(mender.nodes), below, None))
    for _ in range(12):
        ticks, answers = random.choice((1, 3, 40)), random.random() < 0.3
        with patch.object(Asking, "_in_doubt", lambda *_: None):
            answer(everywhere.session, ticks, taught[3], answers=answers)
        answer(there.session, ticks, taught[3], answers=answers)
        assert there.session.snapshot() == everywhere.session.snapshot()
        assert there.session.events() == everywhere.session.events()


def answer(session: Session, ticks: int, state: str, *, answers: bool) -> None:
    """Let time pass; what is asked then is answered, or let go."""
    asked = session.advance(ticks).asked
    if asked is not None:
        session.send(Pick(asked.node, state) if answers else LetGo())


@settings(max_examples=20)
@given(SEEDS)
def test_any_hand_gives_the_same_project_compiled(seed: int) -> None:
    hands = [Hand(seed, engine, edits=True) for engine in ("reference", "compiled")]
    for _ in range(40):
        for hand in hands:
            hand.click()
            hand.hear()
        assert hands[0].session.snapshot() == hands[1].session.snapshot()
    assert hands[0].project == hands[1].project


def test_departures_are_mended_and_the_reference_engine_is_not_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    mender = Mender("compiled", TAUGHT[3], Others.RUN)
    monkeypatch.setattr(ReferenceEngine, "step", lambda *_: pytest.fail("a tick was not compiled"))
    mender.session.advance(200)
    picked = len(mender.session.project.examples_of(AGENT, "Wander"))
    for node in mender.nodes:
        mender.session.send(ShouldNotHaveLeft(node))
    assert len(mender.session.project.examples_of(AGENT, "Wander")) == picked + len(mender.nodes)
    assert len(mender.session.project.moments) > 1
