"""The actions of the Experiment menu."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..actions import ActionRow, When, when_open

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget

    from ..studio import Studio
    from .window import ExperimentsWindow


class Experiments:
    """Makes the window of experiments when it is asked for first.

    Attributes:
        window: Where it is; None before that.
    """

    def __init__(self, studio: Studio, parent: QWidget) -> None:
        self._studio = studio
        self._parent = parent
        self.window: ExperimentsWindow | None = None

    def show(self) -> ExperimentsWindow:
        """Bring the window to the front."""
        if self.window is None:
            from .window import ExperimentsWindow  # noqa: PLC0415 - pyqtgraph and scipy take their time to import

            self.window = ExperimentsWindow(self._studio, self._parent)
        self.window.show()
        self.window.raise_()
        self.window.activateWindow()
        return self.window

    def what_ends(self) -> str:
        """What ends with the work on the open project, in words; nothing if no experiment is under way."""
        return "" if self.window is None else self.window.running.what_ends

    def rows(self) -> tuple[ActionRow, ...]:
        """The actions."""
        return (
            ActionRow(
                "experiment.show",
                "Experiments…",
                "Experiment",
                lambda _: self.show(),
                keys="Ctrl+Shift+X",
                tip="Many runs of several arms: curves with confidence, tests and verdicts",
                icon="flask-outline",
                enabled=when_open,
            ),
            ActionRow(
                "experiment.new",
                "New experiment…",
                "Experiment",
                lambda _: self.show().listing.build(),
                tip="Build an experiment: arms, what is varied, how often, what is claimed",
                icon="flask-plus-outline",
                enabled=When(
                    lambda studio: studio.is_open and studio.document.folder is not None,
                    "open a project that is saved, or save this one: experiments are kept in its folder",
                ),
            ),
        )
