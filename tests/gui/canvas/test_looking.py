"""What the menu View shows in the world besides the agents."""

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
