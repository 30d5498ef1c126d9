"""Painting what is neither agent nor place: loads with how many hold them of how many they need, and all other things."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPixmap

from ...sim.columns import AGENT
from ..theme import text_font
from .arrays import Floats, draw_copies
from .frame import Frame, load_radius
from .ink import Ink

#: Pixels of words in a load, and the radius from which on there are some.
WORDS, ROOM = 10, 7.5
#: Pixels: larger bodies are drawn anew each time, rather than kept.
LARGE = 60.0

Rows = NDArray[np.int64]


def paint_bodies(painter: QPainter, frame: Frame, ink: Ink) -> None:
    """Every entity that is neither agent nor place, and counts where there is room for them."""
    scene, look = frame.scene, frame.scene.place.look
    for kind, span in scene.place.spans.items():
        if kind == AGENT or kind in look.places:
            continue
        true = load_radius(scene, kind, frame.camera, frame.extent)
        for entities, words, full in _sorts(frame, kind, span):
            radius = _wide_enough(ink, words, true)
            x, y = _in_view(frame, entities, radius)
            if x.size:
                _paint_all(painter, frame, ink, (x, y), (words, radius, full))


def paint_counts(painter: QPainter, frame: Frame, ink: Ink) -> None:
    """The counts of loads that somebody holds once more, over who holds them."""
    scene, look = frame.scene, frame.scene.place.look
    span = scene.place.spans.get(look.loads)
    if span is None or not look.got:
        return
    true = load_radius(scene, look.loads, frame.camera, frame.extent)
    for entities, words, _ in _sorts(frame, look.loads, span) if true >= ROOM else ():
        x, y = _in_view(frame, entities, true)
        if x.size and not words.startswith("0/"):
            key = ("count", words, frame.palette.raised, frame.ratio)
            draw_copies(painter, ink.pixmap(key, partial(_count, frame, words)), x, y)


def _count(frame: Frame, words: str) -> QPixmap:
    """Words with an edge that stands out from whatever is behind."""
    path = QPainterPath()
    path.addText(0.0, 0.0, text_font(WORDS), words)
    box = path.boundingRect().adjusted(-2.0, -2.0, 2.0, 2.0)
    pixmap = QPixmap(round(box.width() * frame.ratio), round(box.height() * frame.ratio))
    pixmap.setDevicePixelRatio(frame.ratio)
    pixmap.fill(QColor(0, 0, 0, 0))
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.translate(-box.topLeft())
    painter.strokePath(path, QPen(QColor(frame.palette.raised), 3.0, j=Qt.PenJoinStyle.RoundJoin))
    painter.fillPath(path, QColor(frame.palette.text))
    painter.end()
    return pixmap


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


def _paint_all(
    painter: QPainter, frame: Frame, ink: Ink, places: tuple[Floats, Floats], body: tuple[str, float, bool]
) -> None:
    """The same body at many places, from a pixmap that was drawn before."""
    words, radius, full = body
    if radius > LARGE:
        for x, y in zip(*(values.tolist() for values in places), strict=True):
            _paint_body(painter, frame, ink, QPointF(x, y), body)
        return
    radius = round(radius * 2) / 2
    key = (words, radius, full, frame.palette.raised, frame.ratio)
    draw_copies(painter, ink.pixmap(key, partial(_drawn, frame, ink, (words, radius, full))), *places)


def _drawn(frame: Frame, ink: Ink, body: tuple[str, float, bool]) -> QPixmap:
    side = int(2 * (body[1] + 3.0) * frame.ratio)
    pixmap = QPixmap(side, side)
    pixmap.setDevicePixelRatio(frame.ratio)
    pixmap.fill(QColor(0, 0, 0, 0))
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    middle = side / frame.ratio / 2
    _paint_body(painter, frame, ink, QPointF(middle, middle), body)
    painter.end()
    return pixmap


def _paint_body(
    painter: QPainter, frame: Frame, ink: Ink, center: QPointF, body: tuple[str, float, bool]
) -> None:
    """A disk: green and thicker at the edge if it is full."""
    (words, radius, full), colors = body, frame.palette
    painter.setBrush(QColor(colors.raised))
    painter.setPen(QPen(QColor(colors.good if full else colors.dim), 2.0 if full else 1.4))
    painter.drawEllipse(center, radius, radius)
    if words and radius >= ROOM:
        ink.write(painter, center, words, QColor(colors.text), WORDS, centered=True)
