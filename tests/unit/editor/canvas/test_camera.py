"""Where the canvas looks."""

import numpy as np
import pytest

from app.editor.canvas.camera import Camera, Extent, Margins
from app.editor.canvas.ground import grid_step

WORLD = Extent(0.0, 0.0, 200.0, 100.0)


def fitted() -> Camera:
    return Camera().resized(800, 600).fitted(WORLD)


def test_a_fitted_world_lies_within_the_margins() -> None:
    camera = Camera().resized(800, 600).fitted(WORLD, Margins(10, 20, 30, 40))
    left, top = camera.to_view(0.0, 100.0)
    right, bottom = camera.to_view(200.0, 0.0)
    assert left >= 10 - 1e-9
    assert top >= 20 - 1e-9
    assert right <= 770 + 1e-9
    assert bottom <= 560 + 1e-9
    assert right - left == pytest.approx(760)


def test_up_in_the_world_is_up_in_the_view() -> None:
    camera = fitted()
    assert camera.to_view(0.0, 90.0)[1] < camera.to_view(0.0, 10.0)[1]


def test_pixels_and_places_are_each_others_inverse() -> None:
    camera = fitted()
    assert camera.to_world(*camera.to_view(12.5, 33.0)) == pytest.approx((12.5, 33.0))


def test_what_is_under_the_mouse_stays_there_when_it_is_zoomed() -> None:
    camera = fitted()
    before = camera.to_world(123.0, 456.0)
    closer = camera.zoomed(3.0, 123.0, 456.0, camera.scale)
    assert closer.scale == pytest.approx(3.0 * camera.scale)
    assert closer.to_world(123.0, 456.0) == pytest.approx(before)


def test_nobody_gets_lost_by_zooming() -> None:
    camera = fitted()
    far, near = camera, camera
    for _ in range(100):
        far, near = far.zoomed(0.5, 0, 0, camera.scale), near.zoomed(2.0, 0, 0, camera.scale)
    assert 0 < far.scale < camera.scale < near.scale < 1e4 * camera.scale


def test_moving_by_pixels_moves_the_world_along() -> None:
    camera = fitted()
    x, y = camera.to_view(10.0, 10.0)
    assert camera.moved(5.0, -7.0).to_view(10.0, 10.0) == pytest.approx((x + 5.0, y - 7.0))


def test_arrays_are_shown_at_once() -> None:
    x, y = fitted().to_view(np.array([0.0, 200.0]), np.array([0.0, 100.0]))
    assert x.shape == y.shape == (2,)


@pytest.mark.parametrize("scale", [0.01, 0.3, 2.8, 17.0, 900.0])
def test_the_lines_of_the_grid_are_a_round_number_of_units_apart_and_never_crowded(scale: float) -> None:
    step = grid_step(scale)
    assert step * scale >= 33.9
    assert step * scale <= 34.0 * 2.5 + 1e-6
    assert round(step / 10.0 ** np.floor(np.log10(step)), 6) in (1.0, 2.0, 5.0)
