"""Edits of arms and of the worlds that they name."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from ..errors import EditError
from ..hierarchy import Hierarchy, Node
from ..project import Arm, LevelTable, Project, Value
from .place import find_index, listed, moved
from .words import says


def find_arm(project: Project, name: str) -> Arm:
    """The arm called *name*; `EditError` names those there are."""
    return project.arm(name)


def change_arm(project: Project, name: str, **fields: Any) -> Project:
    """*project* with other values for some fields of one arm."""
    old = find_arm(project, name)
    new = replace(old, **fields)
    return replace(project, arms=tuple(new if arm is old else arm for arm in project.arms))


@says("Add arm {arm.name}")
def add_arm(project: Project, arm: Arm) -> Project:
    """One more arm, the last."""
    _refuse_name(project, arm.name)
    return replace(project, arms=(*project.arms, arm))


@says("Change arm {name}")
def replace_arm(project: Project, name: str, arm: Arm) -> Project:
    """Another arm in the place of one; if its name differs, demonstrations that took place in it follow."""
    project = rename_arm(project, name, arm.name)
    old = find_arm(project, arm.name)
    return replace(project, arms=tuple(arm if there is old else there for there in project.arms))


@says("Rename arm {name} to {new}")
def rename_arm(project: Project, name: str, new: str) -> Project:
    """Another name for an arm, also in the demonstrations that took place in it."""
    old = find_arm(project, name)
    if new == name:
        return project
    _refuse_name(project, new)
    arms = tuple(replace(arm, name=new) if arm is old else arm for arm in project.arms)
    demonstrations = tuple(replace(d, arm=new) if d.arm == name else d for d in project.demonstrations)
    return replace(project, arms=arms, demonstrations=demonstrations)


@says("Delete arm {name}")
def delete_arm(project: Project, name: str) -> Project:
    """No such arm any more; refused while a demonstration takes place in it."""
    old = find_arm(project, name)
    if users := [f"demonstration {d.id!r}" for d in project.demonstrations if d.arm == name]:
        raise EditError(f"arm {name!r} is used by {listed(users)}: remove these first")
    return replace(project, arms=tuple(arm for arm in project.arms if arm is not old))


@says("Move arm {name}")
def move_arm(project: Project, name: str, to: int) -> Project:
    """Put an arm at place *to* among the arms."""
    index = find_index([arm.name for arm in project.arms], name, "arm", "the project")
    return replace(project, arms=moved(project.arms, index, to))


def retyped(hierarchy: Hierarchy | LevelTable, name: str, new: str) -> Hierarchy | LevelTable:
    """*hierarchy* with every node of type *name* of type *new* instead; nodes that are written out keep their ids."""
    if isinstance(hierarchy, LevelTable):
        return replace(hierarchy, types=tuple(new if t == name else t for t in hierarchy.types))
    return Hierarchy(tuple(_retyped_node(root, name, new) for root in hierarchy.roots))


def _retyped_node(node: Node, name: str, new: str) -> Node:
    children = tuple(_retyped_node(child, name, new) for child in node.children)
    return replace(node, type=new if node.type == name else node.type, children=children)


def _refuse_name(project: Project, name: str) -> None:
    if not name.strip():
        raise EditError("an arm needs a name")
    if any(arm.name == name for arm in project.arms):
        raise EditError(f"there already is an arm {name!r}")


# ------------------------------------------------------------------------------------------- worlds


@says("Change world {name}")
def set_world(project: Project, name: str, parameters: Mapping[str, Value]) -> Project:
    """The scenario parameters of a world, new or in place of those it had; the world "" is the whole project's."""
    return replace(project, worlds={**project.worlds, name: dict(parameters)})


@says("Rename world {name} to {new}")
def rename_world(project: Project, name: str, new: str) -> Project:
    """Another name for a world, also in the arms that name it."""
    _refuse_unnamed(name)
    _refuse_unnamed(new)
    find_index(project.worlds, name, "world", "the project")
    if new == name:
        return project
    if new in project.worlds:
        raise EditError(f"there already is a world {new!r}")
    worlds = {new if key == name else key: parameters for key, parameters in project.worlds.items()}
    arms = tuple(replace(arm, world=new) if arm.world == name else arm for arm in project.arms)
    return replace(project, worlds=worlds, arms=arms)


@says("Delete world {name}")
def delete_world(project: Project, name: str) -> Project:
    """No such world any more; refused while an arm names it."""
    find_index(project.worlds, name, "world", "the project")
    users = [f"arm {arm.name!r}" for arm in project.arms if name and arm.world == name]
    if users:
        raise EditError(f"world {name!r} is used by {listed(users)}: let these name another first")
    return replace(project, worlds={key: value for key, value in project.worlds.items() if key != name})


def _refuse_unnamed(name: str) -> None:
    if not name.strip():
        raise EditError("a world needs a name; the one without holds the parameters of the whole project")
