"""Where controllers are, and the hulls around their agents."""

from __future__ import annotations

import numpy as np
from scipy.spatial import ConvexHull

from app.editor.canvas.frame import agents_of
from app.editor.canvas.groups import forest_of, hulls, nodes_at
from tests.corridor import corridor, project
from tests.unit.editor.canvas.worlds import scene

SQUADS = scene(project(), corridor, "squads")


def test_every_controller_has_its_own_agents_the_highest_level_first() -> None:
    forest = forest_of(SQUADS.place)
    assert forest.level.tolist() == [2, 1, 1]
    assert list(zip(forest.first.tolist(), forest.end.tolist(), strict=True)) == [(0, 4), (0, 2), (2, 4)]


def test_every_node_with_a_controller_is_linked_to_it() -> None:
    forest, ids = forest_of(SQUADS.place), SQUADS.place.ids
    links = {ids[child]: ids[parent] for parent, child in zip(forest.parent, forest.child, strict=True)}
    assert links == SQUADS.place.hierarchy.parents()


def test_a_controller_is_in_the_middle_of_its_agents() -> None:
    x, y = nodes_at(SQUADS)
    assert x.tolist() == [15.0, 5.0, 25.0, 0.0, 10.0, 20.0, 30.0]
    assert set(y.tolist()) == {0.0}


def test_hulls_hold_all_agents_of_their_controller_and_hardly_more_than_the_true_hull() -> None:
    chance = np.random.default_rng(1)
    x, y = chance.uniform(0, 100, 4), chance.uniform(0, 100, 4)
    forest = forest_of(SQUADS.place)
    xs, ys = hulls(x, y, forest, np.arange(3), np.zeros(3))
    corners = np.stack((xs[0], ys[0]), axis=1)
    ours, true = ConvexHull(corners), ConvexHull(np.stack((x, y), axis=1))
    inside = ours.equations[:, :2] @ np.stack((x, y)) + ours.equations[:, 2:]
    assert (inside <= 1e-6).all()
    assert true.volume <= ours.volume + 1e-6
    assert ours.volume < true.volume + 0.05 * true.area**2


def test_a_hull_keeps_its_distance() -> None:
    x = y = np.zeros(4)
    xs, ys = hulls(x, y, forest_of(SQUADS.place), np.array([1]), np.array([10.0]))
    away = np.hypot(xs, ys)
    assert (away >= 10.0).all()
    assert (away <= 10.1).all()


def test_a_selected_controller_means_the_agents_under_it() -> None:
    group = SQUADS.place.hierarchy.controllers()[1].id
    assert agents_of(SQUADS, (group,)).tolist() == [0, 1]
    assert agents_of(SQUADS, (SQUADS.place.agents[3], "gone")).tolist() == [3]
