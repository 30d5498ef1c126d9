"""The form of an automaton as pydantic records: what `convert` makes of values, and what JSON must look like.

Keys with a default are left out where they hold it.
"""

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from ..automaton import START, Sampling
from ..features import Operation, Over
from .fields import (
    Complaint,
    FileName,
    Name,
    Probability,
    Record,
    doubles,
    refuse,
)
from .tree_schema import ForestRecord, TreeRecord

# ------------------------------------------------------------------------------------------------------- features


class BindingRecord(Record):
    """What a slot is bound to: ``{"ground": TARGET}`` or ``{"parameter": NAME}``."""

    ground: str | None = None
    parameter: str | None = None

    @model_validator(mode="after")
    def _one_of_two(self) -> Self:
        if (self.ground is None) == (self.parameter is None):
            refuse([((), None, "must have either the key 'ground' or the key 'parameter'")])
        return self


BindingRecords = dict[str, BindingRecord]


class SenseRecord(Record):
    """A feature that the scenario declares."""

    kind: Literal["sense"]
    feature: str
    bindings: BindingRecords = {}


class FlagUpRecord(Record):
    """Whether the current sub-behavior has a flag up."""

    kind: Literal["flag"]
    flag: str


class TicksInStateRecord(Record):
    """Ticks since the current state was entered."""

    kind: Literal["ticks in state"]


class StatisticRecord(Record):
    """A feature or flag summed up over nodes below."""

    kind: Literal["statistic"]
    operation: Annotated[Operation, Field(strict=False)]
    of: Annotated[SenseRecord | FlagUpRecord, Field(discriminator="kind")]
    over: Annotated[Over, Field(strict=False)] = Over.AGENTS


class FeatureUseRecord(Record):
    """One feature of one automaton."""

    id: Name
    source: Annotated[
        SenseRecord | FlagUpRecord | TicksInStateRecord | StatisticRecord, Field(discriminator="kind")
    ]
    name: str = ""


# ----------------------------------------------------------------------------------------------------- conditions


class AtMostRecord(Record):
    """A continuous feature is at most *threshold*; the contrary where *wanted* is false, as in all conditions."""

    kind: Literal["at most"]
    feature: str
    threshold: float
    wanted: bool = True


class EqualsRecord(Record):
    """A boolean or categorical feature has this value."""

    kind: Literal["equals"]
    feature: str
    value: float
    wanted: bool = True


class InArcRecord(Record):
    """A toroidal feature lies in the arc from *start* up to *end*."""

    kind: Literal["in arc"]
    feature: str
    start: float
    end: float
    wanted: bool = True


GuardRecord = list[Annotated[AtMostRecord | EqualsRecord | InArcRecord, Field(discriminator="kind")]]


# ------------------------------------------------------------------------------------------------------- automata


class StartRecord(Record):
    """The start state's content."""

    kind: Literal["start"]


class BasicRecord(Record):
    """A basic behavior by name."""

    kind: Literal["basic"]
    behavior: str
    bindings: BindingRecords = {}


class NestedRecord(Record):
    """Another automaton by id."""

    kind: Literal["automaton"]
    automaton: str
    bindings: BindingRecords = {}


class RaiseFlagRecord(Record):
    """A flag state."""

    kind: Literal["flag"]
    flag: str


class StateRecord(Record):
    """One state."""

    id: Name
    content: Annotated[
        StartRecord | BasicRecord | NestedRecord | RaiseFlagRecord, Field(discriminator="kind")
    ]
    name: str = ""
    note: str = ""


class RuleRecord(Record):
    """An authored transition."""

    id: Name
    source: str
    guard: GuardRecord = []
    target: str
    probability: Probability = 1.0


class PruneRecord(Record):
    """Labels that the learned model may not choose."""

    id: Name
    source: str
    guard: GuardRecord = []
    forbidden: list[str]


class CutRecord(Record):
    """A test of a learned tree whose numbers the user has moved."""

    id: Name
    source: str
    guard: GuardRecord = []
    test: Annotated[AtMostRecord | EqualsRecord | InArcRecord, Field(discriminator="kind")]


class SettingsRecord(Record):
    """How an automaton learns and samples."""

    classifier: str = "c45"
    sampling: Annotated[Sampling, Field(strict=False)] = Sampling.SAMPLE
    pruning_confidence: Annotated[float, Field(gt=0, le=0.5)] | None = None
    options: dict[str, float] = {}


class RefitRecord(Record):
    """A learned model that is fitted again on load."""

    kind: Literal["refit"]
    classifier: str


ModelRecord = Annotated[TreeRecord | ForestRecord | RefitRecord, Field(discriminator="kind")]


class AutomatonRecord(Record):
    """``libraries/TYPE/ID.json``: a behavior that is an automaton."""

    id: FileName
    name: str
    parameters: list[str] = []
    states: Annotated[list[StateRecord], Field(min_length=1)]
    features: list[FeatureUseRecord] = []
    rules: list[RuleRecord] = []
    learned: dict[str, ModelRecord] = {}
    learned_from: str = ""
    prunes: list[PruneRecord] = []
    cuts: list[CutRecord] = []
    settings: SettingsRecord = SettingsRecord()
    note: str = ""

    @model_validator(mode="after")
    def _ids_are_unique(self) -> Self:
        complaints = doubles("parameters", self.parameters, within="")
        for name, items in (
            ("states", self.states),
            ("features", self.features),
            ("rules", self.rules),
            ("prunes", self.prunes),
            ("cuts", self.cuts),
        ):
            complaints += doubles(name, [item.id for item in items])
        refuse([*complaints, *_start_is_first(self.states)])
        return self


def _start_is_first(states: list[StateRecord]) -> list[Complaint]:
    complaints: list[Complaint] = []
    for index, state in enumerate(states):
        if (state.id == START) != (index == 0):
            message = f"the first state, and no other, must have the id {START!r}, but found {state.id!r}"
            complaints.append((("states", index, "id"), state.id, message))
        if (state.content.kind == "start") != (index == 0):
            message = f"the first state, and no other, must be of the kind 'start', but found {state.content.kind!r}"
            complaints.append((("states", index, "content"), state.content.kind, message))
    return complaints
