"""Painting what is neither agent nor place: loads with how many hold them of how many they need, and all other things."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QSizeF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPixmap

from ...sim.columns import AGENT
from ..arrays import Floats, draw_copies
from ..theme import text_font
from .frame import Frame, load_radius
from .ink import Ink
from .stamp import stamp

#: Pixels of words in a load, and the radius from which on there are some.
WORDS, ROOM = 10, 7.5
#: Pixels: larger bodies are drawn anew each time, rather than kept.
LARGE = 60.0

Rows = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Body:
    """How some bodies look that differ only in where they are.

    Attributes:
        words: What is written on them, where there is room.
        radius: Pixels of the view.
        full: As many hold them as they need.
    """

    words: str
    radius: float
    full: bool


def paint_bodies(painter: QPainter, frame: Frame, ink: Ink) -> None:
    """Every entity that is neither agent nor place, and counts where there is room for them."""
    scene, look = frame.scene, frame.scene.place.look
    for kind, span in scene.place.spans.items():
        if kind == AGENT or kind in look.places:
            continue
        true = load_radius(scene, kind, frame.camera, frame.extent)
        for entities, words, full in _sorts(frame, kind, span):
            body = Body(words, _wide_enough(ink, words, true), full)
            x, y = _in_view(frame, entities, body.radius)
            if x.size:
                _paint_all(painter, frame, ink, (x, y), body)


def paint_counts(painter: QPainter, frame: Frame, ink: Ink) -> None:
    """The counts of loads that somebody holds once more, over who holds them."""
    scene, look = frame.scene, frame.scene.place.look
    span = scene.place.spans.get(look.loads)
    if span is None or not look.got:
        return
    true = load_radius(scene, look.loads, frame.camera, frame.extent)
    if true < ROOM:
        return
    for entities, words, _ in _sorts(frame, look.loads, span):
        x, y = _in_view(frame, entities, true)
        if x.size and not words.startswith("0/"):
            key = ("count", words, frame.palette.raised, frame.ratio)
            draw_copies(painter, ink.pixmap(key, partial(_count, frame, words)), x, y)


def _count(frame: Frame, words: str) -> QPixmap:
    """Words with an edge that stands out from whatever is behind."""
    path = QPainterPath()
    path.addText(0.0, 0.0, text_font(WORDS), words)
    box = path.boundingRect().adjusted(-2.0, -2.0, 2.0, 2.0)

    def draw(painter: QPainter) -> None:
        painter.translate(-box.center())
        painter.strokePath(path, QPen(QColor(frame.palette.raised), 3.0, j=Qt.PenJoinStyle.RoundJoin))
        painter.fillPath(path, QColor(frame.palette.text))

    return stamp(box.size(), frame.ratio, draw)


def _sorts(frame: Frame, kind: str, span: range) -> Iterator[tuple[Rows, str, bool]]:
    """The entities of a kind by what is written on them, and whether as many hold them as they need."""
    look, columns = frame.scene.place.look, frame.scene.columns
    everyone = np.arange(span.start, span.stop)
    if kind != look.loads or not (look.got and look.needed):
        yield everyone, "", False
        return
    got, needed = (np.asarray(columns[name], np.int64)[everyone] for name in (look.got, look.needed))
    pairs, which = np.unique(np.stack((got, needed), axis=1), axis=0, return_inverse=True)
    for k, (have, need) in enumerate(pairs.tolist()):
        yield everyone[which.reshape(-1) == k], f"{have}/{need}", 0 < need <= have


def _wide_enough(ink: Ink, words: str, true: float) -> float:
    """A radius with room for the words, unless the body is too small for any."""
    if not words or true < ROOM:
        return true
    return max(true, min(ink.size(words, WORDS).width() / 2 + 3.0, 1.7 * true))


def _in_view(frame: Frame, entities: Rows, radius: float) -> tuple[Floats, Floats]:
    """Where those of them are of which something can be seen."""
    x, y = (values[entities] for values in frame.places())
    across, down = (
        (-radius < values) & (values < size + radius)
        for values, size in ((x, frame.camera.width), (y, frame.camera.height))
    )
    return x[across & down], y[across & down]


def _paint_all(painter: QPainter, frame: Frame, ink: Ink, places: tuple[Floats, Floats], body: Body) -> None:
    """The same body at many places, from a pixmap that was drawn before."""
    if body.radius > LARGE:
        for x, y in zip(*(values.tolist() for values in places), strict=True):
            _paint_body(painter, frame, ink, QPointF(x, y), body)
        return
    body = replace(body, radius=round(body.radius * 2) / 2)
    key = (body, frame.palette.raised, frame.ratio)
    draw_copies(painter, ink.pixmap(key, partial(_drawn, frame, ink, body)), *places)


def _drawn(frame: Frame, ink: Ink, body: Body) -> QPixmap:
    side = 2 * (body.radius + 3.0)
    return stamp(
        QSizeF(side, side),
        frame.ratio,
        lambda painter: _paint_body(painter, frame, ink, QPointF(0.0, 0.0), body),
    )


def _paint_body(painter: QPainter, frame: Frame, ink: Ink, center: QPointF, body: Body) -> None:
    """A disk: green and thicker at the edge if it is full."""
    colors = frame.palette
    painter.setBrush(QColor(colors.raised))
    painter.setPen(QPen(QColor(colors.good if body.full else colors.dim), 2.0 if body.full else 1.4))
    painter.drawEllipse(center, body.radius, body.radius)
    if body.words and body.radius >= ROOM:
        ink.write(painter, center, body.words, QColor(colors.text), WORDS, centered=True)
