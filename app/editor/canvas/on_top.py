"""What lies on the canvas: who is taught, the camera's buttons, the legend, and what there is to say; and where it lies."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .hovering import Covers
from .legend import Legend
from .overlays import SIDE, Badge, Banner, CameraButtons, Notice
from .words import badge_words

if TYPE_CHECKING:
    from collections.abc import Callable

    from ...engine.snapshots import Snapshot
    from ..studio import Studio
    from .coloring import Coloring
    from .surface import Surface

#: Pixels between what lies on the canvas and its edge, and between two banners.
EDGE, APART = 10, 8
#: Pixels that the badge takes, above the banners, which are not made narrower than the other.
ABOVE, NARROWEST = 40, 160


class OnTop:
    """What lies on a canvas.

    Attributes:
        badge: Who is taught or tested.
        camera_buttons: Beside the right edge.
        legend: What colors tell, and how many there are of each.
        failure: Says why the world stands still.
        moment: Says that what is shown is a stored moment.
        prompt: Says what is to be chosen.
        notice: Says what else there is to know of the world.
    """

    def __init__(self, studio: Studio, canvas: Surface) -> None:
        self._studio = studio
        self._canvas = canvas
        self._hidden = ""  # a notice that the user has hidden
        self.badge = Badge(studio, canvas)
        self.camera_buttons = CameraButtons(studio, canvas)
        self.legend = Legend(studio, canvas.looking, canvas)
        self.failure = Banner(studio, canvas, "failure")
        self.moment = Banner(studio, canvas, "moment")
        self.prompt = Banner(studio, canvas, "prompt")
        self.notice = Banner(studio, canvas, "notice")
        self._covers = Covers(canvas)
        self._covers.entered.connect(canvas.forget_mouse)
        for part in (self.badge, self.camera_buttons, self.legend, *self._banners):
            part.installEventFilter(self._covers)

    @property
    def _banners(self) -> tuple[Banner, ...]:
        """From above to below."""
        return self.failure, self.prompt, self.moment, self.notice

    @property
    def below(self) -> float:
        """Pixels at the lower edge that the legend takes."""
        return 2.0 * EDGE + self.legend.sizeHint().height()

    @property
    def beside(self) -> float:
        """Pixels at the right edge that the buttons take."""
        return SIDE + 2.0 * EDGE

    def place(self) -> None:
        """Put everything where it belongs."""
        width, height = self._canvas.width(), self._canvas.height()
        self.badge.move(EDGE, EDGE)
        self.camera_buttons.move(width - SIDE - EDGE, EDGE)
        self.legend.move(EDGE, height - self.legend.height() - EDGE)
        top = EDGE + ABOVE
        for banner in self._banners:
            if banner.notice is not None:
                banner.fit_into(max(width - 2 * (SIDE + 2 * EDGE), NARROWEST))
                banner.move((width - banner.width()) // 2, top)
                top += banner.height() + APART

    def dress(self) -> None:
        """Everything has the colors of the theme from now on."""
        self.legend.dress()
        for banner in self._banners:
            banner.dress()
        self.refresh_badge()

    def refresh_badge(self) -> None:
        """Somebody else may be taught or tested."""
        self.badge.refresh()
        self.place()

    def count(self, coloring: Coloring | None) -> None:
        """Say in the legend how many there are of each color; None if there is no world."""
        if coloring is not None:
            self.legend.tell(coloring, self._canvas.width() - 2 * EDGE)
            self.place()
        self.legend.setVisible(coloring is not None)

    # --------------------------------------------------------------------------------------------- saying

    def say(
        self, banner: Banner, words: str, button: str = "", act: Callable[[], object] | None = None
    ) -> None:
        """Say something in a banner, with a button for what can be done; without words there is nothing to say."""
        banner.show_notice(Notice(words, button=button, act=act) if words else None)
        self.place()

    def tell(self, snapshot: Snapshot) -> None:
        """Say what a snapshot has to tell of the world, and of who is in training by now."""
        if badge_words(self._studio) != self.badge.words:
            self.refresh_badge()
        failed = snapshot.failure
        told = Notice(f"The world stands still: {failed}", True, "Reset", self._reset) if failed else None
        self.failure.show_notice(told)
        words = snapshot.notice if snapshot.notice != self._hidden else ""
        self.say(self.notice, words[:1].upper() + words[1:], "Hide", self._hide)

    def _reset(self) -> None:
        self._studio.actions["run.reset"].trigger()

    def _hide(self) -> None:
        snapshot = self._studio.snapshot
        self._hidden = "" if snapshot is None else snapshot.notice
        if snapshot is not None:
            self.tell(snapshot)
