"""What records on disk are made of: strict fields, and what a record's definition says about places in a file."""

from collections import Counter
from collections.abc import Iterable, Sequence
from math import isfinite
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Field,
    PlainValidator,
    ValidationError,
    WithJsonSchema,
)
from pydantic_core import InitErrorDetails, PydanticCustomError

from .names import file_name_problem, type_name_problem

#: A place within a record, the value found there, and what is wrong with it.
Complaint = tuple[tuple[int | str, ...], object, str]


class Record(BaseModel):
    """A JSON object of which every key is known, no value is converted, and no number is NaN or infinite."""

    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False)


def complaint(message: str) -> PydanticCustomError:
    """An error that reads *message* and nothing else."""
    return PydanticCustomError("complaint", "{message}", {"message": message})


def refuse(complaints: Iterable[Complaint]) -> None:
    """Raise an error that pydantic reports with the place of the record before each place, if there are complaints."""
    errors = [
        InitErrorDetails(type=complaint(message), loc=loc, input=found) for loc, found, message in complaints
    ]
    if errors:
        raise ValidationError.from_exception_data("complaints", errors)


def doubles(name: str, ids: Sequence[str], within: str = "id") -> list[Complaint]:
    """Complaints about ids in the array *name* that stand there more than once; *within* is the key of the id."""
    counts = Counter(ids)
    return [
        ((name, index, *([within] if within else [])), found, f"{found!r} stands here more than once")
        for index, found in enumerate(ids)
        if counts[found] > 1
    ]


# -------------------------------------------------------------------------------------------------- kinds of field


def _file_name(name: str) -> str:
    if problem := file_name_problem(name):
        raise complaint(f"{name!r} cannot be the name of a file: {problem}")
    return name


def _type_name(name: str) -> str:
    if problem := type_name_problem(name):
        raise complaint(f"{name!r} cannot be the name of a type: {problem}")
    return name


def _scalar(value: object) -> bool | int | float | str:
    if isinstance(value, bool | str):
        return value
    if isinstance(value, int) and -(2**63) <= value < 2**63:
        return value
    if isinstance(value, float) and isfinite(value):
        return value
    raise complaint("must be a finite number, a whole number of 64 bits, text, true or false")


Name = Annotated[str, Field(min_length=1)]
FileName = Annotated[str, AfterValidator(_file_name)]
TypeName = Annotated[str, AfterValidator(_type_name)]
#: Names a moment's file, so nothing but these digits may stand in it.
MomentHash = Annotated[str, Field(pattern="^([0-9a-f]{16})?$")]
Whole = Annotated[int, Field(ge=-(2**63), le=2**63 - 1)]
Count = Annotated[int, Field(ge=0, le=2**63 - 1)]
Weight = Annotated[float, Field(ge=0)]
Probability = Annotated[float, Field(ge=0, le=1)]
_SCALAR_SCHEMA = {"type": ["number", "string", "boolean"]}
Scalar = Annotated[bool | int | float | str, PlainValidator(_scalar), WithJsonSchema(_SCALAR_SCHEMA)]


# --------------------------------------------------------------------------------------- what a definition allows


def members_at(model: type[BaseModel], loc: Sequence[int | str]) -> list[str]:
    """The keys that *model* allows in the object at *loc*, a place as pydantic gives it; none where any are."""
    here = _definition_at(model, loc)
    return sorted(here.model_fields) if isinstance(here, type) and issubclass(here, BaseModel) else []


def kinds_at(model: type[BaseModel], loc: Sequence[int | str]) -> list[str]:
    """The values that "kind" can have in the object at *loc*."""
    return list(_by_kind(_definition_at(model, loc)))


def _definition_at(model: type[BaseModel], loc: Sequence[int | str]) -> Any:
    here: Any = model
    for step in loc:
        here = _below(here, step)
    return here


def _below(here: Any, step: int | str) -> Any:
    """The definition of what stands at *step* in something defined by *here*; a union is entered by its kind."""
    if isinstance(here, type) and issubclass(here, BaseModel):
        found = here.model_fields.get(str(step))
        return None if found is None else _plain(found.annotation)
    if get_origin(here) in {list, dict}:
        return _plain(get_args(here)[-1])
    return _by_kind(here).get(str(step))


def _plain(definition: Any) -> Any:
    """*definition* without what annotates it and without "or null"."""
    while get_origin(definition) is Annotated:
        definition = get_args(definition)[0]
    if get_origin(definition) in {Union, UnionType}:
        others = [member for member in get_args(definition) if member is not NoneType]
        return _plain(others[0]) if len(others) == 1 else definition
    return definition


def _by_kind(union: Any) -> dict[str, Any]:
    """The members of a union by the kind that each declares."""
    members = [_plain(member) for member in get_args(union)]
    records = [
        m for m in members if isinstance(m, type) and issubclass(m, BaseModel) and "kind" in m.model_fields
    ]
    return {
        kind: record
        for record in records
        if get_origin(record.model_fields["kind"].annotation) is Literal
        for kind in get_args(record.model_fields["kind"].annotation)
    }
