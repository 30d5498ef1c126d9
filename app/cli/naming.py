"""Behaviors as the user names them: ``Goto``, or ``agent/Goto`` where several types have one."""

from collections.abc import Container, Sequence

from ..core.errors import LibraryError
from ..core.project import Project
from .wording import unknown

#: A type's name and the id of an automaton in its library.
Where = tuple[str, str]


def named_behaviors(
    project: Project, words: Sequence[str], fitting: Container[Where] | None = None
) -> list[Where]:
    """What the *words* name, each once, in their order; a bare name means the behaviors of all types called so.

    Args:
        fitting: Those that something can be done with. Where a bare name means several and some of them are among these,
            only they are meant: the hand-written Wander of another type has nothing to learn from.

    Raises:
        LibraryError: A word names none; the message says which there are.
    """
    by_name = all_behaviors(project)
    found: dict[Where, None] = {}
    for word in words:
        meant = [where for name, where in by_name.items() if word in (name, name.split("/", maxsplit=1)[1])]
        if not meant:
            raise LibraryError(unknown("behavior", word, by_name))
        fit = meant if fitting is None else [where for where in meant if where in fitting]
        found |= dict.fromkeys(fit or meant)
    return list(found)


def all_behaviors(project: Project) -> dict[str, Where]:
    """Every behavior of the project by its full name, agents' first, those that hold others after them."""
    types = sorted(project.types, key=lambda node_type: node_type.level)
    return {
        f"{node_type.name}/{automaton.name}": (node_type.name, automaton.id)
        for node_type in types
        for automaton in project.library(node_type.name).bottom_up()
    }
