"""The form of learned trees on disk: `app.core.tree.FlatTree`, checked so that walking one ends."""

from collections import Counter
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from ..tree import LEAF, OPERATIONS
from .fields import Complaint, Record, Weight, doubles, refuse

Index = Annotated[int, Field(ge=LEAF)]
#: The arrays with one entry a node.
COLUMNS = ("slot", "operation", "a", "b", "yes", "no", "counts")


class ArraysRecord(Record):
    """One tree as parallel arrays, one entry a node; see `app.core.tree.FlatTree`."""

    features: list[str]
    slot: Annotated[list[Index], Field(min_length=1)]
    operation: list[Literal["at most", "equals", "in arc", ""]]
    a: list[float]
    b: list[float]
    yes: list[Index]
    no: list[Index]
    counts: list[list[Weight]]

    @model_validator(mode="after")
    def _is_a_tree(self) -> Self:
        refuse([*doubles("features", self.features, within=""), *self._uneven()])
        refuse([*self._wrong_nodes(), *self._wrong_parents()])
        return self

    def _uneven(self) -> list[Complaint]:
        nodes = len(self.slot)
        return [
            (
                (name,),
                None,
                f"must have as many entries as 'slot', {nodes}, but has {len(getattr(self, name))}",
            )
            for name in COLUMNS
            if len(getattr(self, name)) != nodes
        ]

    def _wrong_nodes(self) -> list[Complaint]:
        return [found for index in range(len(self.slot)) for found in self._wrong_node(index)]

    def _wrong_node(self, index: int) -> list[Complaint]:
        slot, below = self.slot[index], {"yes": self.yes[index], "no": self.no[index]}
        found: list[Complaint] = []
        if slot >= len(self.features):
            allowed = f"{LEAF} at a leaf, or an index into 'features', which has {len(self.features)}"
            found.append((("slot", index), slot, f"must be {allowed}; found {slot}"))
        if (self.operation[index] == "") != (slot == LEAF):
            allowed = '""' if slot == LEAF else ", ".join(f'"{name}"' for name in OPERATIONS)
            found.append(
                (("operation", index), self.operation[index], f"must be {allowed} where 'slot' is {slot}")
            )
        for name, child in below.items():
            if slot == LEAF and child != LEAF:
                found.append(((name, index), child, f"must be {LEAF} at a leaf, but found {child}"))
            elif slot != LEAF and not index < child < len(self.slot):
                allowed = f"the index of a later node, {index + 1} to {len(self.slot) - 1}"
                found.append(((name, index), child, f"must be {allowed}, but found {child}"))
        return found

    def _wrong_parents(self) -> list[Complaint]:
        """Every node but the first stands below exactly one other: otherwise walking could take forever."""
        above = Counter(child for child in (*self.yes, *self.no) if child != LEAF)
        return [
            (("slot", index), self.slot[index], f"node {index} must stand below one node, not {above[index]}")
            for index in range(1, len(self.slot))
            if above[index] != 1
        ]


def _wrong_counts(tree: ArraysRecord, labels: list[str], loc: tuple[int | str, ...]) -> list[Complaint]:
    return [
        (
            (*loc, "counts", index),
            counts,
            f"must have one count a label, {len(labels)}, but has {len(counts)}",
        )
        for index, counts in enumerate(tree.counts)
        if len(counts) != len(labels)
    ]


class TreeRecord(ArraysRecord):
    """A learned tree; *labels* are ids of states."""

    kind: Literal["tree"]
    labels: list[str]

    @model_validator(mode="after")
    def _counts_fit_labels(self) -> Self:
        refuse([*doubles("labels", self.labels, within=""), *_wrong_counts(self, self.labels, ())])
        return self


class ForestRecord(Record):
    """Several trees over the same labels."""

    kind: Literal["forest"]
    labels: list[str]
    trees: Annotated[list[ArraysRecord], Field(min_length=1)]

    @model_validator(mode="after")
    def _counts_fit_labels(self) -> Self:
        complaints = doubles("labels", self.labels, within="")
        for index, tree in enumerate(self.trees):
            complaints += _wrong_counts(tree, self.labels, ("trees", index))
        refuse(complaints)
        return self
