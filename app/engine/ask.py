"""Asking the user: before each tick of a test, whether a node is about to do what it is not sure of.

Looking ahead reads and draws nothing, so that a test goes on as it would have without it.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import isnan

import numpy as np

from ..core.actor import Actor, Run
from ..core.automaton import Automaton
from ..core.certainty import least_certainty
from ..core.errors import SessionError, UnderstudyError
from ..core.examples import Example
from ..core.library import Library
from ..core.machine import Machine, Senses
from ..core.project import Project
from ..core.vocabulary import Vocabulary
from ..core.wording import node_words, reading_words, state_words
from ..sim.doing import Doing
from ..sim.engine import Engine
from .commands import AskMe, Teach
from .familiar import Familiar, Nearest
from .lesson import Lesson
from .plan import automaton_of, is_taught_one
from .recording import seen
from .snapshots import Asked
from .watching import totals

#: So many of the states that may come next are told.
MOST_TOLD = 3
#: What decided, of which node: what was let go once is let go again.
Matter = tuple[str, str, tuple[object, ...]]


@dataclass(frozen=True, slots=True)
class _Look:
    """What a node is about to decide.

    Attributes:
        outcome: The states that can come next, each once, the most probable first.
    """

    machine: Machine
    senses: Senses
    actor: Actor
    run: Run
    automaton: Automaton
    outcome: tuple[tuple[str, float], ...]
    key: tuple[object, ...]

    @property
    def matter(self) -> Matter:
        return self.actor.node.id, self.run.state, self.key

    def values(self) -> Mapping[str, float]:
        return seen(self.machine, self.senses, self.actor, self.run, self.automaton)


class Asking:
    """What the user wants to be asked about, and what has been settled in this test.

    Attributes:
        command: The wish; None does not ask.
    """

    def __init__(self, vocabulary: Vocabulary) -> None:
        self.command: AskMe | None = None
        self._vocabulary = vocabulary
        self._let_go: set[Matter] = set()
        self._known: tuple[Automaton, Sequence[Example], Familiar] | None = None
        self._doubts: tuple[Automaton, float, frozenset[str]] | None = None

    def wish(self, command: AskMe) -> None:
        """Ask by this from now on.

        Raises:
            SessionError: A bound makes no sense.
        """
        if command.below is not None and not 0.0 < command.below <= 1.0:
            raise SessionError(f"asking below a probability of {command.below}; allowed: above 0, up to 1")
        if command.beyond is not None and (isnan(command.beyond) or command.beyond < 0.0):
            raise SessionError(f"asking beyond a distance of {command.beyond}; allowed: 0 or more")
        off = not command.nodes or (command.below is None and command.beyond is None)
        self.command = None if off else command

    def looks_at(self, engine: Engine, lesson: Lesson) -> bool:
        """Whether anything may be asked in the coming ticks of a lesson."""
        return self.command is not None and lesson.testing and self._in_doubt(engine, lesson) != frozenset()

    def begin(self) -> None:
        """A test begins: nothing has been settled."""
        self._let_go.clear()

    def let_go(self, engine: Engine, lesson: Lesson, node_id: str) -> None:
        """The node may decide by itself what it is about to decide now, and whenever the same decides again."""
        self._let_go |= {look.matter for look in _looks(engine, lesson, [node_id])}

    def question(
        self, engine: Engine, lesson: Lesson, project: Project, nodes: Sequence[str] | None = None
    ) -> Asked | None:
        """The first question about the coming tick; None if there is none.

        Args:
            nodes: Of these nodes only; None looks at all that were wished for.
        """
        if self.command is None or not lesson.testing:
            return None
        wanted = self.command.nodes if nodes is None else nodes
        for look in _looks(engine, lesson, wanted, self._in_doubt(engine, lesson)):
            if look.matter not in self._let_go:
                try:
                    asked = self._doubt(look, lesson, project)
                except UnderstudyError:
                    continue  # what cannot be seen now cannot be asked about
                if asked is not None:
                    return asked
        return None

    def _doubt(self, look: _Look, lesson: Lesson, project: Project) -> Asked | None:
        command = self.command
        assert command is not None
        confidence = look.outcome[0][1]
        unsure = command.below is not None and confidence < command.below
        if not unsure and command.beyond is None:
            return None
        values = look.values()
        nearest = self._familiar(look.automaton, lesson, project).nearest(look.run.state, values)
        if not unsure and nearest.distance <= (command.beyond or 0.0):
            return None
        told = _Told(look, project.library(lesson.plan.type), self._vocabulary)
        return Asked(
            look.actor.node.id,
            lesson.plan.type,
            lesson.plan.automaton,
            look.run.state,
            values,
            look.outcome,
            told.unsure() if unsure else told.unknown(nearest, values),
            confidence,
            nearest.distance,
        )

    def _in_doubt(self, engine: Engine, lesson: Lesson) -> frozenset[str] | None:
        """The states in which something may have to be asked; None if that depends on more than the state."""
        command = self.command
        if command is None or command.below is None or command.beyond is not None:
            return None
        machine, _ = engine.watch(())
        automaton = automaton_of(machine, lesson.plan)
        if self._doubts is None or self._doubts[0] is not automaton or self._doubts[1] != command.below:
            kind, below = lesson.plan.type, command.below
            models = {state.id: machine.classifiers(kind, automaton, state.id) for state in automaton.states}
            unsure = (
                state for state, model in models.items() if least_certainty(automaton, state, model) < below
            )
            self._doubts = automaton, below, frozenset(unsure)
        return self._doubts[2]

    def _familiar(self, automaton: Automaton, lesson: Lesson, project: Project) -> Familiar:
        """The examples to compare with, looked at once as long as they stay the same."""
        examples = project.examples_of(lesson.plan.type, lesson.plan.automaton)
        if self._known is None or self._known[0] is not automaton or self._known[1] is not examples:
            self._known = automaton, examples, Familiar(automaton, examples, self._vocabulary)
        return self._known[2]


def _looks(
    engine: Engine, lesson: Lesson, nodes: Sequence[str], states: frozenset[str] | None = None
) -> Iterator[_Look]:
    """What those of the nodes are about to decide that do so by themselves, as far as that can be told.

    Args:
        states: Of nodes in these states only; None looks at all.
    """
    if states is not None and engine.compiled:
        nodes = _nodes_in(engine.doing(), lesson.plan, states, nodes)
    deciding = [node_id for node_id in nodes if lesson.decides(node_id)]
    if not deciding:
        return
    machine, senses = engine.watch(deciding)
    for node_id in deciding:
        actor = machine.actors[node_id]
        run = actor.run
        if run is None or not isinstance(run.behavior, Automaton) or not is_taught_one(run, lesson.plan):
            continue
        if states is not None and run.state not in states:
            continue
        try:
            outcome = machine.outcome(actor, run, senses)
        except UnderstudyError:
            continue  # the tick itself will say what is wrong
        ranked = tuple(sorted(totals(outcome), key=lambda pair: -pair[1]))
        yield _Look(machine, senses, actor, run, run.behavior, ranked, outcome.key)


def _nodes_in(doing: Doing, plan: Teach, states: frozenset[str], nodes: Sequence[str]) -> Sequence[str]:
    """Those of the nodes that are in one of the states of what is taught."""
    wanted = [
        ref.type == plan.type and ref.automaton == plan.automaton and ref.state in states
        for ref in doing.states
    ]
    there = np.array([*wanted, False])[doing.state[:, 0]]  # the last for who is in none
    if not there.any():
        return ()
    return [node_id for node_id in nodes if node_id in doing.rows and there[doing.rows[node_id]]]


@dataclass(frozen=True, slots=True)
class _Told:
    """Puts a question into words."""

    look: _Look
    library: Library
    vocabulary: Vocabulary

    def unsure(self) -> str:
        chances = [
            f"{state_words(self.look.automaton, state, self.library)} {100.0 * probability:.0f}%"
            for state, probability in self.look.outcome[:MOST_TOLD]
        ]
        return f"{self._who} is not sure what comes after {self._here}: {', '.join(chances)}"

    def unknown(self, nearest: Nearest, values: Mapping[str, float]) -> str:
        if not nearest.examples:
            return f"{self._who} was never shown what comes after {self._here}"
        use = next((use for use in self.look.automaton.features if use.id == nearest.feature), None)
        what = "this" if use is None else reading_words(use, values[use.id], self.vocabulary)
        return f"{self._who} was never shown anything like this in {self._here}: {what}"

    @property
    def _who(self) -> str:
        return node_words(self.look.actor.node)

    @property
    def _here(self) -> str:
        return state_words(self.look.automaton, self.look.run.state, self.library)
