"""``experiments/NAME.json`` as it stands in a project's folder; every key is known, every value checked."""

from typing import Annotated, Self

from pydantic import Field, PlainValidator, WithJsonSchema, model_validator

from ...core.storage.fields import Complaint, Name, Record, Whole, complaint, doubles, refuse
from .plan import SEEDS_A_CELL, Design


def _given(value: object) -> object:
    if isinstance(value, list) and value and all(isinstance(n, int) and n is not True for n in value):
        return tuple(value)
    if isinstance(value, bool | int | float | str):
        return value
    raise complaint("must be a number, text, true, false, or an array of whole numbers")


GivenField = Annotated[
    bool | int | float | str | tuple[int, ...],
    PlainValidator(_given),
    WithJsonSchema({"type": ["number", "string", "boolean", "array"]}),
]
SettingsField = dict[str, GivenField]
Runs = Annotated[int, Field(ge=1, le=SEEDS_A_CELL)]
Ticks = Annotated[int, Field(ge=1, le=10**9)]


class TreatedRecord(Record):
    """One arm."""

    name: Name
    arm: str
    settings: SettingsField = Field(default_factory=dict)


class LevelRecord(Record):
    """One level of a factor that changes several settings at once."""

    name: Name
    settings: SettingsField


class FactorRecord(Record):
    """A factor: either *setting* and its *values*, or named *levels*."""

    name: Name
    setting: str = ""
    values: list[GivenField] = Field(default_factory=list)
    levels: list[LevelRecord] = Field(default_factory=list)

    @model_validator(mode="after")
    def _has_one_form(self) -> Self:
        complaints: list[Complaint] = []
        if bool(self.levels) == bool(self.setting and self.values):
            message = f"factor {self.name!r} needs either 'setting' and 'values', or 'levels'"
            complaints.append(((), None, message))
        refuse([*complaints, *doubles("levels", [level.name for level in self.levels], within="name")])
        refuse(doubles("values", [str(value) for value in self.values], within=""))
        return self


class ReferenceRecord(Record):
    """A result from elsewhere."""

    name: Name
    mean: float
    sd: Annotated[float, Field(ge=0)]
    runs: Annotated[int, Field(ge=2)]


class ClaimRecord(Record):
    """A claim: *greater* than *less*, *same* as each other, *no_less* than *than*, or *never_stalls*."""

    text: Name
    measure: str = ""
    greater: str | None = None
    less: str | None = None
    same: Annotated[list[str], Field(min_length=2, max_length=2)] | None = None
    no_less: str | None = None
    than: ReferenceRecord | None = None
    never_stalls: str | None = None
    where: dict[str, str] = Field(default_factory=dict)

    @model_validator(mode="after")
    def _has_one_form(self) -> Self:
        given = {name for name in FORMS_KEYS if getattr(self, name) is not None}
        if given not in FORMS:
            found = ", ".join(sorted(given)) or "none of them"
            allowed = "; ".join(" and ".join(sorted(form)) for form in FORMS)
            refuse([((), None, f"a claim has the keys of one form ({allowed}), but this one has {found}")])
        return self


FORMS = ({"greater", "less"}, {"same"}, {"no_less", "than"}, {"never_stalls"})
FORMS_KEYS = tuple(sorted(set().union(*FORMS)))


class PanelRecord(Record):
    """One chart of the figure."""

    measure: str = ""
    x: str = "ticks"
    title: str = ""
    by: str = ""
    where: dict[str, str] = Field(default_factory=dict)


class ExperimentRecord(Record):
    """The whole file."""

    title: Name
    note: str = ""
    ticks: Ticks
    runs: Runs
    seed: Annotated[Whole, Field(ge=0, le=2**62)] = 1
    points: Annotated[int, Field(ge=1, le=10_000)] = 100
    arms: Annotated[list[TreatedRecord], Field(min_length=1)]
    factors: list[FactorRecord] = Field(default_factory=list)
    design: Annotated[Design, Field(strict=False)] = Design.FACTORIAL
    claims: list[ClaimRecord] = Field(default_factory=list)
    figure: list[PanelRecord] = Field(default_factory=list)

    @model_validator(mode="after")
    def _names_are_unique(self) -> Self:
        refuse(
            [
                *doubles("arms", [arm.name for arm in self.arms], within="name"),
                *doubles("factors", [factor.name for factor in self.factors], within="name"),
            ]
        )
        return self
