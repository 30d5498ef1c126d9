"""Checks of node types, and the types in an order that everything else can rely on."""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial

from ..edits import set_subsidiaries
from ..errors import HierarchyError
from ..library import NodeType
from ..project import Project
from .problem import PROJECT_FILE, Problem, allowed, place, twice


def type_problems(project: Project) -> Iterator[Problem]:
    """What is wrong with the node types: names used twice, unknown subsidiaries, cycles, levels."""
    if not project.types:
        yield _error("types", "there are no node types; a project needs at least one, of agents")
    for index, name in twice(t.name for t in project.types):
        yield _error(place("types", index, "name"), f"the node type {name!r} stands twice")
    there = {t.name: t for t in project.types}
    for index, node_type in enumerate(project.types):
        yield from _subsidiary_problems(index, node_type, there)
        if cycle := _cycle(node_type.name, there):
            where = place("types", index, "subsidiaries")
            yield _error(where, f"a type cannot stand below itself, but {' controls '.join(cycle)}")
        else:
            yield from _level_problems(index, node_type, there)
    yield from _stray_problems(project, there)


def _subsidiary_problems(index: int, node_type: NodeType, there: dict[str, NodeType]) -> Iterator[Problem]:
    for number, name in enumerate(node_type.subsidiaries):
        if name not in there:
            where = place("types", index, "subsidiaries", number)
            yield _error(
                where,
                f"there is no node type {name!r} to stand under {node_type.name!r}; {allowed(name, there)}",
            )


def _level_problems(index: int, node_type: NodeType, there: dict[str, NodeType]) -> Iterator[Problem]:
    known = [there[name] for name in node_type.subsidiaries if name in there]
    right = 1 + max(t.level for t in known) if known else 0
    if node_type.subsidiaries and not known:
        return
    if node_type.level != right:
        below = (
            "it has no subsidiaries"
            if not known
            else f"the highest below it, {_highest(known)!r}, has level {right - 1}"
        )
        mend = partial(set_subsidiaries, name=node_type.name, subsidiaries=node_type.subsidiaries)
        yield Problem(
            PROJECT_FILE,
            place("types", index, "level"),
            f"{node_type.name!r} has level {node_type.level}, but {below}, so it must be {right}",
            fix=f"set it to {right}",
            mend=mend,
            raises=HierarchyError,
        )


def _highest(types: Iterable[NodeType]) -> str:
    return max(types, key=lambda t: t.level).name


def _cycle(name: str, there: dict[str, NodeType]) -> tuple[str, ...]:
    """The way from a type down to itself, if there is one."""
    ways: list[tuple[str, ...]] = [(name,)]
    seen: set[str] = set()
    while ways:
        way = ways.pop()
        for child in there[way[-1]].subsidiaries:
            if child == name:
                return (*way, name)
            if child in there and child not in seen:
                seen.add(child)
                ways.append((*way, child))
    return ()


def _stray_problems(project: Project, there: dict[str, NodeType]) -> Iterator[Problem]:
    """Libraries and examples of types that do not exist."""
    for folder, by_type in (("libraries", project.libraries), ("examples", project.examples)):
        for name in by_type:
            if name not in there:
                message = f"there is no node type {name!r}; {allowed(name, there)}"
                yield Problem(f"{folder}/{name}", "", message, raises=HierarchyError)


def sound_types(project: Project) -> tuple[NodeType, ...]:
    """The node types, each once, without subsidiaries that do not exist or are not below, and with levels that fit."""
    once: dict[str, NodeType] = {}
    for node_type in project.types:
        once.setdefault(node_type.name, node_type)
    sound: dict[str, NodeType] = {}
    waiting = dict(once)
    while waiting:
        ready = [t for t in waiting.values() if not set(t.subsidiaries) & set(waiting)]
        for node_type in ready or list(waiting.values()):
            below = [sound[name] for name in node_type.subsidiaries if name in sound]
            level = 1 + max(t.level for t in below) if below else min(1, node_type.level)
            names = tuple(t.name for t in below)
            sound[node_type.name] = replace(node_type, level=level, subsidiaries=names)
            del waiting[node_type.name]
    return tuple(sound.values())


def _error(where: str, message: str) -> Problem:
    return Problem(PROJECT_FILE, where, message, raises=HierarchyError)
