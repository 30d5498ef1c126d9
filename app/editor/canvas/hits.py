"""What is under the mouse; no Qt."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
from numpy.typing import NDArray

from ...sim.columns import AGENT
from .frame import Frame, load_radius
from .group_painting import MARK, hull_corners, link_ends, marked, shown_hulls, shown_links
from .groups import forest_of

#: Pixels: how near is near enough, to an agent, to anything else, and to a link.
NEAR_AGENT, NEAR, NEAR_LINK = 9.0, 6.0, 5.0
#: Pixels: what is so much farther than the nearest lies in one heap with it.
HEAP = 3.0
#: Pixels that a place is large.
PLACE = 9.0

Floats = NDArray[np.float64]


def entity_at(frame: Frame, x: float, y: float, first: Collection[int] = ()) -> int:
    """The entity at a pixel, -1 if there is none: agents before all others, which are under them.

    Args:
        first: Those that come before everything that lies upon them.
    """
    xs, ys = frame.places()
    away = np.hypot(xs - x, ys - y)
    spans = frame.scene.place.spans.items()
    sought = [
        entity
        for kind, span in spans
        for entity in first
        if entity in span and away[entity] <= _reach(frame, kind)
    ]
    if sought:
        return min(sought, key=lambda entity: float(away[entity]))
    for kind, span in sorted(spans, key=lambda item: item[0] != AGENT):
        found = _nearest(away[span.start : span.stop], _reach(frame, kind))
        if found >= 0:
            return span.start + found
    return -1


def taken_at(frame: Frame, x: float, y: float, selected: Collection[int]) -> int:
    """The entity that is taken hold of at a pixel: of a heap of agents, one of the selected, which are marked."""
    nearest = entity_at(frame, x, y)
    if nearest < 0:
        return -1
    xs, ys = frame.places()
    away = np.hypot(xs - x, ys - y)
    near = min(float(away[nearest]) + HEAP, _reach(frame, AGENT))
    heap = [agent for agent in selected if away[agent] <= near]
    return min(heap, key=lambda entity: float(away[entity]), default=nearest)


def _reach(frame: Frame, kind: str) -> float:
    """How near is near enough to one of a kind, pixels."""
    return max(frame.agent_size * 0.6, NEAR_AGENT) if kind == AGENT else body_radius(frame, kind) + NEAR / 2


def body_radius(frame: Frame, kind: str) -> float:
    """How large one of a kind is drawn, pixels."""
    if kind in frame.scene.place.look.places:
        return PLACE
    return max(load_radius(frame.scene, kind, frame.camera, frame.extent), NEAR)


def _nearest(away: Floats, reach: float) -> int:
    if not away.size:
        return -1
    nearest = int(np.argmin(away))
    return nearest if away[nearest] <= reach else -1


def agents_in(frame: Frame, left: float, top: float, right: float, bottom: float) -> tuple[str, ...]:
    """The agents in a rectangle of pixels, by number."""
    x, y = (values[: frame.scene.agents] for values in frame.places())
    inside = (x >= left) & (x <= right) & (y >= top) & (y <= bottom)
    agents = frame.scene.place.agents
    return tuple(agents[number] for number in np.flatnonzero(inside).tolist())


def controller_at(frame: Frame, x: float, y: float) -> str:
    """The controller one of whose links, or else whose hull, is at a pixel; empty if there is none."""
    row = _link_at(frame, x, y)
    if row < 0:
        row = _hull_at(frame, x, y)
    return frame.scene.place.ids[row] if row >= 0 else ""


def _link_at(frame: Frame, x: float, y: float) -> int:
    links = shown_links(frame)
    if not links.size:
        return -1
    ends = link_ends(frame, links)
    parent = forest_of(frame.scene.place).parent[links]
    rows, at = marked(frame, links, ends)
    mark = _nearest(np.hypot(at[:, 0] - x, at[:, 1] - y), MARK + 4.0)
    if mark >= 0:
        return int(rows[mark])
    link = _nearest(_away_from(ends, x, y), NEAR_LINK)
    return int(parent[link]) if link >= 0 else -1


def _away_from(ends: Floats, x: float, y: float) -> Floats:
    """Distance of a point to line segments."""
    start, way = ends[:, :2], ends[:, 2:] - ends[:, :2]
    to = np.array([x, y]) - start
    long = np.maximum((way**2).sum(axis=1), 1e-12)
    along = np.clip((to * way).sum(axis=1) / long, 0.0, 1.0)
    away: Floats = np.hypot(*(to - along[:, None] * way).T)
    return away


def _hull_at(frame: Frame, x: float, y: float) -> int:
    """The smallest hull there: a group before the squad that it is part of."""
    which = shown_hulls(frame)
    if not which.size:
        return -1
    xs, ys = hull_corners(frame, which)
    next_x, next_y = np.roll(xs, -1, axis=1), np.roll(ys, -1, axis=1)
    side = (next_x - xs) * (y - ys) - (next_y - ys) * (x - xs)
    inside = (side >= -1e-9).all(axis=1) | (side <= 1e-9).all(axis=1)
    if not inside.any():
        return -1
    area = np.abs((xs * next_y - next_x * ys).sum(axis=1))
    return int(which[np.argmin(np.where(inside, area, np.inf))])
