"""What is explained: one automaton on a node's path, with what it sees, and the sentences made of it."""

from collections.abc import Sequence
from dataclasses import dataclass

from ..core.automaton import Automaton, Sampling
from ..core.conditions import Guard
from ..core.hierarchy import Hierarchy, Node
from ..core.library import Library
from ..core.phrasing import number
from ..core.project import Project
from ..core.vocabulary import Vocabulary
from ..core.wording import Speech, guard_words, held_words, node_words, readings, state_words
from .deciding import Way
from .snapshots import Watched, WatchedLevel


@dataclass(frozen=True, slots=True)
class Part:
    """A piece of a sentence; *strong* ones stand out."""

    text: str
    strong: bool = False


@dataclass(frozen=True, slots=True)
class Reason:
    """Why an automaton on a node's path stays in its state or leaves it.

    Attributes:
        parts: The sentence.
        state, goes: Where it is, and the state that comes next most probably.
        probability: Of that.
        guard: The tests that decided, as they came out.
        examples: Ids of the examples that ended in the leaf that decided.
        agreeing: Those of them that say the same.
        rule: Id of the rule that decided, if one did.
        prunes: Ids of the prunes that took something away from the leaf.
    """

    node: str
    type: str
    automaton: str
    state: str
    goes: str
    parts: tuple[Part, ...]
    probability: float = 1.0
    guard: Guard = ()
    examples: tuple[str, ...] = ()
    agreeing: tuple[str, ...] = ()
    rule: str = ""
    prunes: tuple[str, ...] = ()

    @property
    def sentence(self) -> str:
        """The whole as plain text."""
        return "".join(part.text for part in self.parts)


@dataclass(frozen=True, slots=True)
class Case:
    """What is explained."""

    project: Project
    vocabulary: Vocabulary
    node: str
    level: WatchedLevel
    automaton: Automaton
    library: Library
    speech: Speech

    def shown(self, state: str) -> Part:
        """A state by the name that the user reads, standing out."""
        return Part(state_words(self.automaton, state, self.library), strong=True)

    def words(self, guard: Guard) -> str:
        """Tests as a clause."""
        return guard_words(guard, self.automaton, self.vocabulary, self.speech)

    def seen(self, guard: Guard) -> str:
        """What the tested features say now."""
        tested = dict.fromkeys(condition.test.feature for condition in guard)
        uses = [use for feature_id in tested for use in self.automaton.features if use.id == feature_id]
        return " and ".join(readings(uses, self.level.values, self.vocabulary, self.speech))


def case_of(
    project: Project,
    vocabulary: Vocabulary,
    watched: Watched,
    level: WatchedLevel,
    forest: Hierarchy | None,
) -> Case | None:
    """What is explained of one level of a node's path; None if that has been edited away since it was looked at."""
    library = project.library(level.type)
    automaton = library.automata.get(level.automaton)
    if automaton is None or not automaton.has_state(level.state):
        return None
    node = None if forest is None else _find(forest, watched.node)
    speech = Speech(
        clause=True,
        group=node_words(node) if node is not None and node.children else "",
        held=held_words(automaton, level.state, library),
        targets={slot: target for slot, (target, _, _) in level.arguments.items()},
        detailed=True,
    )
    return Case(project, vocabulary, watched.node, level, automaton, library, speech)


def _find(forest: Hierarchy, node_id: str) -> Node | None:
    return next((node for node in forest.walk() if node.id == node_id), None)


def ranked(case: Case) -> list[tuple[str, float]]:
    """The states that can come next, the most probable first; just that where no other is ever chosen."""
    ranked = sorted(case.level.outcome, key=lambda pair: -pair[1])
    if case.automaton.settings.sampling is Sampling.ARGMAX:
        return [(state, 1.0) for state, _ in ranked[:1]]
    return ranked


def reason_of(case: Case, goes: str, probability: float, parts: Sequence[Part], way: Way | None) -> Reason:
    """A reason with its sentence and what decided, if anything did."""
    level = case.level
    return Reason(
        case.node,
        level.type,
        level.automaton,
        level.state,
        goes,
        tuple(parts),
        probability,
        way.guard if way else (),
        tuple(example.id for example in way.examples) if way else (),
        tuple(example.id for example in way.examples if example.label == goes) if way else (),
        way.rule if way else "",
        way.prunes if way else (),
    )


def percent(probability: float) -> str:
    """A probability as people read it."""
    told = number(100.0 * probability, 2)
    return f"{number(100.0 * probability, 4) if told == '100' else told}%"


def agreement(agreeing: int, of: int) -> str:
    """How many examples speak for it; nothing where there are none."""
    if not of:
        return ""
    return f" ({agreeing} of {of} example{'s' * (of != 1)} agree{'s' * (agreeing == 1)})"
