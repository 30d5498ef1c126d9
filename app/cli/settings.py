"""What ``--set`` was given: NAME=VALUE, by the type of the parameter."""

from collections.abc import Mapping, Sequence

from ..core.errors import ParameterError
from ..core.project import Value
from ..sim.scenario import Scenario
from .wording import unknown

WORLD = "world."
#: Settings that are words, and no parameters of a scenario.
OTHERS = ("physics", "engine")
_BOOLEANS: Mapping[str, Value] = {"true": True, "false": False}


def parsed(given: Sequence[str], scenario: Scenario) -> Mapping[str, Value]:
    """The settings in *given*; whether the values are allowed is for the scenario to say.

    Raises:
        ParameterError: One is not NAME=VALUE, names no parameter, or is set twice.
    """
    settings: dict[str, Value] = {}
    for word in given:
        name, separator, text = word.partition("=")
        name = name.strip()
        if not separator:
            raise ParameterError(f"--set {word}: it takes NAME=VALUE, such as world.boxes=20")
        if name in settings:
            raise ParameterError(f"--set {word}: {name} is set twice")
        settings[name] = _value(name, text.strip(), scenario)
    return settings


def _value(name: str, text: str, scenario: Scenario) -> Value:
    known = scenario.defaults()
    if name in OTHERS:
        return text
    if not name.startswith(WORLD) or name.removeprefix(WORLD) not in known:
        raise ParameterError(
            unknown("setting", name, [*OTHERS, *(WORLD + known_one for known_one in sorted(known))])
        )
    return _as(known[name.removeprefix(WORLD)], text)


def _as(default: Value, text: str) -> Value:
    """*text* as a value of the type of *default*; as it stands where that cannot be, so that it is refused by name."""
    if isinstance(default, bool):
        return _BOOLEANS.get(text.lower(), text)
    if isinstance(default, str):
        return text
    try:
        return type(default)(text)
    except ValueError:
        return text
