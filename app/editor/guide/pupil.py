"""Whom to take in hand: an agent that sees no box, so that wandering is the right thing for it to do."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ...engine.snapshots import Snapshot
    from ..studio import Studio

#: World units beyond sight: it walks on until the user has pressed the key.
AWAY = 6.0


def choose_pupil(studio: Studio) -> None:
    """Have an agent selected that sees no box: the one that is if it sees none, otherwise the farthest from any."""
    snapshot = studio.snapshot
    if snapshot is None:
        return
    far, agents = distances(snapshot), snapshot.place.agents
    chosen = studio.selection.node
    enough = float(snapshot.place.parameters["sight"]) + AWAY
    if chosen not in agents or far[agents.index(chosen)] <= enough:
        studio.selection.select_nodes([agents[int(far.argmax())]])


def distances(snapshot: Snapshot) -> NDArray[np.float64]:
    """How far each agent is from the nearest box, in world units."""
    x, y = (np.asarray(snapshot.columns[name], np.float64) for name in ("x", "y"))
    boxes = snapshot.place.spans["box"]
    agents, those = slice(0, len(snapshot.place.agents)), slice(boxes.start, boxes.stop)
    apart = np.hypot(x[agents, None] - x[None, those], y[agents, None] - y[None, those])
    nearest: NDArray[np.float64] = apart.min(axis=1, initial=np.inf)
    return nearest
