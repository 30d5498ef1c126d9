"""A dialog with the pages that say all about a behavior."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QWidget

from ..forms.late_pages import LatePages
from ..room import resize_within
from .editing import Editing
from .features_page import FeaturesPage
from .general_page import GeneralPage
from .learner_page import LearnerPage
from .states_page import StatesPage

#: Names of the pages.
GENERAL, STATES, FEATURES, LEARNER = "General", "States", "Features", "Learner"


class PagesDialog(QDialog):
    """Name and parameters, states, features, and learner of a behavior.

    Attributes:
        tabs: The pages, made when they are turned to.
    """

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.tabs = LatePages()
        resize_within(self, 620, 460)
        self.finished.connect(self._stop_validating)

    @property
    def general(self) -> GeneralPage:
        """For whom, name, parameters, note."""
        return self.tabs.page(GENERAL, GeneralPage)

    @property
    def states(self) -> StatesPage:
        """What the states hold."""
        return self.tabs.page(STATES, StatesPage)

    @property
    def features(self) -> FeaturesPage:
        """What it looks at."""
        return self.tabs.page(FEATURES, FeaturesPage)

    @property
    def learner(self) -> LearnerPage:
        """How it learns."""
        return self.tabs.page(LEARNER, LearnerPage)

    def turn_to(self, page: str) -> None:
        """Show a page by its name."""
        self.tabs.turn_to(page)

    def _offer(self, editing: Editing, types: tuple[str, ...] = ()) -> None:
        """Begin with the pages for what is edited; *types* can be chosen from, where there is a choice."""
        self._stop_validating()
        self.tabs.offer(
            {
                GENERAL: partial(GeneralPage, editing, types),
                STATES: partial(StatesPage, editing),
                FEATURES: partial(FeaturesPage, editing),
                LEARNER: partial(LearnerPage, editing),
            }
        )

    def _stop_validating(self) -> None:
        for page in self.tabs.made(LearnerPage):
            page.validation.close()
