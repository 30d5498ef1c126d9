"""One frame of the canvas as a value: all that painting has to know."""

from __future__ import annotations

from collections.abc import Set as AbstractSet
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ..palette import Palette
from .camera import Camera, Extent
from .coloring import Coloring
from .groups import forest_of
from .scene import Scene
from .trails import Trails

#: Pixels: the least length of an arrow where there is room, and its share of the room that an agent has.
SMALLEST, LEGIBLE, SHARE = 3.0, 11.0, 0.55
#: Pixels: a load is at least so large that its count can be read, where there is room.
LOAD, LOAD_ROOM = 10.0, 0.3


@dataclass(frozen=True, slots=True)
class Options:
    """What the user wants to see besides the agents.

    Attributes:
        hulls: Of all groups; those of selected controllers are always shown.
        links: Of all controllers to who is under them, likewise.
        trails: Of the agents selected.
        all_trails: Of all agents, if there are not too many.
        ranges: How far the selected agents see and reach.
        grid: Lines every so many units.
    """

    hulls: bool = False
    links: bool = False
    trails: bool = True
    all_trails: bool = False
    ranges: bool = True
    grid: bool = True


@dataclass(frozen=True, eq=False, slots=True)
class Preview:
    """Where entities are being dragged to, world units."""

    held: NDArray[np.int64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]


@dataclass(frozen=True, eq=False, slots=True)
class Frame:
    """What is to be painted.

    Attributes:
        extent: Of the world.
        nodes: Ids of the selected nodes.
        taught: Ids of those that do what the user picks.
        pupils: Ids of those that are taught in a lesson, in the order of their turns.
        turn: The one of them whose turn it is.
        lit: Places among the entries of the coloring, or -1 for all that are attached; the others fade. None lights all.
        hovered: The entity under the mouse, or -1.
        band: A rectangle being pulled open: left, top, right, bottom, pixels.
        targets: Entities that can be chosen, if that is going on, or what keys hold.
        ratio: Pixels of the screen to one of the view.
    """

    scene: Scene
    camera: Camera
    extent: Extent
    coloring: Coloring
    palette: Palette
    trails: Trails = field(default_factory=Trails)
    options: Options = Options()
    nodes: tuple[str, ...] = ()
    taught: AbstractSet[str] = frozenset()
    lit: AbstractSet[int] | None = None
    hovered: int = -1
    preview: Preview | None = None
    band: tuple[float, float, float, float] | None = None
    targets: AbstractSet[int] | None = None
    ratio: float = 1.0
    pupils: tuple[str, ...] = ()
    turn: str = ""

    @property
    def agent_size(self) -> float:
        """Length of an agent's arrow, pixels: true to scale, but legible where there is room for that."""
        return arrow_size(self.scene, self.camera, self.extent)

    def places(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Pixels of all entities, those that are being dragged where they would be put."""
        x, y = self.camera.to_view(self.scene.x, self.scene.y)
        preview = self.preview
        if preview is not None:
            x[preview.held], y[preview.held] = self.camera.to_view(preview.x, preview.y)
        return x, y

    def selected(self) -> NDArray[np.int64]:
        """The entities of the selected agents, and of those under selected controllers."""
        return agents_of(self.scene, self.nodes)


def agents_of(scene: Scene, nodes: tuple[str, ...] | AbstractSet[str]) -> NDArray[np.int64]:
    """The entities of agents and of those under controllers."""
    chosen = np.zeros(scene.agents, np.bool_)
    for node in nodes:
        row = scene.place.rows.get(node)
        if row is None:
            continue
        if row >= scene.doing.controllers:
            chosen[row - scene.doing.controllers] = True
        else:
            first, end = _span(scene, row)
            chosen[first:end] = True
    return np.flatnonzero(chosen)


def _span(scene: Scene, row: int) -> tuple[int, int]:
    forest = forest_of(scene.place)
    return int(forest.first[row]), int(forest.end[row])


def arrow_size(scene: Scene, camera: Camera, extent: Extent) -> float:
    """See `Frame.agent_size`."""
    true = scene.reach("agent") * 2 * camera.scale
    least = min(max(SHARE * _room(scene.agents, camera, extent), SMALLEST), LEGIBLE)
    return max(true, least)


def load_radius(scene: Scene, kind: str, camera: Camera, extent: Extent) -> float:
    """Pixels: true to scale, but large enough for words where there is room."""
    true = scene.reach(kind) * camera.scale
    room = _room(len(scene.place.spans[kind]), camera, extent)
    return max(true, min(LOAD, LOAD_ROOM * room), 2.0)


def _room(many: int, camera: Camera, extent: Extent) -> float:
    """Side of the square that each of so many entities would have for itself, pixels."""
    return float(np.sqrt(max(extent.width * extent.height, 1e-9) / max(many, 1))) * camera.scale
