"""Parameters of a scenario: how they are declared, and how given values are settled.

They are the fields of a frozen dataclass, each made by `quantity`. A parameter is a number, a whole number, true or
false, or one of several words.
"""

from collections.abc import Mapping
from dataclasses import MISSING, Field, field, fields, is_dataclass
from math import isfinite
from typing import Any, cast

from ..core.amounts import exact
from ..core.errors import ParameterError, ScenarioError
from ..core.project import Value

_TYPE_WORDS = {float: "a number", int: "a whole number", bool: "true or false", str: "a word"}
#: Whole numbers are int64 in compiled engines.
_LARGEST_WHOLE = 2**63 - 1


def quantity(
    default: Value,
    unit: str = "",
    low: float | None = None,
    high: float | None = None,
    choices: tuple[str, ...] = (),
    doc: str = "",
) -> Any:
    """A parameter: its default, unit, closed range or choices, and meaning. A word needs choices."""
    metadata = {"unit": unit, "low": low, "high": high, "choices": choices, "doc": doc}
    return field(default=default, metadata=metadata)


def parameter_fields(parameters: object) -> Mapping[str, "Field[Any]"]:
    """The fields of a parameter class, by name.

    Raises:
        ScenarioError: It is no dataclass, or a field is not one that `quantity` can make.
    """
    if not (isinstance(parameters, type) and is_dataclass(parameters)):
        raise ScenarioError(f"the parameters have to be a dataclass, not {parameters!r}")
    found = {f.name: f for f in fields(parameters)}
    for name, declared in found.items():
        _refuse_bad(name, declared)
    return found


def _refuse_bad(name: str, declared: "Field[Any]") -> None:
    if name.startswith("_"):
        raise ScenarioError(f"parameter {name!r} must not begin with an underscore")
    if declared.default is MISSING or "choices" not in declared.metadata:
        raise ScenarioError(f"parameter {name!r} has to be made by quantity(default, ...)")
    if type(declared.default) not in _TYPE_WORDS:
        allowed = ", ".join(_TYPE_WORDS.values())
        raise ScenarioError(f"the default of parameter {name!r} is {declared.default!r}; allowed: {allowed}")
    if isinstance(declared.default, str) and not declared.metadata["choices"]:
        raise ScenarioError(f"parameter {name!r} is a word, so it needs choices")
    try:
        checked(name, declared, declared.default)
    except ParameterError as error:
        raise ScenarioError(f"the default of a parameter is not allowed: {error}") from error


def default(declared: "Field[Any]") -> Value:
    """The default of a parameter."""
    return cast(Value, declared.default)


def checked(name: str, declared: "Field[Any]", value: Value) -> Value:
    """*value* as the type of the parameter's default, within its range.

    Raises:
        ParameterError: It is not; the message says what is allowed.
    """
    wanted: Any = type(declared.default)
    if wanted is float and isinstance(value, int) and not isinstance(value, bool):
        value = _as_float(value)
    if not isinstance(value, wanted) or isinstance(value, bool) is not (wanted is bool):
        raise ParameterError(f"{name} takes {_TYPE_WORDS[wanted]}, but it is {value!r}")
    if isinstance(value, float) and not isfinite(value):
        raise ParameterError(f"{name} takes a finite number, but it is {value!r}")
    if isinstance(value, int) and abs(value) > _LARGEST_WHOLE:
        raise ParameterError(f"{name} takes whole numbers of up to 63 bits, but this one has more")
    _refuse_outside(name, declared, value)
    settled: Value = value
    return settled


def _as_float(value: int) -> float:
    try:
        return float(value)
    except OverflowError:
        return float("inf")


def _refuse_outside(name: str, declared: "Field[Any]", value: Value) -> None:
    low, high, choices, unit = (declared.metadata[key] for key in ("low", "high", "choices", "unit"))
    if choices and value not in choices:
        raise ParameterError(f"{name} is one of {', '.join(choices)}, but it is {value!r}")
    if isinstance(value, str):
        return
    if low is not None and value < low:
        raise ParameterError(f"{name} must be {_amount(low, unit)} or more, but it is {exact(value)}")
    if high is not None and value > high:
        raise ParameterError(f"{name} must be {_amount(high, unit)} or less, but it is {exact(value)}")


def _amount(bound: float, unit: str) -> str:
    """A bound in its unit, such as "10 units", "1 degree per tick"."""
    first, gap, rest = unit.partition(" ")
    return f"{exact(bound)} {first.removesuffix('s') if bound == 1 else first}{gap}{rest}".rstrip()
