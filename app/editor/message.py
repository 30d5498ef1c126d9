"""What the window tells its user."""

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import StrEnum


class Kind(StrEnum):
    """How urgent a message is."""

    INFO = "info"
    WARNING = "warning"
    ERROR = "error"


@dataclass(frozen=True, slots=True)
class Message:
    """Something that the user should know.

    Attributes:
        answers: What can be done about it: the text of a button, and what it does.
        holds: Whether it is still so; it goes away once it is not.
    """

    text: str
    kind: Kind = Kind.INFO
    answers: tuple[tuple[str, Callable[[], object]], ...] = ()
    holds: Callable[[], bool] = field(default=lambda: True, compare=False)
