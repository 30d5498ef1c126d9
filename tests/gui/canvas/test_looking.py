"""What the menu View shows in the world besides the agents."""

import numpy as np
import pytest
from PySide6.QtCore import QRect
from PySide6.QtGui import QImage

from app.engine.commands import Step
from tests.gui.canvas.pilot import Pilot


def world_of(pilot: Pilot) -> QImage:
    """The picture without the legend, which counts a little later."""
    picture = pilot.picture()
    return picture.copy(QRect(0, 0, picture.width(), picture.height() - 60))


@pytest.mark.parametrize("shown", ["ranges", "trails", "all_trails", "grid"])
def test_what_is_switched_on_in_the_menu_is_seen_and_switched_off_it_is_not(pilot: Pilot, shown: str) -> None:
    pilot.click(pilot.at(pilot.alone()))
    pilot.send(Step(60))
    name = f"canvas.{shown}"
    action = pilot.studio.actions[name]
    if action.isChecked():
        pilot.choose(name)
    without = world_of(pilot)
    pilot.choose(name)
    assert action.isChecked()
    assert world_of(pilot) != without
    pilot.choose(name)
    assert not action.isChecked()
    assert world_of(pilot) == without


def test_trails_begin_where_the_agents_were_when_the_window_came(pilot: Pilot) -> None:
    agents = np.arange(pilot.frame.scene.agents)
    before = pilot.frame.scene.x[agents].astype(np.float32)
    pilot.send(Step(60))
    xs, _ = pilot.frame.trails.of(agents)
    assert xs[0].tolist() == before.tolist()
    assert xs[-1].tolist() != before.tolist()
