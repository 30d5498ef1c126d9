"""How the user looks at the world: from where, at what, in which colors. What is a matter of taste survives the program."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from .camera import Camera, Extent, Margins
from .coloring import ColorBy
from .frame import Options, agents_of
from .scene import Scene

if TYPE_CHECKING:
    from ..settings import Settings

#: One step of zooming by key or button.
STEP = 1.35


class Looking(QObject):
    """Where the camera is and what is shown.

    Attributes:
        camera: Where it is.
        extent: Of the world, as far as it has been seen.
        fits: The camera keeps all of the world in view, until the user moves it.
        follows: The camera keeps the selected node in the middle, until the user moves it.
        options, color_by: What is shown, and what colors tell.
        lit: Words of the legend's entries that are lit up; none lights all.

    Signals:
        changed: There is something else to be seen.
        told: What is followed, fitted, shown or colored by is something else.
    """

    changed = Signal()
    told = Signal()

    def __init__(self, settings: Settings) -> None:
        super().__init__()
        self._settings = settings
        self.camera = Camera()
        self.extent = Extent(0.0, 0.0, 1.0, 1.0)
        self.margins = Margins()
        self.fits, self.follows = True, False
        self.options = Options(
            **{
                field.name: settings.flag(f"canvas_{field.name}", default=bool(field.default))
                for field in fields(Options)
            }
        )
        self.color_by = next((by for by in ColorBy if settings.flag(f"canvas_color_{by}")), ColorBy.CURRENT)
        self.lit: frozenset[str] = frozenset()
        self._world: tuple[object, ...] = ()
        self._before: tuple[Camera, Extent, bool, bool] | None = None

    # ------------------------------------------------------------------------------------------- the camera

    def begin(self, scene: Scene) -> None:
        """Look at another world, all of it; at one that is only begun again, from where the user was."""
        place = scene.place
        same = (place.scenario, place.arm, place.look.width, place.look.height)
        self.lit, self._before = frozenset(), None
        self.extent = scene.extent()
        if same != self._world:
            self._world = same
            self.fits, self.follows = True, False
        if self.fits:
            self._fit()
        self.told.emit()

    def look_aside(self, scene: Scene) -> None:
        """Look at another world for a while; `look_back` comes back to just here."""
        self._before = self._before or (self.camera, self.extent, self.fits, self.follows)
        extent = scene.extent()
        self.follows = False
        if extent != self.extent:
            self.extent, self.fits = extent, True
            self._fit()
        self.told.emit()

    def look_back(self) -> None:
        """Look at what was seen before `look_aside`."""
        if self._before is not None:
            camera, self.extent, self.fits, self.follows = self._before
            self.camera = camera.resized(self.camera.width, self.camera.height)
            self._before = None
            if self.fits:
                self._fit()
            self.told.emit()

    def see(self, scene: Scene, nodes: tuple[str, ...]) -> None:
        """The world has changed: follow what is followed, and grow with a world without walls."""
        self.extent = self.extent.united(scene.extent())
        if self.follows:
            agents = agents_of(scene, nodes[-1:])
            if agents.size:
                at = float(scene.x[agents].mean()), float(scene.y[agents].mean())
                self.camera = self.camera.centered(*at)
        elif self.fits:
            self._fit()

    def resize(self, width: float, height: float, margins: Margins) -> None:
        """The view has another size."""
        self.margins = margins
        self.camera = self.camera.resized(width, height)
        if self.fits:
            self._fit()
        self.changed.emit()

    def pan(self, dx: float, dy: float) -> None:
        """Shift the world by pixels."""
        self._by_hand()
        self.camera = self.camera.moved(dx, dy)
        self.changed.emit()

    def zoom(self, factor: float, x: float | None = None, y: float | None = None) -> None:
        """Larger around a pixel, or around the middle; what is followed stays in the middle."""
        self.fits = False
        middle = self.camera.width / 2, self.camera.height / 2
        at = middle if self.follows or x is None or y is None else (x, y)
        fitting = self.camera.fitted(self.extent, self.margins).scale
        self.camera = self.camera.zoomed(factor, *at, fitting)
        self.told.emit()
        self.changed.emit()

    def fit(self) -> None:
        """All of the world in view, from now on."""
        self.fits, self.follows = True, False
        self._fit()
        self.told.emit()
        self.changed.emit()

    def follow(self, *, on: bool) -> None:
        """Keep the selected node in the middle, or no longer."""
        if on and self.fits:
            self.zoom(2.0)
        self.follows, self.fits = on, False
        self.told.emit()
        self.changed.emit()

    def _by_hand(self) -> None:
        if self.fits or self.follows:
            self.fits = self.follows = False
            self.told.emit()

    def _fit(self) -> None:
        self.camera = self.camera.fitted(self.extent, self.margins)

    # ------------------------------------------------------------------------------------------- what is shown

    def show(self, name: str, *, on: bool) -> None:
        """Turn one of the `Options` on or off, by its name."""
        self.options = replace(self.options, **{name: on})
        self._settings.set_flag(f"canvas_{name}", on=on)
        self.told.emit()
        self.changed.emit()

    def color(self, by: ColorBy) -> None:
        """Let colors tell something else."""
        for other in ColorBy:
            self._settings.set_flag(f"canvas_color_{other}", on=other is by)
        self.color_by, self.lit = by, frozenset()
        self.told.emit()
        self.changed.emit()

    def light(self, words: str, *, on: bool) -> None:
        """Light up an entry of the legend, or no longer."""
        self.lit = self.lit | {words} if on else self.lit - {words}
        self.told.emit()
        self.changed.emit()
