"""Painting controllers: a hull around the agents of each, and links to who is under it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QPainter, QPen

from ...sim.doing import NONE
from ..behavior_colors import BehaviorColors, nth_color
from .arrays import draw_lines, draw_polygon
from .coloring import ColorBy
from .frame import Frame
from .groups import Forest, forest_of, hulls, nodes_at

#: Pixels: how far a hull stays away from its agents, and half the side of a controller's mark.
AROUND, MARK = 11.0, 5.0
#: More hulls or links than this are drawn without smooth edges, and hulls without a fill.
SMOOTH, SMOOTH_LINKS = 80, 600


def shown_hulls(frame: Frame) -> NDArray[np.int64]:
    """Rows of the controllers whose hulls are shown, the highest level first: all, or those selected."""
    forest = forest_of(frame.scene.place)
    if frame.options.hulls:
        return np.arange(forest.controllers)
    return _selected(frame, forest)


def shown_links(frame: Frame) -> NDArray[np.int64]:
    """Places among the links of those that are shown: all, or those of selected controllers and all below."""
    forest = forest_of(frame.scene.place)
    if frame.options.links:
        return np.arange(len(forest.parent))
    chosen = np.isin(forest.parent, _selected(frame, forest))
    return np.flatnonzero(chosen)


def _selected(frame: Frame, forest: Forest) -> NDArray[np.int64]:
    rows = [frame.scene.place.rows.get(node, forest.controllers) for node in frame.nodes]
    return np.array(sorted(row for row in set(rows) if row < forest.controllers), np.int64)


def hull_corners(frame: Frame, which: NDArray[np.int64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The corners of hulls, pixels: controllers x corners. Those of higher levels lie farther out."""
    forest, agents = forest_of(frame.scene.place), frame.scene.agents
    x, y = frame.places()
    outward = AROUND + 4.0 * (forest.level[which] - 1)
    return hulls(x[:agents], y[:agents], forest, which, np.asarray(outward, np.float64))


def link_ends(frame: Frame, which: NDArray[np.int64]) -> NDArray[np.float64]:
    """Both ends of links, pixels: links x (x, y, x, y), from the controller."""
    forest = forest_of(frame.scene.place)
    x, y = frame.camera.to_view(*nodes_at(frame.scene))
    parent, child = forest.parent[which], forest.child[which]
    return np.stack((x[parent], y[parent], x[child], y[child]), axis=1)


def controller_colors(frame: Frame, by: ColorBy, colors: BehaviorColors) -> list[QColor]:
    """The color of each controller: of the behavior that it shows, or of its group where groups are told apart."""
    forest, doing = forest_of(frame.scene.place), frame.scene.doing
    if by is ColorBy.GROUP:
        bottom = np.cumsum(forest.level == 1) - 1
        return [
            nth_color(int(k)) if level == 1 else QColor(frame.palette.dim)
            for k, level in zip(bottom, forest.level, strict=True)
        ]
    by_ref = [colors.color(ref.type, ref.id) for ref in doing.behaviors]
    grey = QColor(frame.palette.dim)
    return [grey if shown == NONE else by_ref[shown] for shown in doing.shown[: doing.controllers].tolist()]


def paint_groups(painter: QPainter, frame: Frame, colors: list[QColor]) -> None:
    """The hulls and links that are to be seen, under everything that moves."""
    which = shown_hulls(frame)
    if which.size:
        x, y = hull_corners(frame, which)
        corners, few = np.stack((x, y), axis=2), len(which) <= SMOOTH
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, few)
        lowest = forest_of(frame.scene.place).level[which] == 1
        for k, row in enumerate(which.tolist()):
            filled = few and (bool(lowest[k]) or not frame.options.hulls)
            _paint_hull(painter, corners[k], colors[row], filled=filled)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    links = shown_links(frame)
    if links.size:
        _paint_links(painter, frame, links, colors)


def _paint_hull(painter: QPainter, corners: NDArray[np.float64], color: QColor, *, filled: bool) -> None:
    fill, edge = QColor(color), QColor(color)
    fill.setAlphaF(0.08)
    edge.setAlphaF(0.5)
    painter.setBrush(QBrush(fill) if filled else Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(edge, 1.0))
    draw_polygon(painter, corners)


def _paint_links(painter: QPainter, frame: Frame, links: NDArray[np.int64], colors: list[QColor]) -> None:
    ends = link_ends(frame, links)
    parents = forest_of(frame.scene.place).parent[links]
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, len(links) <= SMOOTH_LINKS)
    by_color: dict[str, list[int]] = {}
    for k, parent in enumerate(parents.tolist()):
        by_color.setdefault(colors[parent].name(), []).append(k)
    for name, places in by_color.items():
        color = QColor(name)
        color.setAlphaF(0.55)
        painter.setPen(QPen(color, 1.0))
        draw_lines(painter, ends[places])
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor(frame.palette.canvas), 1.0))
    for parent in np.unique(parents).tolist():
        k = int(np.flatnonzero(parents == parent)[0])
        painter.setBrush(colors[parent])
        _paint_mark(painter, QPointF(ends[k, 0], ends[k, 1]))


def _paint_mark(painter: QPainter, at: QPointF) -> None:
    """A controller is a square: nothing else is."""
    painter.drawRect(QRectF(at.x() - MARK, at.y() - MARK, 2 * MARK, 2 * MARK))


def paint_band(painter: QPainter, frame: Frame) -> None:
    """The rectangle that is being pulled open."""
    if frame.band is None:
        return
    left, top, right, bottom = frame.band
    fill = QColor(frame.palette.accent)
    painter.setPen(QPen(fill, 1.0, Qt.PenStyle.DashLine))
    fill.setAlphaF(0.12)
    painter.setBrush(fill)
    painter.drawRect(QRectF(QPointF(left, top), QPointF(right, bottom)))
