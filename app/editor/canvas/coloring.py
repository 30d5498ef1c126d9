"""Who has which color, and why: by behavior at some depth of the path, or by group. Shape says how, as well; no painting."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QColor

from ...engine.place import Place
from ...sim.doing import NONE, BehaviorRef, Doing, Rows
from ..behavior_colors import BehaviorColors, nth_color
from ..palette import BASIC
from .scene import Scene


class ColorBy(StrEnum):
    """What an agent's color tells."""

    CURRENT = "current"
    OUTERMOST = "outermost"
    INNERMOST = "innermost"
    BASIC = "basic"
    GROUP = "group"


#: What the menu says.
COLOR_WORDS = {
    ColorBy.CURRENT: "Current behavior",
    ColorBy.OUTERMOST: "Outermost behavior",
    ColorBy.INNERMOST: "Innermost automaton",
    ColorBy.BASIC: "Basic behavior",
    ColorBy.GROUP: "Group",
}

IDLE, ATTACHED, ALONE = "idle", "attached", "no group"
#: An agent's shape: whether it runs an automaton, only a basic behavior, or nothing.
RUNS, BASICS, IDLES = range(3)
#: As many shapes, for agents that are attached to something.
SHAPES = 3


@dataclass(frozen=True, slots=True)
class Entry:
    """One line of the legend.

    Attributes:
        words: What it says.
        color: Red, green, blue.
        shape: How most of those are drawn.
    """

    words: str
    color: tuple[int, int, int]
    shape: int = RUNS


@dataclass(frozen=True, slots=True)
class Coloring:
    """The agents of one scene, by color and shape.

    Attributes:
        entries: What there can be; the last is for those that idle or are in no group.
        entry: Agent -> place among the entries.
        shape: Agent -> `RUNS`, `BASICS` or `IDLES`, and `SHAPES` more if it is attached.
        counts: Agents an entry.
        attached: How many agents are attached.
    """

    entries: tuple[Entry, ...]
    entry: NDArray[np.int64] = field(repr=False)
    shape: NDArray[np.int64] = field(repr=False)
    counts: tuple[int, ...]
    attached: int


def color_agents(scene: Scene, by: ColorBy, colors: BehaviorColors) -> Coloring:
    """Color the agents of a scene."""
    doing = scene.doing
    shape = _shapes(scene)
    if by is ColorBy.GROUP:
        entries, entry = _by_group(scene)
    else:
        told = _TOLD[by](doing)[doing.controllers :]
        entries = (*_behavior_entries(doing.behaviors, by, colors), _idle())
        entry = np.where(told < 0, len(doing.behaviors), told).astype(np.int64)
    entries, entry = _one_a_name(entries, entry)
    counts = np.bincount(entry, minlength=len(entries)).tolist()
    attached = int(np.count_nonzero(scene.held >= 0))
    return Coloring(entries, entry, shape, tuple(counts), attached)


def _shapes(scene: Scene) -> NDArray[np.int64]:
    doing = scene.doing
    outer = doing.behavior[doing.controllers :, 0]
    automata = np.array([ref.id != "" for ref in doing.behaviors] + [False])  # the last for -1
    shape = np.where(outer < 0, IDLES, np.where(automata[outer], RUNS, BASICS))
    return shape + np.where(scene.held >= 0, SHAPES, 0)


def _idle() -> Entry:
    grey = QColor(BASIC)
    return Entry(IDLE, (grey.red(), grey.green(), grey.blue()), IDLES)


# ------------------------------------------------------------------------------------------------- behaviors


def _outermost(doing: Doing) -> Rows:
    return doing.behavior[:, 0]


def _innermost(doing: Doing) -> Rows:
    """The last automaton on each path; where there is none, what there is instead."""
    automata = np.array([ref.id != "" for ref in doing.behaviors] + [False])
    return _last(doing.behavior, automata[doing.behavior], doing.behavior[:, 0])


def _basic(doing: Doing) -> Rows:
    """The basic behavior at the end of each path; -1 in Start."""
    basic = np.array([ref.id == "" for ref in doing.behaviors] + [False])
    nobody = np.full(len(doing.behavior), NONE, np.int32)
    return _last(doing.behavior, basic[doing.behavior], nobody)


def _last(behavior: Rows, counts: NDArray[np.bool_], otherwise: Rows) -> Rows:
    """For each row the last entry that counts."""
    levels = behavior.shape[1]
    last = levels - 1 - np.argmax(counts[:, ::-1], axis=1)
    found = behavior[np.arange(len(behavior)), last]
    return np.where(counts.any(axis=1), found, otherwise).astype(np.int32)


_TOLD: dict[ColorBy, Callable[[Doing], Rows]] = {
    ColorBy.CURRENT: lambda doing: doing.shown,
    ColorBy.OUTERMOST: _outermost,
    ColorBy.INNERMOST: _innermost,
    ColorBy.BASIC: _basic,
}


def _behavior_entries(refs: Sequence[BehaviorRef], by: ColorBy, colors: BehaviorColors) -> tuple[Entry, ...]:
    """Basic behaviors are grey, unless they are what is to be told apart: then they have colors that no automaton has."""
    basics = sorted({ref.name for ref in refs if not ref.id})
    entries = []
    for ref in refs:
        shape = RUNS if ref.id or by is ColorBy.BASIC else BASICS  # at the end of a path, mostly
        if ref.id or by is not ColorBy.BASIC:
            color = colors.color(ref.type, ref.id)
        else:
            color = nth_color(colors.count + basics.index(ref.name))
        entries.append(Entry(ref.name, (color.red(), color.green(), color.blue()), shape))
    return tuple(entries)


def _one_a_name(
    entries: tuple[Entry, ...], entry: NDArray[np.int64]
) -> tuple[tuple[Entry, ...], NDArray[np.int64]]:
    """Behaviors of one name, color and shape, of several types, share a line."""
    merged = {one: place for place, one in enumerate(dict.fromkeys(entries))}
    if len(merged) == len(entries):
        return entries, entry
    return tuple(merged), np.array([merged[one] for one in entries])[entry]


# ---------------------------------------------------------------------------------------------------- groups


def _by_group(scene: Scene) -> tuple[tuple[Entry, ...], NDArray[np.int64]]:
    """Colors by an agent's own controller."""
    return _groups_of(scene.place)


@lru_cache(maxsize=2)  # the live world's, and a stored moment's
def _groups_of(place: Place) -> tuple[tuple[Entry, ...], NDArray[np.int64]]:
    parents = place.hierarchy.parents()
    groups = list(dict.fromkeys(parents[agent] for agent in place.agents if agent in parents))
    number = {group: k for k, group in enumerate(groups)}
    entry = np.array([number.get(parents.get(agent, ""), len(groups)) for agent in place.agents], np.int64)
    entries = []
    for k, group in enumerate(groups):
        color = nth_color(k)
        entries.append(Entry(place.called(group), (color.red(), color.green(), color.blue())))
    grey = QColor(BASIC)
    alone = Entry(ALONE, (grey.red(), grey.green(), grey.blue()))
    return (*entries, alone), entry
