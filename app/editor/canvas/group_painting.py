"""Painting controllers: a hull around the agents of each, and links to who is under it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from ...sim.doing import NONE
from ..arrays import draw_lines, draw_polygon
from ..behavior_colors import BehaviorColors, nth_color
from ..theme import mixed
from .coloring import ColorBy
from .frame import Frame
from .groups import Forest, forest_of, hulls, nodes_at

#: Pixels: how far a hull stays away from its agents, and half the side of a controller's mark.
AROUND, MARK = 11.0, 5.0
#: More hulls or links than this are drawn without smooth edges, and hulls without a fill.
SMOOTH, SMOOTH_LINKS = 80, 600
#: Of more controllers than this, only the highest levels are shown, and what is selected: more cover the world.
MOST_SHOWN = 100


def shown_hulls(frame: Frame) -> NDArray[np.int64]:
    """Rows of the controllers whose hulls are shown, the highest level first: those told apart, or those selected."""
    forest = forest_of(frame.scene.place)
    chosen = _selected(frame, forest)
    if frame.options.hulls:
        below = forest.child[np.isin(forest.parent, chosen) & (forest.child < forest.controllers)]
        return np.unique(np.concatenate((_told_apart(forest), chosen, below)))
    return chosen


def shown_links(frame: Frame) -> NDArray[np.int64]:
    """Places among the links of those that are shown: from controllers told apart, and from those selected."""
    forest = forest_of(frame.scene.place)
    above = _selected(frame, forest)
    if frame.options.links:
        above = np.concatenate((_told_apart(forest), above))
    return np.flatnonzero(np.isin(forest.parent, above))


def _told_apart(forest: Forest) -> NDArray[np.int64]:
    """Rows of all controllers, or where there are too many, of the highest level and as many levels more as can be."""
    levels, counts = np.unique(-forest.level, return_counts=True)
    fitting = max(1, int((np.cumsum(counts) <= MOST_SHOWN).sum()))
    return np.flatnonzero(np.isin(-forest.level, levels[:fitting]))


def _selected(frame: Frame, forest: Forest) -> NDArray[np.int64]:
    row_of, above = frame.scene.place.rows.get, forest.controllers
    rows = np.array([row_of(node, above) for node in frame.nodes], np.int64)
    return np.unique(rows[rows < above])


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


def marked(
    frame: Frame, links: NDArray[np.int64], ends: NDArray[np.float64]
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Rows of the controllers at either end of links, and where their marks are, pixels: controllers x (x, y).

    Args:
        ends: Of the links.
    """
    forest = forest_of(frame.scene.place)
    child = forest.child[links]
    under = child < forest.controllers
    rows = np.concatenate((forest.parent[links], child[under]))
    shown, first = np.unique(rows, return_index=True)
    return shown, np.concatenate((ends[:, :2], ends[under, 2:]))[first]


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
        _paint_hulls(painter, frame, which, colors)
    links = shown_links(frame)
    if links.size:
        _paint_links(painter, frame, links, colors)


def _paint_hulls(painter: QPainter, frame: Frame, which: NDArray[np.int64], colors: list[QColor]) -> None:
    """Few with a fill, groups before squads where all are shown; many as lines, all of a color at once."""
    corners = np.stack(hull_corners(frame, which), axis=2)
    few = len(which) <= SMOOTH
    if few:
        lowest = (forest_of(frame.scene.place).level[which] == 1).tolist()
        for k, row in enumerate(which.tolist()):
            fill = QColor(colors[row])
            fill.setAlphaF(0.08 if lowest[k] or not frame.options.hulls else 0.0)
            painter.setBrush(fill)
            painter.setPen(QPen(_faint(colors[row], 0.5, frame, few=few), 1.0))
            draw_polygon(painter, corners[k])
        return
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    edges = np.concatenate((corners, np.roll(corners, -1, axis=1)), axis=2)
    for name, places in _by_color(which, colors).items():
        painter.setPen(QPen(_faint(QColor(name), 0.5, frame, few=few), 1.0))
        draw_lines(painter, edges[places].reshape(-1, 4))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)


def _by_color(rows: NDArray[np.int64], colors: list[QColor]) -> dict[str, list[int]]:
    """Places among *rows*, by the name of the color of each row."""
    names = [color.name() for color in colors]
    found: dict[str, list[int]] = {}
    for place, row in enumerate(rows.tolist()):
        found.setdefault(names[row], []).append(place)
    return found


def _faint(color: QColor, share: float, frame: Frame, *, few: bool) -> QColor:
    """A color of which so much is visible. Of many lines none shines through: that is ten times faster."""
    if not few:
        return mixed(color.name(), frame.palette.canvas, 1.0 - share)
    faint = QColor(color)
    faint.setAlphaF(share)
    return faint


def _paint_links(painter: QPainter, frame: Frame, links: NDArray[np.int64], colors: list[QColor]) -> None:
    ends = link_ends(frame, links)
    parents = forest_of(frame.scene.place).parent[links]
    few = len(links) <= SMOOTH_LINKS
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, few)
    for name, places in _by_color(parents, colors).items():
        painter.setPen(QPen(_faint(QColor(name), 0.55, frame, few=few), 1.0))
        draw_lines(painter, ends[places])
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor(frame.palette.canvas), 1.0))
    shown, at = marked(frame, links, ends)
    for name, places in _by_color(shown, colors).items():
        painter.setBrush(QColor(name))
        painter.drawRects([_mark(*at[k].tolist()) for k in places])


def _mark(x: float, y: float) -> QRectF:
    """A controller is a square: nothing else is."""
    return QRectF(x - MARK, y - MARK, 2 * MARK, 2 * MARK)


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
