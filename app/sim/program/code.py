"""Transition functions as code: tests that branch, rules that take their share, trees that end in leaves.

A state's code runs through its rules in order, then its trees, then its prunes. It is written from its end backward, so
that every operation knows where those after it begin.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from math import inf, nextafter

from ...core.automaton import Prune, Rule, Sampling
from ...core.conditions import AtMost, Equals, Guard, InArc, Test
from ...core.errors import ProgramError
from ...core.transition import Outcome, choose
from ...core.tree import LEAF as NO_TEST
from ...core.tree import FlatTree, Forest, Leaf, Tree, flatten, shares
from . import tables
from .tables import LeafRow

#: Row of a feature use by its id within the automaton.
Uses = Callable[[str], int]


@dataclass(frozen=True, slots=True)
class Transition:
    """The transition function of one state, rows found.

    Attributes:
        goals: Row of each state that can be entered, by id.
    """

    row: int
    rules: Sequence[Rule]
    model: Tree | Forest | None
    prunes: Sequence[Prune]
    sampling: Sampling
    goals: Callable[[str], int]
    uses: Uses

    @property
    def trees(self) -> tuple[Tree, ...]:
        """The trees of the learned model."""
        if self.model is None:
            return ()
        return self.model.trees if isinstance(self.model, Forest) else (self.model,)

    @property
    def is_plain(self) -> bool:
        """Whether the leaf of a tree decides alone, by no more than a draw: nearly all learned states are like this."""
        held = self.sampling is Sampling.HOLD
        return isinstance(self.model, Tree) and not (self.rules or self.prunes or held)

    @property
    def labels(self) -> tuple[str, ...]:
        """What the learned model can choose."""
        return () if self.model is None else self.model.labels


@dataclass(slots=True)
class Code:
    """The code of all transition functions while it grows: one list a column."""

    operation: list[int] = field(default_factory=list)
    use: list[int] = field(default_factory=list)
    low: list[float] = field(default_factory=list)
    high: list[float] = field(default_factory=list)
    yes: list[int] = field(default_factory=list)
    no: list[int] = field(default_factory=list)
    goal: list[int] = field(default_factory=list)
    mask: list[int] = field(default_factory=list)
    shares_at: list[int] = field(default_factory=list)
    share: list[float] = field(default_factory=list)
    running: list[float] = field(default_factory=list)
    leaves: list[LeafRow] = field(default_factory=list)
    leaf_rows: dict[tuple[int, int, int], int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.end = self._put(tables.END)

    end: int = 0

    def write(self, transition: Transition) -> int:
        """Write a state's code; returns where it begins.

        Raises:
            ProgramError: The state has more rules or labels than a word has bits.
        """
        _refuse_many("rules", len(transition.rules))
        _refuse_many("labels", len(transition.labels))
        at = self.end
        for prune in reversed(transition.prunes):
            forbids = self._put(tables.FORBID, yes=at, mask=_forbidden(prune, transition.labels))
            at = self._guard(prune.guard, transition.uses, forbids, at)
        for number, tree in reversed(list(enumerate(transition.trees))):
            at = self._tree(transition, number, tree, at)
        for number, rule in reversed(list(enumerate(transition.rules))):
            takes = self._put(
                tables.TAKE,
                low=rule.probability,
                yes=at,
                goal=transition.goals(rule.target),
                mask=1 << number,
            )
            at = self._guard(rule.guard, transition.uses, takes, at)
        return at

    def _put(
        self,
        operation: int,
        use: int = 0,
        low: float = 0.0,
        high: float = 0.0,
        yes: int = 0,
        no: int = 0,
        goal: int = 0,
        mask: int = 0,
    ) -> int:
        for column, value in zip(
            (self.operation, self.use, self.yes, self.no, self.goal, self.mask),
            (operation, use, yes, no, goal, mask),
            strict=True,
        ):
            column.append(value)
        self.low.append(float(low))
        self.high.append(float(high))
        return len(self.operation) - 1

    def _guard(self, guard: Guard, uses: Uses, yes: int, no: int) -> int:
        for condition in reversed(guard):
            good, bad = (yes, no) if condition.wanted else (no, yes)
            yes = self._test(condition.test, uses, good, bad)
        return yes

    def _test(self, test: Test, uses: Uses, yes: int, no: int) -> int:
        """A test of every sort asks whether a value lies between two others, both included."""
        low, high, inside = _interval(test)
        good, bad = (yes, no) if inside else (no, yes)
        return self._put(tables.TEST, uses(test.feature), low, high, good, bad)

    # ------------------------------------------------------------------------------------------- trees

    def _tree(self, transition: Transition, number: int, tree: Tree, after: int) -> int:
        nodes = tuple(tree.nodes())
        flat = flatten(tree)
        paths, at = _paths(flat), [0] * len(nodes)
        operation = tables.TREE_OF_FOREST if isinstance(transition.model, Forest) else tables.LEAF
        if transition.is_plain:
            operation = tables.DECIDE
        for k, node in reversed(list(enumerate(nodes))):
            if isinstance(node, Leaf):
                probabilities = shares(node.counts)
                leaf = self._leaf(transition, number, probabilities, paths[k])
                certain = _certain(transition, probabilities)
                at[k] = self._put(operation, use=number, yes=after, no=certain, goal=leaf)
            else:
                at[k] = self._test(node.test, transition.uses, at[flat.yes[k]], at[flat.no[k]])
        return at[0]

    def _leaf(self, transition: Transition, tree: int, probabilities: tuple[float, ...], path: int) -> int:
        row = len(self.leaves)
        self.leaves.append(LeafRow(path, probabilities))
        self.leaf_rows[transition.row, tree, path] = row
        self.shares_at.append(len(self.share))
        total = 0.0
        for p in probabilities:
            total += p
            self.share.append(p)
            self.running.append(total)
        return row


def _interval(test: Test) -> tuple[float, float, bool]:
    """The least and the greatest value, and whether those between them pass or all others do."""
    match test:
        case AtMost(_, threshold):
            return -inf, threshold, True
        case Equals(_, value):
            return value, value, True
        case InArc(_, start, end):
            first, beyond, inside = (start, end, True) if start <= end else (end, start, False)
            return first, nextafter(beyond, -inf), inside


def _paths(flat: FlatTree) -> list[int]:
    """The number of the way down to each node, as `Tree.decide` counts it."""
    paths = [1] * len(flat.slot)
    for k, slot in enumerate(flat.slot):
        if slot != NO_TEST:
            paths[flat.yes[k]], paths[flat.no[k]] = 2 * paths[k] + 1, 2 * paths[k]
    return paths


def _certain(transition: Transition, probabilities: tuple[float, ...]) -> int:
    """The state that a leaf alone decides on whatever is drawn, or -1; the state itself where nothing is likely."""
    here = "the state itself"
    if sum(probabilities) == 0.0:
        return transition.row
    outcome = Outcome((*transition.labels, here), (*probabilities, 0.0), ())
    if transition.sampling is Sampling.ARGMAX:
        found = choose(outcome, Sampling.ARGMAX, here, None, lambda: 0.0)
        return transition.goals(found)
    first = next(k for k, p in enumerate(probabilities) if p > 0.0)
    return transition.goals(transition.labels[first]) if probabilities[first] >= 1.0 else -1


def _forbidden(prune: Prune, labels: Sequence[str]) -> int:
    """The labels as bits; what is no label still counts as something forbidden, by a bit that no label has."""
    known = sum(1 << k for k, label in enumerate(labels) if label in prune.forbidden)
    return known | (1 << tables.MOST_BITS if prune.forbidden - set(labels) else 0)


def _refuse_many(what: str, count: int) -> None:
    if count > tables.MOST_BITS:
        raise ProgramError(f"a state has {count} {what}; a program takes up to {tables.MOST_BITS}")
