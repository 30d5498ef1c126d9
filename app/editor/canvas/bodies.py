"""Painting what is neither agent nor place: loads with how many hold them of how many they need, and all other things."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPixmap

from ...sim.columns import AGENT
from ..theme import text_font
from .frame import Frame, load_radius
from .ink import Ink

#: Pixels of words in a load, and the radius from which on there are some.
WORDS, ROOM = 10, 7.5
#: Pixels: larger bodies are drawn anew each time, rather than kept.
LARGE = 60.0


def paint_bodies(painter: QPainter, frame: Frame, ink: Ink) -> None:
    """Every entity that is neither agent nor place, and counts where there is room for them."""
    scene, look = frame.scene, frame.scene.place.look
    x, y = (values.tolist() for values in frame.places())
    for kind, span in scene.place.spans.items():
        if kind == AGENT or kind in look.places:
            continue
        true = load_radius(scene, kind, frame.camera, frame.extent)
        for entity, words, full in _told(frame, kind, span):
            radius = _wide_enough(ink, words, true)
            if _in_view(frame, x[entity], y[entity], radius):
                _paint_kept(painter, frame, ink, QPointF(x[entity], y[entity]), (words, radius, full))


def paint_counts(painter: QPainter, frame: Frame, ink: Ink) -> None:
    """The counts of loads that somebody holds once more, over who holds them."""
    scene, look = frame.scene, frame.scene.place.look
    span = scene.place.spans.get(look.loads)
    if span is None or not look.got:
        return
    true = load_radius(scene, look.loads, frame.camera, frame.extent)
    x, y = frame.places()
    for entity, words, _ in _told(frame, look.loads, span) if true >= ROOM else ():
        if words.startswith("0/") or not _in_view(frame, x[entity], y[entity], true):
            continue
        key = ("count", words, frame.palette.raised, frame.ratio)
        pixmap = ink.pixmap(key, partial(_count, frame, words))
        size = pixmap.deviceIndependentSize()
        painter.drawPixmap(QPointF(x[entity] - size.width() / 2, y[entity] - size.height() / 2), pixmap)


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


def _told(frame: Frame, kind: str, span: range) -> Iterator[tuple[int, str, bool]]:
    """Entities of a kind with what is written on them, and whether as many hold them as they need."""
    look, columns = frame.scene.place.look, frame.scene.columns
    if kind != look.loads or not (look.got and look.needed):
        yield from ((entity, "", False) for entity in span)
        return
    got = np.asarray(columns[look.got])[span.start : span.stop].tolist()
    needed = np.asarray(columns[look.needed])[span.start : span.stop].tolist()
    for entity, have, need in zip(span, got, needed, strict=True):
        yield entity, f"{have}/{need}", 0 < need <= have


def _wide_enough(ink: Ink, words: str, true: float) -> float:
    """A radius with room for the words, unless the body is too small for any."""
    if not words or true < ROOM:
        return true
    return max(true, min(ink.size(words, WORDS).width() / 2 + 3.0, 1.7 * true))


def _in_view(frame: Frame, x: float, y: float, radius: float) -> bool:
    return -radius < x < frame.camera.width + radius and -radius < y < frame.camera.height + radius


def _paint_kept(
    painter: QPainter, frame: Frame, ink: Ink, center: QPointF, body: tuple[str, float, bool]
) -> None:
    """A body from a pixmap that was drawn before."""
    words, radius, full = body
    if radius > LARGE:
        _paint_body(painter, frame, ink, center, body)
        return
    radius = round(radius * 2) / 2
    key = (words, radius, full, frame.palette.raised, frame.ratio)
    pixmap = ink.pixmap(key, lambda: _drawn(frame, ink, (words, radius, full)))
    half = pixmap.width() / frame.ratio / 2
    painter.drawPixmap(center - QPointF(half, half), pixmap)


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
