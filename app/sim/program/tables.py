"""The flat form of a program: columns of numbers, and the names that they stand for.

Everything is meant by its row. States of all automata share one table; so do basic behaviors (one row for each type that
has it), feature uses, and the code of transition functions.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from numpy.typing import NDArray

from ...core.automaton import Automaton
from ...core.vocabulary import BasicBehavior

# Operations of transition code.
TEST, TAKE, FORBID, LEAF, DECIDE, TREE_OF_FOREST, END = range(7)
# What a state holds.
NOTHING, BASIC, NESTED, FLAG = range(4)
# Sources of feature uses.
SENSE, GROUP, FLAG_UP, TICKS_IN_STATE, STATISTIC_OF_FLAG, STATISTIC_OF_SENSE = range(6)
# Statistics, in the order of `app.core.features.Operation`.
ANY, ALL, COUNT, MEAN, MIN, MAX = range(6)
# Samplings, in the order of `app.core.automaton.Sampling`.
SAMPLE, ARGMAX, HOLD = range(3)

#: Rules and labels of one state, and flags of a program, are bits of one whole number.
MOST_BITS = 60
#: The bit of a decision's first word that says that the learned model was asked.
LEARNED = 1 << MOST_BITS
#: The first word of the key of a state that has not been evaluated since it was entered.
NO_KEY = -1
#: The leaf of a state that no leaf has decided on alone since it was entered.
NO_LEAF = -1
#: Words of a key before those of the trees: rules met, labels possible.
KEY_HEAD = 2
#: The flag of the agent itself, `finished`, always has the first bit.
FINISHED_BIT = 1
#: The state that stands for all that cannot be entered.
NOWHERE = 0

#: Column name -> float64 ("f") or int64 ("i"), in the order in which a kernel takes them.
TABLE_COLUMNS: Mapping[str, str] = {
    # transition code
    "operation": "i",  # TEST, ...
    "use": "i",  # a test's feature use
    "low": "f",  # the least value that passes a test; a rule's probability
    "high": "f",  # the greatest value that passes a test
    "yes": "i",  # where to go on
    "no": "i",  # where to go on when a test fails; the state that a leaf decides on whatever is drawn, or -1
    "goal": "i",  # a rule's state; a leaf; a test's source of values
    "mask": "i",  # a rule's bit; the labels that a prune forbids
    # leaves
    "shares_at": "i",  # first of the leaf's probabilities
    "share": "f",  # probabilities
    "running": "f",  # their running sums
    # states
    "code": "i",  # first operation
    "sampling": "i",
    "labels_at": "i",  # first of the learned model's labels
    "labels": "i",  # how many
    "trees": "i",  # how many trees the learned model has
    "prunable": "i",  # 1 where a prune may change the model's choice
    "content": "i",  # NOTHING, ...
    "held": "i",  # basic behavior, automaton, or mask of the flag
    "bound_at": "i",  # first binding of what is held
    "bound": "i",  # how many
    "label": "i",  # labels: states
    # automata
    "start": "i",  # start state
    # basic behaviors
    "behavior": "i",  # the scenario's number, or -1 where it only directs
    "once": "i",
    "raises": "i",  # mask
    "finishes": "i",
    "derived": "i",
    "arity": "i",
    "directs": "i",  # (basic behavior, type of the subsidiary) -> what that one starts
    # feature uses
    "source": "i",  # SENSE, ...
    "feature": "i",  # the scenario's number
    "slots_at": "i",  # first binding
    "slots": "i",  # how many
    "flag": "i",  # mask
    "statistic": "i",  # ANY, ...
    "direct": "i",  # 1: over the direct subsidiaries, 0: over all agents below
    "default": "f",  # without a referent
    "empty": "f",  # over nobody
    "binding": "i",  # bindings: a target's number, or -1 - k for parameter k
    # nodes: controllers in the order in which they tick, then agents by number
    "type": "i",
    "parent": "i",  # -1 without
    "first_member": "i",
    "end_member": "i",
    "children_at": "i",
    "children_end": "i",
    "child": "i",
}

#: Of float64 or int64.
Column = NDArray[Any]


@dataclass(frozen=True, slots=True)
class Sizes:
    """How large the run state of a program is.

    Attributes:
        levels: The longest possible chain of behaviors that hold each other.
        arguments: The most target parameters of a behavior.
        key_words: The most words that say what decided.
        slots: The most targets of a behavior or feature.
        entries: The most next states that one evaluation weighs.
    """

    nodes: int
    controllers: int
    types: int
    levels: int
    arguments: int
    key_words: int
    slots: int
    entries: int
    states: int
    uses: int
    targets: int


@dataclass(frozen=True, slots=True)
class StateRow:
    """What it takes to read a key of one state back: ids of the rules, labels, and the way to each leaf."""

    automaton: int
    id: str
    rules: tuple[str, ...] = ()
    labels: tuple[str, ...] = ()
    trees: int = 0
    prunable: bool = False
    plain: bool = False


@dataclass(frozen=True, slots=True)
class LeafRow:
    """A leaf: the number of its way down, and the probabilities there."""

    path: int
    shares: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class AutomatonRow:
    """An automaton with the rows of its states by id."""

    type: str
    automaton: Automaton
    states: Mapping[str, int]


@dataclass(frozen=True, slots=True)
class Program:
    """A forest's behaviors as flat, read-only columns.

    Attributes:
        columns: By name, see `TABLE_COLUMNS`.
        automata, basics, states, leaves: What the rows mean. A basic behavior stands with its type.
        automaton_rows, basic_rows: Row by type and id or name.
        leaf_rows: Row of a leaf by state, tree and number of its way down.
        flags: Name of each bit.
        targets: Name of each number.
        nodes: Id of each node.
        uses: A word for each feature use: what it is, for tests and messages.
    """

    sizes: Sizes
    columns: Mapping[str, Column] = field(repr=False)
    automata: tuple[AutomatonRow, ...]
    basics: tuple[tuple[str, BasicBehavior], ...]
    states: tuple[StateRow, ...]
    leaves: tuple[LeafRow, ...]
    automaton_rows: Mapping[tuple[str, str], int]
    basic_rows: Mapping[tuple[str, str], int]
    leaf_rows: Mapping[tuple[int, int, int], int]
    flags: tuple[str, ...]
    targets: tuple[str, ...]
    nodes: tuple[str, ...]
    uses: tuple[str, ...]

    def key(self, state: int, words: Sequence[int]) -> object:
        """What decided, as `app.core.transition.Outcome.key` says it; None if nothing did yet."""
        row, first = self.states[state], words[0]
        if first == NO_KEY:
            return None
        met: list[object] = [rule for k, rule in enumerate(row.rules) if first >> k & 1]
        if first & LEARNED:
            leaves = [self.leaves[word] for word in words[KEY_HEAD : KEY_HEAD + row.trees]]
            met += [tuple(leaf.path for leaf in leaves), self._possible(row, leaves, words[1])]
        return tuple(met)

    @staticmethod
    def _possible(row: StateRow, leaves: list[LeafRow], mask: int) -> tuple[bool, ...]:
        if row.prunable:
            return tuple(bool(mask >> k & 1) for k in range(len(row.labels)))
        return tuple(any(leaf.shares[k] > 0.0 for leaf in leaves) for k in range(len(row.labels)))

    def key_words(self, state: int, key: Any) -> list[int]:
        """The words of *key*. One that this program could not have made is unlike any that it makes."""
        row, unknown = self.states[state], -2
        if key is None:
            return [NO_KEY]
        rules = [part for part in key if isinstance(part, str)]
        first = sum(1 << row.rules.index(rule) for rule in rules if rule in row.rules)
        if any(rule not in row.rules for rule in rules):
            return [unknown]
        if len(rules) == len(key):
            return [first]
        path, possible = key[len(rules)], key[len(rules) + 1]
        words = [self.leaf_rows.get((state, tree, number), unknown) for tree, number in enumerate(path)]
        if len(words) != row.trees or len(possible) != len(row.labels) or unknown in words:
            return [unknown]
        mask = sum(1 << k for k, allowed in enumerate(possible) if allowed)
        if not row.prunable and self._possible(row, [self.leaves[w] for w in words], 0) != possible:
            return [unknown]
        return [first | LEARNED, mask, *words]
