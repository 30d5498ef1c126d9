"""Properties of the teaching session over random hands: whatever is clicked, in whatever order."""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from random import Random
from unittest.mock import patch

from hypothesis import given, settings
from hypothesis import strategies as st

from app.core.automaton import START, Basic, Content, Nested, RaiseFlag
from app.core.edits import (
    add_state,
    delete_automaton,
    disable_examples,
    enable_examples,
    remove_state,
    rename_arm,
    rename_automaton,
    rename_state,
    set_content,
    set_note,
)
from app.core.edits.place import with_examples
from app.core.errors import EditError
from app.core.features import FlagUp, Operation, Over, Sense, Statistic, TicksInState
from app.core.library import Library
from app.core.project import Project, Value
from app.core.vocabulary import DONE, FINISHED
from app.engine import keyframes
from app.engine.backfill import fill_values
from app.engine.commands import (
    AskMe,
    Command,
    GoTo,
    LetGo,
    MoveEntities,
    Others,
    Pause,
    Pick,
    Play,
    RedoMove,
    RedoPick,
    Reset,
    RunArm,
    ShouldNotHaveLeft,
    Step,
    Teach,
    UndoMove,
    UndoPick,
    UseArm,
    UseProject,
    Watch,
)
from app.engine.commands import Test as LearnAndTest
from app.engine.session import Session
from app.engine.snapshots import Edit, Moved, Refused, Snapshot, edited
from tests.corridor import corridor, features, project
from tests.driver import UNCOMPILED
from tests.samples import AGENT, GROUP

SEEDS = st.integers(0, 1 << 32)
EXAMPLES = 40
STEPS = 40
#: What was picked for a group and, at the same time, deleted by the caller cannot be entered any more.
GONE = "there is no basic behavior 'Stroll'; there are:"

LESSONS = {AGENT: ("Shuttle", "Seek"), GROUP: ("Lead",)}
CONTENTS: tuple[str | Content, ...] = (
    START,
    "up",
    "down",
    "signal",
    "nowhere",
    Basic("Up"),
    Basic("Jump"),
    Basic("Leave"),
    Nested("Stroll"),
    RaiseFlag("odd"),
    Basic("Stroll"),
    Basic("Nothing"),
)


def rich() -> Project:
    """The project, with features of every sort in all that is taught."""
    made = project()
    shuttle = made.library(AGENT).get("Shuttle")
    lead = made.library(GROUP).get("Lead")
    seen = features(coin=Sense("Coin"), finished=FlagUp(FINISHED))
    summed = features(
        mean=Statistic(Operation.MEAN, Sense("Place")),
        done=Statistic(Operation.COUNT, FlagUp(DONE), Over.SUBSIDIARIES),
        ticks=TicksInState(),
    )
    agents = made.library(AGENT).automata | {"Shuttle": replace(shuttle, features=shuttle.features + seen)}  # type: ignore[operator]  # a dict
    groups = {"Lead": replace(lead, features=summed)}
    return replace(made, libraries={**made.libraries, AGENT: Library(agents), GROUP: Library(groups)})


class Hand:
    """Clicks at random, hears of what came of it late or at once, and edits the project in between."""

    def __init__(self, seed: int, engine: str = "reference", /, *, edits: bool, **world: Value) -> None:
        self.random = Random(seed)
        self.project = rich()
        self.settings = {"engine": engine, **{f"world.{name}": value for name, value in world.items()}}
        self.session = Session(self.project, corridor, "groups", seed=seed % 100, settings=self.settings)
        self.applied = 0
        self._edits = edits

    def click(self) -> None:
        """Do anything."""
        choice = self.random.random()
        if choice < 0.35:
            self.session.advance(self.random.randint(1, 6))
        elif choice < 0.5 and self._edits:
            self.edit()
        else:
            self.send(self.command())

    def command(self) -> Command:
        """Any command."""
        nodes, lesson = [*self.session.snapshot().nodes, "nobody"], self.session._lesson
        likely = list(lesson._pupils) if lesson and self.random.random() < 0.9 else nodes
        node = self.random.choice(likely)
        kind = node.rpartition("-")[0]
        automaton = self.random.choice(LESSONS.get(kind, ("Nothing",)))
        arguments = {"target": "lamp"} if automaton == "Seek" else {}
        others = self.random.choice(list(Others))
        same = [n for n in nodes if n.startswith(kind)]
        choices: list[tuple[float, Callable[[], Command]]] = [
            (12, lambda: Pick(node, self.random.choice(CONTENTS))),
            (0.5 if lesson else 12, lambda: Teach(kind, automaton, (node,), arguments, others)),
            (0.5 if lesson else 4, lambda: Teach(kind, automaton, tuple(same[:2]), arguments, others)),
            (3, UndoPick),
            (2, RedoPick),
            (2, LearnAndTest),
            (3, lambda: ShouldNotHaveLeft(node)),
            (1, lambda: MoveEntities({self.random.randint(0, 3): (100.0 * self.random.random(), 0.0)})),
            (0.5, lambda: UndoMove(self.random.randint(1, 4))),
            (0.5, lambda: RedoMove(self.random.randint(1, 4))),
            (
                1,
                lambda: AskMe(
                    tuple(likely), self.random.choice([None, 0.9]), self.random.choice([None, 0.2])
                ),
            ),
            (6 if self.session.snapshot().asked else 0.2, LetGo),
            (0.2 if lesson else 2, lambda: GoTo(self.random.randint(-1, 90))),
            (0.5, lambda: Play(self.random.choice([None, 1.0, 0.0]))),
            (0.3, Pause),
            (0.3, lambda: Watch(tuple(likely))),
            (0.5, lambda: Step(self.random.randint(0, 5))),
            (0.3, lambda: Reset(self.random.choice([None, 5]))),
            (0.2, RunArm),
            (0.2, lambda: UseArm(self.random.choice(["alone", "groups", "squads", "desert"]), self.settings)),
        ]
        weights = [weight for weight, _ in choices]
        return self.random.choices([make for _, make in choices], weights)[0]()

    def edit(self) -> None:
        """Any edit of the caller's own, made without having heard of what is on its way."""
        state, where = self.random.choice(["up", "down", "signal", "jump"]), (AGENT, "Shuttle")
        ids = [e.id for e in self.project.examples_of(*where)][:3]
        change = self.random.choice(
            [
                lambda p: rename_state(p, *where, state, f"the {state}"),
                lambda p: remove_state(p, *where, state),
                lambda p: add_state(p, *where, Basic("Down"))[0],
                lambda p: set_content(p, *where, state, Basic("Up")),
                lambda p: disable_examples(p, *where, ids),
                lambda p: enable_examples(p, *where, ids),
                lambda p: rename_automaton(p, AGENT, "Signal", "Sign"),
                lambda p: delete_automaton(p, AGENT, "Signal", "Stroll"),
                lambda p: delete_automaton(p, AGENT, self.random.choice(["Seek", "Stroll"]), "Signal"),
                lambda p: rename_arm(p, "groups", "teams"),
                lambda p: set_note(p, *where, "changed"),
            ]
        )
        with suppress(EditError):
            self.project = change(self.project)
        self.send(UseProject(self.project, self.applied))

    def send(self, command: Command) -> None:
        """Send a command; what is refused must have changed nothing."""
        before, looked = self.session.project, self.session.snapshot()
        kept = self.session._events[:]
        self.session.send(command)
        new = self.session._events[len(kept) :]
        if any(isinstance(event, Refused) for event in new):
            after = self.session.snapshot()
            assert len(new) == 1
            assert self.session.project is before
            assert replace(after, acknowledged=looked.acknowledged) == looked
        self.session.settle()

    def hear(self) -> None:
        """Apply what the session has reported."""
        for event in self.session.events():
            if isinstance(event, Edit):
                self.applied += 1
                with suppress(EditError):
                    self.project = edited(self.project, event)


@settings(max_examples=EXAMPLES)
@given(SEEDS, st.floats(0.0, 1.0))
def test_events_applied_by_the_caller_give_the_sessions_project(seed: int, attention: float) -> None:
    hand = Hand(seed, edits=True)
    for _ in range(STEPS):
        hand.click()
        if hand.random.random() < attention:
            hand.hear()
            assert hand.project == hand.session.project
        failure = hand.session.snapshot().failure
        assert failure == "" or failure.startswith(GONE)
    hand.hear()
    assert hand.project == hand.session.project


@settings(max_examples=EXAMPLES)
@given(SEEDS)
def test_every_example_is_what_design_section_4_says_and_its_moment_tells_its_values(seed: int) -> None:
    hand = Hand(seed, edits=False)
    for _ in range(STEPS):
        hand.click()
    made = hand.session.project
    for type_name, automata in LESSONS.items():
        for automaton_id in automata:
            examples = made.examples_of(type_name, automaton_id)
            automaton = made.library(type_name).get(automaton_id)
            flags = {s.id for s in automaton.states if isinstance(s.content, RaiseFlag)} | {"ring"}
            assert all(e.label != START and e.source not in flags for e in examples)
            assert all(e.source == e.label for e in examples if e.continuation)
            bare = with_examples(
                made, type_name, automaton_id, tuple(replace(e, values={}) for e in examples)
            )
            filled = fill_values(bare, corridor, type_name, automaton_id)
            assert (filled.project.examples_of(type_name, automaton_id), filled.missed) == (examples, {})


@settings(max_examples=EXAMPLES)
@given(SEEDS)
def test_taking_everything_back_leaves_no_example(seed: int) -> None:
    hand = Hand(seed, edits=False)
    hand.send(Teach(AGENT, "Shuttle", ("agent-1", "agent-3"), others=Others.RUN))
    nodes = ("agent-1", "agent-2", "agent-3", "agent-4")
    for _ in range(STEPS):
        hand.random.choice(
            [
                lambda: hand.send(Pick(hand.random.choice(nodes), hand.random.choice(CONTENTS))),
                lambda: hand.send(ShouldNotHaveLeft(hand.random.choice(nodes))),
                lambda: hand.session.advance(hand.random.randint(1, 4)),
                lambda: hand.send(LearnAndTest()),
                lambda: hand.send(Reset()),
                lambda: hand.send(UndoPick()),
                lambda: hand.send(RedoPick()),
            ]
        )()
    learned = hand.session.project.library(AGENT).get("Shuttle").learned
    while hand.session._lesson and hand.session._lesson.acts:
        hand.send(UndoPick())
    assert hand.session.project.examples_of(AGENT, "Shuttle") == ()
    states = {s.id for s in rich().library(AGENT).get("Shuttle").states}
    if not learned:
        assert {s.id for s in hand.session.project.library(AGENT).get("Shuttle").states} == states


@settings(max_examples=EXAMPLES // 2)
@given(SEEDS)
def test_the_same_hand_gives_the_same_project(seed: int) -> None:
    projects = []
    for _ in range(2):
        hand = Hand(seed, edits=True)
        for _ in range(STEPS):
            hand.click()
            hand.hear()
        projects.append(hand.project)
    assert projects[0] == projects[1]


@settings(max_examples=EXAMPLES // 2)
@given(SEEDS, st.integers(0, 60), st.booleans())
def test_a_world_that_fails_takes_nothing_along_and_a_reset_begins_again(
    seed: int, when: int, spoils: bool
) -> None:
    hand = Hand(seed, edits=True, **{"spoils" if spoils else "breaks": when})
    for _ in range(STEPS):
        hand.click()
        hand.hear()
        assert hand.project == hand.session.project
    hand.session.send(Reset())
    assert (hand.session.snapshot().failure, hand.session.tick) == ("", 0)


class Traveler:
    """Lets a run go on, goes back and forth in it and moves things, and remembers what it looked like at each tick."""

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)
        self.session = Session(rich(), corridor, "squads", seed=seed % 100, settings=UNCOMPILED)
        self.seen: dict[int, Snapshot] = {}
        self.moves = 0

    def look(self) -> Snapshot:
        """What it looks like now; what is still remembered of this tick has to be the same."""
        now = replace(self.session.snapshot(), acknowledged=0)
        assert self.seen.setdefault(now.tick, now) == now
        return now

    def go_on(self) -> None:
        """Let some ticks pass."""
        for _ in range(self.random.randint(1, 30)):
            self.session.advance()
            self.look()

    def go(self) -> None:
        """Go to any tick, in any slices."""
        self.session.send(GoTo(self.random.randint(0, 150)))
        while self.session.due:
            self.session.advance(self.random.randint(1, 40))
        self.look()

    def touch(self) -> None:
        """Move something, or take a move back, or do it again: from here on, all may come in another way."""
        number = self.random.randint(1, self.moves + 1)
        choices: list[Command] = [
            MoveEntities({self.random.randint(0, 4): (100.0 * self.random.random(), 0.0)}),
            UndoMove(number),
            RedoMove(number),
        ]
        self.session.send(self.random.choice(choices))
        events = self.session.events()
        self.moves += sum(isinstance(event, Moved) for event in events)
        if not any(isinstance(event, Refused) for event in events):
            self.seen = {tick: look for tick, look in self.seen.items() if tick < self.session.tick}
            self.look()


@settings(max_examples=EXAMPLES)
@given(SEEDS)
def test_a_run_that_is_gone_back_and_forth_in_is_always_the_same_at_the_same_tick(seed: int) -> None:
    with patch.object(keyframes, "SPACING", 25), patch.object(keyframes, "MOST", 4):
        traveler = Traveler(seed)
        for _ in range(STEPS // 2):
            traveler.random.choice([traveler.go_on, traveler.go, traveler.touch])()
