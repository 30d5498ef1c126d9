"""What the hand does in a world as a literal demonstration, as long as playing that would record the same examples."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from ..core.automaton import Automaton, State
from ..core.project import Arm, Demonstration, Pick, Project, Value
from ..learner.trainer import fingerprint
from .commands import Teach

#: What a setting of a session begins with that a demonstration has a place for.
WORLD = "world."
#: Others that it may have: what it is played with in any case, or what changes nothing (None: whatever it is).
PLAIN = {"physics": "kinematic", "engine": None}
#: An act: what was taken back last is done again.
REDO = "redo"
AGAIN = "Reset the world (Ctrl+R) before the next lesson, and it can be kept"


@dataclass(frozen=True, slots=True)
class _Undone:
    """A pick was taken back: the pick, if it was one of this transcript, and how that was written down, if it was.

    Attributes:
        at: Where the pick stood among the acts, if it was forgotten instead.
    """

    pick: Pick | None
    written: Pick | None
    last: Pick | None
    tick: int
    at: int


class Transcript:
    """The acts of a lesson in the world that is going on.

    Attributes:
        obstacle: Why playing the acts would not do the same; empty if it would.
    """

    def __init__(self, arm: str, seed: int, settings: Mapping[str, Value]) -> None:
        self.begin(arm, seed, settings)

    def begin(self, arm: str, seed: int, settings: Mapping[str, Value]) -> None:
        """Another world begins, in which nothing was done yet."""
        self._arm, self._seed = arm, seed
        self._parameters = {k.removeprefix(WORLD): v for k, v in settings.items() if k.startswith(WORLD)}
        self._plan: Teach | None = None
        self._over = self._edited = False
        self._acts: list[Pick] = []
        self._live: list[Pick] = []  # those of the acts whose examples are there
        self._gone: list[tuple[Pick, Pick]] = []  # those whose examples went, with the acts that they went by
        self._added: dict[str, State] = {}
        self._moves: dict[int, Sequence[Pick]] = {}
        self._undone: list[_Undone] = []
        # The tick from which on something is run that was learned from other examples; and before the test that waits.
        self._stale: int | None = None
        self._stale_before: int | None = None
        self._again: Pick | None = None  # what was done again, but not carried out yet
        other = {k: v for k, v in settings.items() if not k.startswith(WORLD)}
        odd = [f"{k} {v}" for k, v in other.items() if PLAIN.get(k, "") not in (None, v)]
        self.obstacle = f"it is played without {' and '.join(odd)}" if odd else ""

    def spoil(self, why: str) -> None:
        """From here on playing would not do the same."""
        self.obstacle = self.obstacle or why

    # ------------------------------------------------------------------------------------------- the acts

    def teach(self, plan: Teach, tick: int) -> None:
        """Nodes are taught from this tick on."""
        self._come_to(tick)
        before, self._plan, self._undone = self._plan, plan, []
        if before is not None and self._is_as_begun(tick):
            before, self._acts, self._added = None, [], {}
        if before is None:
            if self._edited and tick > 0:
                self.spoil(f"the project was changed while the world ran. {AGAIN}")
        elif self._over or replace(before, nodes=()) != replace(plan, nodes=()):
            self.spoil(f"this world has been taught in before. {AGAIN}")
            self._acts, self._live, self._added = [], [], {}
        self._over = False
        acts = [Pick(tick, node, act="teach") for node in plan.nodes]
        if self._acts and (self._acts[-1].act, self._acts[-1].tick) == ("teach", tick):
            if self._acts[-len(acts) :] != acts:
                self.spoil(f"others were taught at the same tick before. {AGAIN}")
            return  # it was asked for twice
        self._acts += acts

    def _is_as_begun(self, tick: int) -> bool:
        """Whether the world is as it began, however often somebody was about to be taught in it."""
        return tick == 0 and all(act.act == "teach" for act in self._acts)

    def test(self, tick: int) -> None:
        """What was taught is learned and tested."""
        self._come_to(tick)
        self._stale_before, self._stale = self._stale, None
        self._acts.append(Pick(tick, "", act="test"))

    def not_tested(self) -> None:
        """It could not be learned."""
        self._stale = self._stale_before
        if self._acts and self._acts[-1].act == "test":
            self._acts.pop()

    def pick(self, act: Pick, *, learning: bool = False, added: State | None = None) -> None:
        """Something was taught by a pick or the like, perhaps while a test waited for what it learns.

        Args:
            added: The state that the automaton has since this pick.
        """
        self._come_to(act.tick)
        self._undone = []
        if added is not None:
            self._added[added.id] = added
        for old in self._waiting(act, learning=learning):
            if old.act != REDO:
                act = self._replaced(old, act, learning=learning)
            elif old is self._again:
                self.spoil(f"what was done again was replaced at once. {AGAIN}")
        self._insert(act, learning=learning)
        self._live.append(act)

    def _waiting(self, act: Pick, *, learning: bool) -> list[Pick]:
        """What was taught the same node and no tick has carried out."""
        return [
            old
            for old in self._live
            if old.node == act.node and self._waits(old, act.tick, learning=learning)
        ]

    def _waits(self, act: Pick, tick: int, *, learning: bool) -> bool:
        """Whether the next tick is to carry out an act: one from before a test, or before nodes are taught anew, never is."""
        acts = self._acts[:-1] if learning else self._acts  # the last is a test that has not begun
        begun = [at for at, done in enumerate(acts) if done.act in ("test", "teach")]
        since = self._acts[begun[-1] + 1 if begun else 0 :]
        return act.tick == tick and any(done is act for done in since)

    def _replaced(self, old: Pick, act: Pick, *, learning: bool) -> Pick:
        """A second pick before the next tick replaces the first, which is as if it had never been.

        Where something else was taught or learned between, the first is played, too: examples are numbered in a row.

        Returns:
            The second as it is to be played: what replaces an answer is one.
        """
        if old.act == "answer" and act.act == "pick":
            act = replace(act, act="answer")
        elif old.act == "answer" and act.act != "answer":
            self.spoil("an answer was replaced by what should not have been left")
        if old is self._live[-1] and self._leaves_no_trace(old, learning=learning):
            self._forget(old)
        else:
            self._live = [other for other in self._live if other is not old]
            self._gone.append((old, act))
        return act

    def _leaves_no_trace(self, act: Pick, *, learning: bool) -> bool:
        """Whether all is as if an act had never been, once it is gone before a tick has carried it out."""
        return not self._is_learned(act, learning=learning) and all(by is not act for _, by in self._gone)

    def _is_learned(self, act: Pick, *, learning: bool) -> bool:
        """Whether something was learned since: then any node may do what it has taught."""
        acts = self._acts[:-1] if learning else self._acts
        after = next((at for at, other in enumerate(acts) if other is act), len(acts))
        return any(later.act in ("test", "learn") for later in acts[after:])

    def _insert(self, act: Pick, *, learning: bool) -> None:
        """A test that waits for what it learns has not begun yet."""
        waits = learning and self._acts and self._acts[-1].act == "test"
        self._acts.insert(len(self._acts) - 1 if waits else len(self._acts), act)

    def _forget(self, act: Pick) -> None:
        self._live = [other for other in self._live if other is not act]
        self._acts = [other for other in self._acts if other is not act]

    def undo(self, tick: int, *, learning: bool = False, removes: bool = False) -> None:
        """The last pick was taken back; where no tick had carried it out, it is as if it had never been.

        Args:
            removes: The state that the pick had added went with it.
        """
        self._come_to(tick)
        pick, written, at = self._live[-1] if self._live else None, None, 0
        if removes and pick is not None and self._is_learned(pick, learning=learning):
            self.spoil(f"a state that had been learned was taken back in the test. {AGAIN}")
        waits = pick is not None and self._waits(pick, tick, learning=learning)
        if pick is not None and waits and self._leaves_no_trace(pick, learning=learning):
            at = next((at for at, act in enumerate(self._acts) if act is pick), len(self._acts))
            self._forget(pick)
        else:
            written = Pick(tick, "", act="undo")
            self._insert(written, learning=learning)
            self._live = self._live[:-1]
            self._gone += [] if pick is None else [(pick, written)]
        self._undone.append(_Undone(pick, written, self._last, tick, at))

    def redo(self, tick: int, *, learning: bool = False, waits: bool = False) -> None:
        """What was taken back last was done again; where nothing came between, it is as if it had never been taken back.

        Args:
            waits: No tick has carried it out yet.
        """
        self._come_to(tick)
        undone = self._undone.pop() if self._undone else None
        if undone is not None and undone.tick == tick and undone.last is self._last:
            self._never_undone(undone)
        elif undone is None or undone.pick is None:
            self.spoil(f"a pick that was taken back was done again later. {AGAIN}")
        else:
            self._done_again(undone, undone.pick, tick, learning=learning, waits=waits)

    def _never_undone(self, undone: _Undone) -> None:
        if undone.written is not None:
            self._acts = [act for act in self._acts if act is not undone.written]
            self._gone = [(act, by) for act, by in self._gone if by is not undone.written]
        elif undone.pick is not None:
            self._acts.insert(undone.at, undone.pick)
        if undone.pick is not None:
            self._live.append(undone.pick)

    def _done_again(self, undone: _Undone, pick: Pick, tick: int, *, learning: bool, waits: bool) -> None:
        """It was done again later than it was taken back, so both are acts; one that was forgotten comes back as well."""
        if undone.written is None:
            self._acts[undone.at : undone.at] = pick, Pick(undone.tick, "", act="undo")
        again = Pick(tick, pick.node, act=REDO)
        self._insert(again, learning=learning)
        self._live.append(again)
        self._again = again if waits else None

    @property
    def _last(self) -> Pick | None:
        return self._acts[-1] if self._acts else None

    def move(self, number: int, acts: Sequence[Pick], *, learning: bool = False) -> None:
        """Something was moved in the world.

        Args:
            number: Of the move, see `app.engine.snapshots.Moved`.
            acts: One for each that was moved.
        """
        self._moves[number] = acts
        for act in acts:
            self._insert(act, learning=learning)

    def undo_move(self, number: int, tick: int) -> None:
        """A move was taken back; where nothing came after it, it is as if it had never been."""
        last, moved = self._last, self._moves.get(number)
        if moved and last is moved[-1] and last.tick == tick:
            self._acts = self._acts[: -len(moved)]
        else:
            self.spoil(f"something was moved back in the world. {AGAIN}")

    def redo_move(self, number: int, tick: int, *, learning: bool = False) -> None:
        """A move was done again."""
        acts = [replace(act, tick=tick) for act in self._moves[number]]
        self.move(number, acts, learning=learning)

    def go_back(self) -> None:
        """The run is gone back in."""
        if any(act.act == "move" for act in self._acts):
            self.spoil(f"something was moved in the world before it was gone back in. {AGAIN}")

    def leave(self) -> None:
        """Nobody is taught any more."""
        self._over = self._over or self._plan is not None

    # ---------------------------------------------------------------------------------------- the project

    def changed(self, old: Project, new: Project, tick: int, *, runs: bool) -> None:
        """The project was changed from outside.

        Args:
            runs: Whether somebody runs what is taught.
        """
        if (old.worlds, old.types, _arm(old, self._arm)) != (new.worlds, new.types, _arm(new, self._arm)):
            self.spoil(f"the arm was changed. {AGAIN}")
        plan = self._plan
        if plan is None or self._over:
            self._edited = self._edited or old.libraries != new.libraries
            return
        where = plan.type, plan.automaton
        if old.examples_of(*where) != new.examples_of(*where):
            self.spoil("its examples were changed by hand in the middle of the lesson")
        if old.libraries is new.libraries or old.libraries == new.libraries:
            return
        mine = new.library(plan.type).automata.get(plan.automaton)
        if mine is None or _rest(old, plan) != _rest(new, plan):
            self.spoil("behaviors were changed in the middle of the lesson")
        elif runs and not _is_learned_from(mine, new, plan):
            self._come_to(tick)
            self._stale = tick  # as an undo brings back, until it is learned anew
        elif runs:
            self._come_to(tick)
            self._stale = None
            self._acts.append(Pick(tick, "", act="learn"))

    def _come_to(self, tick: int) -> None:
        """Time has passed up to this tick, perhaps with something that was learned from other examples."""
        if self._stale is not None and tick > self._stale:
            self.spoil("it was learned from something else in the middle of the lesson")

    # ------------------------------------------------------------------------------------------ the result

    def demonstration(self, project: Project) -> Demonstration | None:
        """What was done up to the last pick that stands, with what *project* lacks of it; None if there is none."""
        plan = self._plan
        if plan is None or not self._live:
            return None
        acts = self._acts[: 1 + self._end()]
        return Demonstration(
            plan.demonstration,
            plan.type,
            plan.automaton,
            self._arm,
            self._seed,
            tuple(acts),
            acts[-1].tick + 1,
            self._parameters,
            dict(plan.arguments),
            str(plan.others),
            removed=self._removed(acts, project.library(plan.type).automata.get(plan.automaton)),
        )

    def _end(self) -> int:
        """The place of the last act that is played: the last whose examples are there, or by which others went before it."""
        places = {id(act): at for at, act in enumerate(self._acts)}
        end = places[id(self._live[-1])]
        for act, by in self._gone:  # in the order in which they went
            if places.get(id(act), end + 1) <= end:
                end = max(end, places[id(by)])
        return end

    def _removed(self, acts: Sequence[Pick], automaton: Automaton | None) -> tuple[State, ...]:
        """States that picks added, and that went with them when they were taken back."""
        picked = dict.fromkeys(act.state for act in acts)
        there = {state.id for state in automaton.states} if automaton is not None else set()
        return tuple(self._added[name] for name in picked if name in self._added and name not in there)


def _arm(project: Project, name: str) -> Arm | None:
    return next((arm for arm in project.arms if arm.name == name), None)


def _rest(project: Project, plan: Teach) -> object:
    """All behaviors, without what the taught one has learned."""
    libraries = {name: dict(library.automata) for name, library in project.libraries.items()}
    mine = libraries.get(plan.type, {}).get(plan.automaton)
    if mine is not None:
        libraries[plan.type][plan.automaton] = replace(mine, learned={}, learned_from="")
    return libraries


def _is_learned_from(automaton: Automaton, project: Project, plan: Teach) -> bool:
    examples = project.examples_of(plan.type, plan.automaton)
    return automaton.learned_from == fingerprint(automaton, examples)
