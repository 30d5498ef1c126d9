"""Edits of demonstrations, and of the project as a whole."""

from dataclasses import replace

from ..errors import EditError
from ..naming import fresh_id
from ..project import Demonstration, Project
from ..storage.names import file_name_problem
from .place import find_automaton, find_index, moved
from .words import says


@says("Add a demonstration of {demonstration.automaton}")
def add_demonstration(project: Project, demonstration: Demonstration) -> tuple[Project, str]:
    """One more demonstration, the last; also returns its id, which is made if it is empty or taken.

    Raises:
        EditError: Its id cannot name a file, or its automaton or arm does not exist.
    """
    _refuse_places(project, demonstration)
    if demonstration.id and (problem := file_name_problem(demonstration.id)):
        raise EditError(f"{demonstration.id!r} cannot name a demonstration, since it names a file: {problem}")
    taken = {d.id for d in project.demonstrations}
    new_id = fresh_id(taken, demonstration.id or demonstration.automaton, "demonstration")
    if demonstration.id and demonstration.id not in taken:
        new_id = demonstration.id
    demonstration = replace(demonstration, id=new_id)
    return replace(project, demonstrations=(*project.demonstrations, demonstration)), new_id


@says("Change demonstration {demonstration_id}")
def replace_demonstration(project: Project, demonstration_id: str, demonstration: Demonstration) -> Project:
    """Another demonstration in the place of one; it keeps the id.

    Raises:
        EditError: There is no such demonstration, or the new one's automaton or arm does not exist.
    """
    _refuse_places(project, demonstration)
    index = _index(project, demonstration_id)
    if demonstration.id != demonstration_id:
        raise EditError(
            f"demonstration {demonstration_id!r} keeps its id, but {demonstration.id!r} was given"
        )
    before, after = project.demonstrations[:index], project.demonstrations[index + 1 :]
    return replace(project, demonstrations=(*before, demonstration, *after))


@says("Remove demonstration {demonstration_id}")
def remove_demonstration(project: Project, demonstration_id: str) -> Project:
    """No such demonstration any more. Examples that it recorded stay."""
    index = _index(project, demonstration_id)
    before, after = project.demonstrations[:index], project.demonstrations[index + 1 :]
    return replace(project, demonstrations=(*before, *after))


@says("Move demonstration {demonstration_id}")
def move_demonstration(project: Project, demonstration_id: str, to: int) -> Project:
    """Put a demonstration at place *to*. The order is the one in which they are played."""
    return replace(
        project, demonstrations=moved(project.demonstrations, _index(project, demonstration_id), to)
    )


def _refuse_places(project: Project, demonstration: Demonstration) -> None:
    """A demonstration plays somewhere, and teaches something."""
    find_automaton(project, demonstration.type, demonstration.automaton)
    project.arm(demonstration.arm)


def _index(project: Project, demonstration_id: str) -> int:
    return find_index(
        [d.id for d in project.demonstrations], demonstration_id, "demonstration", "the project"
    )


@says("Rename the project to {name}")
def rename_project(project: Project, name: str) -> Project:
    """Another name for the project."""
    if not name.strip():
        raise EditError("a project needs a name")
    return replace(project, name=name)


@says("Change the note on the project")
def note_project(project: Project, note: str) -> Project:
    """Another note on the project."""
    return replace(project, note=note)
