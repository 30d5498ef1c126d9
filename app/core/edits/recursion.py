"""Recursion is not permitted: an automaton may not hold itself, directly or through others."""

from ..errors import EditError, LibraryError
from ..project import Project


def refuse_recursion(project: Project, type_name: str) -> None:
    """Raise an `EditError` that spells the cycle out, if the automata of a type hold each other in a circle."""
    try:
        project.library(type_name).refuse_cycle()
    except LibraryError as error:
        raise EditError(str(error)) from None
