"""The form of the other files of a project, as pydantic records: what `convert_project` makes of values.

Keys with a default are left out where they hold it.
"""

from typing import Annotated, Literal, Self

from pydantic import Field, FiniteFloat, model_validator

from .fields import (
    Count,
    FileName,
    MomentHash,
    Name,
    Record,
    Scalar,
    TypeName,
    Weight,
    Whole,
    doubles,
    refuse,
)
from .schema import StateRecord

#: Levels of a forest: more than anyone needs, and few enough to walk without care.
MOST_LEVELS = 64

# ------------------------------------------------------------------------------------- examples and demonstrations


class ExampleRecord(Record):
    """What one pick recorded."""

    id: Name
    source: str
    label: str
    values: dict[str, float]
    continuation: bool = False
    enabled: bool = True
    weight: Weight = 1.0
    demonstration: str = ""
    tick: Count = 0
    node: str = ""
    snapshot: MomentHash = ""
    pick: Count = 0


class ExamplesRecord(Record):
    """``examples/TYPE/ID.json``: the examples of one automaton, in the order in which they were recorded."""

    automaton: FileName
    examples: list[ExampleRecord]

    @model_validator(mode="after")
    def _ids_are_unique(self) -> Self:
        refuse(doubles("examples", [example.id for example in self.examples]))
        return self


class PlaceRecord(Record):
    """Where the user put a state: its center, in pixels, y downward."""

    x: float
    y: float


class LayoutRecord(Record):
    """``layouts/TYPE/ID.json``: where the user put states of one automaton when it is drawn."""

    automaton: FileName
    states: dict[str, PlaceRecord]


class PickRecord(Record):
    """One act of a demonstrator's hand."""

    tick: Count
    node: str = ""
    state: str = ""
    act: Literal[
        "pick", "answer", "should not have left", "undo", "redo", "test", "learn", "teach", "move"
    ] = "pick"
    entity: Count | None = None
    x: FiniteFloat | None = None
    y: FiniteFloat | None = None


class DemonstrationRecord(Record):
    """``demonstrations/ID.json``: what a person's hand did."""

    id: FileName
    type: str
    automaton: str
    arm: str
    seed: Whole
    picks: list[PickRecord]
    ticks: Count
    parameters: dict[str, Scalar] = {}
    arguments: dict[str, str] = {}
    others: Literal["idle", "run"] = "idle"
    note: str = ""
    removed: list[StateRecord] = []

    @model_validator(mode="after")
    def _ids_are_unique(self) -> Self:
        refuse(doubles("removed", [state.id for state in self.removed]))
        return self


# -------------------------------------------------------------------------------------------------------- project


class NodeTypeRecord(Record):
    """A kind of node with a library of its own."""

    name: TypeName
    level: Count = 0
    subsidiaries: list[str] = []


class TableRecord(Record):
    """A regular forest: sizes and types from the roots down."""

    kind: Literal["table"]
    sizes: Annotated[list[Annotated[int, Field(ge=1, le=2**31)]], Field(min_length=1)]
    types: list[str]

    @model_validator(mode="after")
    def _as_many_types_as_sizes(self) -> Self:
        if len(self.types) != len(self.sizes):
            message = f"{len(self.sizes)} sizes need as many types, but there are {len(self.types)}"
            refuse([(("types",), self.types, message)])
        return self


class NodeRecord(Record):
    """An agent or a controller."""

    id: Name
    type: str
    children: list["NodeRecord"] = []
    name: str = ""


class NodesRecord(Record):
    """A forest in full."""

    kind: Literal["forest"]
    roots: list[NodeRecord]

    @model_validator(mode="after")
    def _has_few_levels(self) -> Self:
        level, levels = self.roots, 0
        while level:
            level, levels = [child for node in level for child in node.children], levels + 1
        if levels > MOST_LEVELS:
            refuse([(("roots",), None, f"must have at most {MOST_LEVELS} levels, but has {levels}")])
        return self


class ArmRecord(Record):
    """One treatment."""

    name: Name
    hierarchy: Annotated[TableRecord | NodesRecord, Field(discriminator="kind")]
    top: str
    world: str = ""
    parameters: dict[str, Scalar] = {}
    note: str = ""


class ProjectRecord(Record):
    """``project.json``: what holds for the project as a whole, and the order of its demonstrations."""

    schema_version: int
    name: str
    scenario: str
    types: list[NodeTypeRecord]
    worlds: dict[str, dict[str, Scalar]] = {}
    arms: list[ArmRecord] = []
    demonstrations: list[FileName] = []
    note: str = ""

    @model_validator(mode="after")
    def _names_are_unique(self) -> Self:
        refuse(
            [
                *doubles("types", [node_type.name for node_type in self.types], within="name"),
                *doubles("arms", [arm.name for arm in self.arms], within="name"),
                *doubles("demonstrations", self.demonstrations, within=""),
            ]
        )
        return self
