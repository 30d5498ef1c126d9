"""What the tree panel is about: one state of an automaton, with the tree that is shown and what reaches its nodes."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from PySide6.QtGui import QColor

from ...core.automaton import Automaton, Model, Prune
from ...core.conditions import AtMost, Condition, Equals, Guard, InArc, Test
from ...core.implication import guard_implied
from ...core.library import Library
from ...core.phrasing import number
from ...core.telling import declared
from ...core.transition import pruned
from ...core.tree import Branch, Forest, Tree, TreeNode, shares
from ...core.vocabulary import Feature, Vocabulary
from ...core.wording import condition_words, feature_of, state_words
from ...export.graph import formal_words
from .bins import Histogram, histogram
from .node_item import NodeWords
from .reaching import Reaching
from .shape import Knot, find, path_to


@dataclass(frozen=True, slots=True, eq=False)
class Subject:
    """One state of an automaton.

    Attributes:
        tree: The tree that is shown, of a forest the chosen one; None if the state has none.
        vocabulary: The scenario's.
        reaching: Its examples.
    """

    type: str
    automaton: Automaton
    state: str
    library: Library
    vocabulary: Vocabulary
    tree: Tree | None
    reaching: Reaching
    colors: Mapping[str, QColor]

    @property
    def model(self) -> Model | None:
        """What the state has learned."""
        return self.automaton.learned.get(self.state)

    @property
    def trees(self) -> int:
        """How many trees there are to choose from."""
        model = self.model
        return len(model.trees) if isinstance(model, Forest) else int(isinstance(model, Tree))

    def name(self, state: str) -> str:
        """What the user calls a state."""
        return state_words(self.automaton, state, self.library)

    def path(self, key: int) -> Guard:
        """The tests on the way to a node."""
        return path_to(self.tree, key) if self.tree is not None else ()

    def examples(self, key: int) -> tuple[str, ...]:
        """The ids of the examples that reach a node."""
        return self.reaching.ids(self.path(key))

    def node(self, key: int) -> TreeNode | None:
        """The node with a key."""
        return find(self.tree, key) if self.tree is not None and key else None

    def labels_at(self, key: int) -> tuple[str, ...]:
        """The states that examples at a node lead to."""
        node = self.node(key)
        counts = node.counts if node is not None else ()
        return tuple(label for label, count in zip(self.labels, counts, strict=False) if count > 0.0)

    def feature_of(self, test: Test) -> Feature:
        """How the feature that is tested is declared."""
        return declared(feature_of(self.automaton, test.feature), self.vocabulary)

    def histogram(self, key: int) -> tuple[Histogram, AtMost | InArc] | None:
        """The histogram of the examples at a node by the feature that it tests; None if that has no cut."""
        node = self.node(key)
        if not isinstance(node, Branch) or isinstance(node.test, Equals):
            return None
        rows = self.reaching.rows(self.path(key))
        place = {label: number for number, label in enumerate(self.labels)}
        there = np.array([example.label in place for example in self.reaching.examples], np.bool_) & rows
        labels = [
            place[e.label] for e, here in zip(self.reaching.examples, there.tolist(), strict=True) if here
        ]
        values = self.reaching.column(node.test.feature)[there]
        feature = self.feature_of(node.test)
        numbers = np.array(labels, np.int64)
        return histogram(values, numbers, len(self.labels), node.test, feature), node.test

    def prunes_at(self, key: int) -> tuple[Prune, ...]:
        """The prunes that hold everywhere below a node."""
        path = self.path(key)
        return tuple(p for p in self.automaton.prunes_of(self.state) if guard_implied(p.guard, path))

    # ------------------------------------------------------------------------------------------------ words

    def words(self, knot: Knot) -> NodeWords:
        """What stands in a node."""
        prunes = self.prunes_at(knot.key)
        forbidden = {label for prune in prunes for label in prune.forbidden}
        bar = tuple(
            (share, self.color(label), label in forbidden)
            for label, share in zip(self.labels, shares(knot.node.counts), strict=True)
            if share > 0.0
        )
        under = count_words(sum(knot.node.counts))
        if not isinstance(knot.node, Branch):
            name, p = self._outcome(knot.node, prunes)
            return NodeWords(name, f"{under} · {p}", bar, tip=self.distribution(knot.node), is_leaf=True)
        test = Condition(knot.node.test)
        question = condition_words(test, self.automaton, self.vocabulary) + "?"
        tip = f"{formal_words(test, self.automaton)}\n{self.distribution(knot.node)}"
        return NodeWords(question, under, bar, self._arc(test.test), tip)

    @property
    def labels(self) -> tuple[str, ...]:
        """The states that the tree can lead to."""
        return self.tree.labels if self.tree is not None else ()

    def color(self, label: str) -> QColor:
        """The color of a state."""
        return self.colors.get(label, QColor("#8C94A3"))

    def _outcome(self, leaf: TreeNode, prunes: tuple[Prune, ...]) -> tuple[str, str]:
        """Where a leaf leads most probably, and how sure that is."""
        bare = [Prune(p.id, p.source, (), p.forbidden) for p in prunes]
        left = pruned(shares(leaf.counts), self.labels, bare, lambda _: 0.0)
        if sum(left) <= 0.0:
            return self.name(self.state), "pruned"
        best = max(range(len(left)), key=lambda place: left[place])
        p = f"{left[best]:.1f}" if left[best] == 1.0 else number(left[best], 2)
        return self.name(self.labels[best]), f"p {p}"

    def _arc(self, test: Test) -> tuple[InArc, float] | None:
        if not isinstance(test, InArc):
            return None
        return test, self.feature_of(test).period

    def distribution(self, node: TreeNode) -> str:
        """All labels with their counts: "Wander 3, ReturnWithBox 2"."""
        pairs = zip(self.labels, node.counts, strict=True)
        return ", ".join(f"{self.name(label)} {number(count)}" for label, count in pairs if count > 0.0)


def count_words(count: float) -> str:
    """How many examples."""
    return f"{number(count)} example{'' if count == 1.0 else 's'}"
