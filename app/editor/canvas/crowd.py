"""Painting agents: all at once, from an atlas; and where those that matter have been, are, and reach to."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from ..arrays import draw_copies, draw_fragments, draw_lines, draw_points
from .atlas import LARGEST, Look, Style
from .coloring import SHAPES
from .frame import Frame, agents_of
from .ink import Ink
from .pupils import MOST_WIDE, paint_pupils
from .stamp import stamp
from .trails import MOST

#: How much those stay visible that the legend does not light up.
FADED = 0.2
#: Up to so many selected agents get trails and ranges; up to so many agents trails if the user wants all.
MOST_TRAILS, MOST_RANGES, MOST_OF_ALL = 40, 8, 500
#: Letters of the words beside the selected agent; the inspector has the rest.
MOST_LETTERS = 48
#: Pieces that a trail fades away in, and how much the newest is visible.
PIECES, STRONGEST = 6, 0.75
#: So many of the newest places are shown where all agents have trails.
SHORT = 40
#: A body with an outline of its own begins at this many pixels.
OUTLINED = 14.0


def paint_agents(painter: QPainter, frame: Frame, ink: Ink) -> None:
    """All agents in view."""
    scene, camera, size = frame.scene, frame.camera, frame.agent_size
    x, y = (values[: scene.agents] for values in frame.places())
    near = (x > -size) & (x < camera.width + size) & (y > -size) & (y < camera.height + size)
    seen = np.flatnonzero(near)
    if not seen.size:
        return
    looks, row = _looks(frame, seen)
    style = Style(size, frame.ratio, frame.palette.canvas, frame.palette.text)
    if size > LARGEST or scene.reach("agent") * 2 * camera.scale > OUTLINED:
        _paint_outlines(painter, frame, x[seen], y[seen])
    heading = np.asarray(scene.columns["heading"], np.float64)[seen]
    atlas = ink.atlas(looks, style)
    draw_fragments(
        painter, atlas.fragments(x[seen], y[seen], heading, row, _opacity(frame, seen)), atlas.pixmap
    )


def _looks(frame: Frame, seen: NDArray[np.int64]) -> tuple[list[Look], NDArray[np.int64]]:
    """The looks that any agent has, so that an atlas lasts; and which one each agent in view has."""
    coloring = frame.coloring
    many = 2 * SHAPES
    number = coloring.entry * many + coloring.shape
    used = np.flatnonzero(np.bincount(number, minlength=len(coloring.entries) * many))
    place = np.zeros(len(coloring.entries) * many, np.int64)
    place[used] = np.arange(len(used))
    looks = [Look(coloring.entries[code // many].color, code % many) for code in used.tolist()]
    return looks, place[number[seen]]


def _opacity(frame: Frame, seen: NDArray[np.int64]) -> NDArray[np.float64]:
    if frame.lit is None:
        return np.ones(len(seen))
    lit = np.isin(frame.coloring.entry[seen], [entry for entry in frame.lit if entry >= 0])
    if -1 in frame.lit:
        lit |= frame.scene.held[seen] >= 0
    return np.where(lit, 1.0, FADED)


def _paint_outlines(painter: QPainter, frame: Frame, x: NDArray[np.float64], y: NDArray[np.float64]) -> None:
    """How large agents are, where they are large."""
    radius = frame.scene.reach("agent") * frame.camera.scale
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(QColor(frame.palette.hairline), 1.0))
    for left, top in zip(x.tolist(), y.tolist(), strict=True):
        painter.drawEllipse(QPointF(left, top), radius, radius)


# ---------------------------------------------------------------------------------------------------- trails


def paint_trails(painter: QPainter, frame: Frame) -> None:
    """Where the selected agents, or all, have been, fading with time."""
    chosen = frame.selected()
    if frame.options.all_trails and frame.scene.agents <= MOST_OF_ALL:
        _paint_all_trails(painter, frame)
    if frame.options.trails and 0 < chosen.size <= MOST_TRAILS:
        ends, ways = _trail_ends(frame, chosen, MOST), frame.trails.are_ways()
        for k, agent in enumerate(chosen.tolist()):
            _paint_trail(painter, frame, agent, ends[:, k], ways)


def _trail_ends(frame: Frame, agents: NDArray[np.int64], newest: int) -> NDArray[np.float64]:
    """The pieces of trails on the screen: times x agents x (x, y from, x, y to)."""
    x, y = frame.camera.to_view(*(np.asarray(v, np.float64) for v in frame.trails.of(agents, newest)))
    return np.stack((x[:-1], y[:-1], x[1:], y[1:]), axis=2)


def _paint_trail(
    painter: QPainter, frame: Frame, agent: int, ends: NDArray[np.float64], ways: NDArray[np.bool_]
) -> None:
    """Piece by piece: as one, a line that crosses itself often takes Qt many times as long."""
    color = QColor(*frame.coloring.entries[frame.coloring.entry[agent]].color)
    for k, piece in enumerate(np.array_split(np.arange(len(ends)), PIECES)):
        color.setAlphaF(STRONGEST * (k + 1) / PIECES)
        painter.setPen(QPen(color, 1.6, Qt.PenStyle.SolidLine, Qt.PenCapStyle.FlatCap))
        draw_lines(painter, ends[piece][ways[piece]])
        painter.setPen(QPen(color, 2.4, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
        draw_points(painter, ends[piece][~ways[piece], 2:])


def _paint_all_trails(painter: QPainter, frame: Frame) -> None:
    ends, ways = _trail_ends(frame, np.arange(frame.scene.agents), SHORT), frame.trails.are_ways(SHORT)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    for entry in np.unique(frame.coloring.entry).tolist():
        color = QColor(*frame.coloring.entries[entry].color)
        color.setAlphaF(0.35)
        painter.setPen(QPen(color, 1.0))
        own = ends[:, frame.coloring.entry == entry]
        draw_lines(painter, own[ways].reshape(-1, 4))
        draw_points(painter, own[~ways, :, 2:].reshape(-1, 2))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)


# ------------------------------------------------------------------------------------- those that are looked at


def paint_ranges(painter: QPainter, frame: Frame) -> None:
    """How far the selected agents see and reach."""
    look = frame.scene.place.look
    chosen = [node for node in frame.nodes if frame.scene.entity(node) >= 0]
    if not frame.options.ranges or not 0 < len(chosen) <= MOST_RANGES:
        return
    x, y = frame.places()
    accent = QColor(frame.palette.accent)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for node in chosen:
        entity = frame.scene.entity(node)
        for radius in look.ranges.get("agent", {}).values():
            painter.setPen(QPen(accent, 1.2, Qt.PenStyle.DashLine))
            size = radius * frame.camera.scale
            painter.drawEllipse(QPointF(x[entity], y[entity]), size, size)


def paint_rings(painter: QPainter, frame: Frame, ink: Ink) -> None:
    """Rings around the nodes that are taught, selected, and under the mouse; a label at the one that panels show."""
    x, y = frame.places()
    radius = max(frame.agent_size * 0.5 + 5.0, 8.0)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    selected, taught = frame.selected(), agents_of(frame.scene, frame.taught)
    if selected.size > MOST_WIDE:
        _paint_tight_rings(painter, frame, selected, QColor(frame.palette.accent))
    else:
        painter.setPen(QPen(QColor(frame.palette.accent), 2.0))
        for entity in selected.tolist():
            painter.drawEllipse(QPointF(x[entity], y[entity]), radius, radius)
    crowded = taught.size > MOST_WIDE
    if crowded:
        _paint_tight_rings(painter, frame, taught, QColor(frame.palette.teach))
    paint_pupils(painter, frame, ink, radius + 3.0, crowded=crowded)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    if 0 <= frame.hovered < len(x):
        _paint_hovered(painter, frame, QPointF(x[frame.hovered], y[frame.hovered]), radius)
    if frame.nodes:
        _paint_label(painter, frame, ink, radius)


def _paint_tight_rings(painter: QPainter, frame: Frame, agents: NDArray[np.int64], color: QColor) -> None:
    """Rings around very many, close around each, from one picture of a ring: wide ones would cover the world."""
    radius = frame.agent_size * 0.5 + 2.0
    side = 2 * (radius + 1.0)

    def draw(onto: QPainter) -> None:
        onto.setPen(QPen(color, 1.2))
        onto.drawEllipse(QPointF(0.0, 0.0), radius, radius)

    x, y = frame.places()
    draw_copies(painter, stamp(QSizeF(side, side), frame.ratio, draw), x[agents], y[agents])


def _paint_hovered(painter: QPainter, frame: Frame, center: QPointF, radius: float) -> None:
    if frame.hovered >= frame.scene.agents:
        kind = frame.scene.kind(frame.hovered)
        radius = max(radius, frame.scene.reach(kind) * frame.camera.scale + 4.0, 14.0)
    painter.setPen(QPen(QColor(frame.palette.text), 1.2))
    painter.drawEllipse(center, radius, radius)


def _paint_label(painter: QPainter, frame: Frame, ink: Ink, radius: float) -> None:
    """Who the selected agent is, and what it does, in words."""
    entity = frame.scene.entity(frame.nodes[-1])
    if entity < 0:
        return
    x, y = frame.places()
    doing = frame.coloring.entries[frame.coloring.entry[entity]].words
    words = f"{frame.scene.place.called(frame.nodes[-1])} · {doing}"
    if len(words) > MOST_LETTERS:
        words = f"{words[: MOST_LETTERS - 1]}…"
    size = ink.size(words, 11)
    left = x[entity] + radius + 8.0
    if left + size.width() > frame.camera.width - 4.0:
        left = x[entity] - radius - 8.0 - size.width()
    ground = QColor(frame.palette.canvas)
    ground.setAlphaF(0.88)
    box = QRectF(left - 3, y[entity] - size.height() / 2 - 1, size.width() + 6, size.height() + 2)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(ground)
    painter.drawRoundedRect(box, 4, 4)
    ink.write(painter, QPointF(left, y[entity]), words, QColor(frame.palette.text), 11)
