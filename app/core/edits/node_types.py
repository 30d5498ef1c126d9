"""Edits of node types: which kinds of nodes there are and who stands under whom."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TypeVar

from ..errors import EditError
from ..hierarchy import Hierarchy
from ..library import NodeType
from ..project import Arm, Project
from ..storage.names import folded, type_name_problem
from .arms import retyped
from .place import find_type, listed
from .words import says

V = TypeVar("V")


@says("Add node type {name}")
def add_type(project: Project, name: str, subsidiaries: Sequence[str] = ()) -> Project:
    """One more type: of agents, or of controllers of these subsidiaries, one level above the highest."""
    _refuse_name(project, name)
    level = _level(project.types, name, subsidiaries)
    return replace(project, types=(*project.types, NodeType(name, level, tuple(subsidiaries))))


@says("Change who stands under {name}")
def set_subsidiaries(project: Project, name: str, subsidiaries: Sequence[str]) -> Project:
    """Other types that may stand under controllers of a type. Levels follow, also of the types above.

    Raises:
        EditError: A type would stand below itself.
    """
    find_type(project, name)
    changed = [replace(t, subsidiaries=tuple(subsidiaries)) if t.name == name else t for t in project.types]
    return replace(project, types=_leveled(changed))


def _leveled(types: Sequence[NodeType]) -> tuple[NodeType, ...]:
    return tuple(replace(t, level=_level(types, t.name, t.subsidiaries)) for t in types)


def _level(
    types: Iterable[NodeType], name: str, subsidiaries: Sequence[str], above: tuple[str, ...] = ()
) -> int:
    there = {t.name: t for t in types}
    if name in above:
        raise EditError(f"a type cannot stand below itself, but {' controls '.join((*above, name))}")
    levels = [0]
    for below in subsidiaries:
        if below not in there and below != name:
            raise EditError(f"there is no node type {below!r}; there are: {listed(there)}")
        further = there[below].subsidiaries if below in there else subsidiaries
        levels.append(1 + _level(there.values(), below, further, (*above, name)))
    return max(levels)


@says("Rename node type {name} to {new}")
def rename_type(project: Project, name: str, new: str) -> Project:
    """Another name for a type, wherever the project mentions it."""
    find_type(project, name)
    if new == name:
        return project
    _refuse_name(project, new)
    return replace(
        project,
        types=tuple(_renamed_type(t, name, new) for t in project.types),
        libraries=_renamed_key(project.libraries, name, new),
        examples=_renamed_key(project.examples, name, new),
        layouts=_renamed_key(project.layouts, name, new),
        arms=tuple(_renamed_in_arm(arm, name, new) for arm in project.arms),
        demonstrations=tuple(replace(d, type=new) if d.type == name else d for d in project.demonstrations),
    )


def _renamed_type(node_type: NodeType, name: str, new: str) -> NodeType:
    below = tuple(new if child == name else child for child in node_type.subsidiaries)
    return replace(node_type, name=new if node_type.name == name else node_type.name, subsidiaries=below)


def _renamed_key(table: Mapping[str, V], name: str, new: str) -> Mapping[str, V]:
    return {new if key == name else key: value for key, value in table.items()} if name in table else table


def _renamed_in_arm(arm: Arm, name: str, new: str) -> Arm:
    if name not in _types_of(arm):
        return arm
    return replace(arm, hierarchy=retyped(arm.hierarchy, name, new))


@says("Delete node type {name}")
def delete_type(project: Project, name: str) -> Project:
    """No such type any more, nor examples that were left under its name.

    Raises:
        EditError: It has behaviors, stands under another type, or stands in an arm.
    """
    find_type(project, name)
    users = [f"its behavior {a.name}" for a in project.library(name).automata.values()]
    users += [f"node type {t.name!r}" for t in project.types if name in t.subsidiaries]
    users += [f"arm {arm.name!r}" for arm in project.arms if name in _types_of(arm)]
    if users:
        raise EditError(f"node type {name!r} is used by {listed(users)}: delete or change these first")
    types = tuple(t for t in project.types if t.name != name)
    return replace(project, types=types, examples={k: v for k, v in project.examples.items() if k != name})


def _types_of(arm: Arm) -> set[str]:
    if isinstance(arm.hierarchy, Hierarchy):
        return {node.type for node in arm.hierarchy.walk()}
    return set(arm.hierarchy.types)


def _refuse_name(project: Project, name: str) -> None:
    if problem := type_name_problem(name):
        raise EditError(f"{name!r} cannot name a node type, since it names a folder: {problem}")
    if same := [t.name for t in project.types if folded(t.name) == folded(name)]:
        raise EditError(f"there already is a node type {same[0]!r}")
