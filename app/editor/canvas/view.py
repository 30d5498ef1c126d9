"""The live picture of the world: a widget that paints the newest snapshot, or a stored moment, and what lies on it."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QHideEvent, QPainter, QPaintEvent, QResizeEvent, QShowEvent

from ...core.amounts import counted
from ...core.errors import UnderstudyError
from ...core.examples import Moment
from ...engine.snapshots import Snapshot
from ..soon import Later
from .camera import Margins
from .coloring import ATTACHED, Coloring, color_agents
from .frame import Frame
from .group_painting import controller_colors
from .hand import Choice
from .ink import Ink
from .on_top import EDGE, OnTop
from .painting import paint
from .picture import Picture
from .rows import camera_rows, color_rows, shown_rows
from .scene import Scene, live, remembered
from .surface import Surface
from .trails import Trails

if TYPE_CHECKING:
    from ..studio import Studio

#: Milliseconds between two looks at the counts of the legend.
COUNTING = 200


class WorldCanvas(Surface):
    """The live picture of the world.

    Attributes:
        scene: What is painted; None while there is no world.

    Signals:
        entity_chosen: Of those asked for by `choose_entity`.
        choosing_ended: Nothing was chosen.
    """

    entity_chosen = Signal(int)
    choosing_ended = Signal()

    def __init__(self, studio: Studio) -> None:
        super().__init__(studio)
        studio.actions.add((*camera_rows(self.looking), *shown_rows(self.looking), *color_rows(self.looking)))
        self.scene: Scene | None = None
        self._moment_node = ""
        self._trails, self._ink = Trails(), Ink()
        self._picture = Picture(self, self._paint)
        self._is_stale = False
        self._soon = Later(self, self._paint_anew)  # never in one turn with what else there is to do
        self._coloring: tuple[Scene, object, Coloring] | None = None
        self.on_top = OnTop(studio, self)
        self._counting = Later(self, self._count, COUNTING)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setMinimumSize(240, 180)
        self.setAccessibleName("World")
        self.setProperty("framed", True)
        self.setToolTipDuration(0)
        self._connect()

    def _connect(self) -> None:
        studio = self._studio
        studio.opened.connect(self._opened)
        studio.bridge.snapshot_changed.connect(self._snapshot_changed)
        studio.bridge.place_changed.connect(self._place_changed)
        studio.bridge.mode_changed.connect(self._mode_changed)
        studio.selection.nodes_changed.connect(self._selected)
        studio.colors.changed.connect(self._recolor)
        studio.theme.changed.connect(self._dress)
        studio.moment_wanted.connect(self._moment_wanted)
        studio.teaching.changed.connect(self.on_top.refresh_badge)
        studio.teaching.choose_requested.connect(self._choose_target)
        studio.teaching.choose_ended.connect(self.hand.stop_asking)
        studio.teaching.follow_requested.connect(self._turn_to)
        self.entity_chosen.connect(studio.teaching.choosing.entity_chosen)
        self.choosing_ended.connect(studio.teaching.choosing.cancel)
        self.looking.changed.connect(self.touch)
        self.looking.told.connect(self._told)
        self.hand.changed.connect(self._hand_changed)
        self.hand.chosen.connect(self.entity_chosen)
        self.hand.gave_up.connect(self.choosing_ended)

    # --------------------------------------------------------------------------------------- what is shown

    def frame(self) -> Frame | None:
        """What is to be painted now; None if there is no world."""
        scene = self.scene
        if scene is None:
            return None
        snapshot, coloring, hand = self._studio.snapshot, self._colored(scene), self.hand
        is_taught = self.is_live and snapshot is not None
        lesson = snapshot.lesson if is_taught and snapshot is not None else None
        return Frame(
            scene,
            self.looking.camera,
            self.looking.extent,
            coloring,
            self._studio.theme.palette,
            self._trails if self.is_live else Trails(),
            self.looking.options,
            self._studio.selection.nodes if self.is_live else (self._moment_node,),
            snapshot.taught if is_taught and snapshot is not None else frozenset(),
            self._lit(coloring),
            self.hovering.entity,
            hand.dragged if self.is_live else None,
            hand.band,
            hand.marked(),
            self.devicePixelRatioF(),
            lesson.plan.nodes if lesson is not None else (),
            self._studio.teaching.node if lesson is not None else "",
        )

    def _colored(self, scene: Scene) -> Coloring:
        by = self.looking.color_by
        if self._coloring is None or self._coloring[0] is not scene or self._coloring[1] is not by:
            self._coloring = scene, by, color_agents(scene, by, self._studio.colors)
        return self._coloring[2]

    def _lit(self, coloring: Coloring) -> frozenset[int] | None:
        lit = self.looking.lit
        if not lit:
            return None
        found = {place for place, entry in enumerate(coloring.entries) if entry.words in lit}
        return frozenset(found | ({-1} if ATTACHED in lit else set()))

    def _snapshot_changed(self, snapshot: Snapshot) -> None:
        self.hand.settle(snapshot)
        self.on_top.tell(snapshot)
        if not self.is_live:
            return
        scene = live(snapshot)
        self._trails.add(scene)
        if self.isVisible():
            self._show(scene)
            self.hover()

    def _show(self, scene: Scene) -> None:
        if self.scene is None:
            self.looking.begin(scene)
        self.scene = scene
        self._counting.ask()
        self.looking.see(scene, self._studio.selection.nodes)
        self.touch()

    def _place_changed(self, _place: object) -> None:
        snapshot = self._studio.snapshot
        self.hovering.nothing()
        self.hand.let_go()
        self.on_top.legend.begin()
        self.hand.is_live = True
        self.on_top.say(self.on_top.moment, "")
        if snapshot is not None:
            self.scene = live(snapshot)
            self.looking.begin(self.scene)
        self._told()

    def _mode_changed(self) -> None:
        self.back_to_now()
        self.on_top.refresh_badge()

    def _opened(self) -> None:
        self.scene, self.hand.is_live = None, True
        self.hovering.nothing()
        self._trails = Trails()
        self.hand.let_go()
        self.on_top.refresh_badge()
        self._told()

    def _selected(self) -> None:
        if not self._studio.selection.nodes and self.looking.follows:
            self.looking.follow(on=False)
        self.on_top.refresh_badge()
        if self.scene is not None and self.is_live:
            self.looking.see(self.scene, self._studio.selection.nodes)
        self.touch()

    def _recolor(self) -> None:
        self._coloring = None
        self.on_top.legend.begin()
        self._count()
        self.touch()

    def _turn_to(self, node: str) -> None:
        """It is the turn of another node: it has to be in view, which it is as long as all of the world is."""
        selection = self._studio.selection
        if selection.node != node:
            selection.select_nodes((*(other for other in selection.nodes if other != node), node))
        if not self.looking.fits:
            self.looking.follow(on=True)

    # ------------------------------------------------------------------------------------- stored moments

    def show_moment(self, moment: Moment, node: str, caption: str = "A stored moment") -> None:
        """Show the world as it was when an example of *node* was recorded, until `back_to_now`.

        Raises:
            UnderstudyError: The moment cannot be shown.
        """
        document = self._studio.document
        scene = remembered(moment, document.project, document.scenario)
        self.hand.is_live, self._moment_node = False, node
        self.hand.let_go()
        self.hovering.nothing()
        self.scene = scene
        self.looking.look_aside(scene)
        words = f"{caption}: {scene.place.called(node)}, tick {scene.tick:,}"
        self.on_top.say(self.on_top.moment, words, "Back to now (Esc)", self.back_to_now)
        self._changed_scene()

    def back_to_now(self) -> None:
        """Show the world as it is now."""
        if self.is_live:
            return
        self.hand.is_live = True
        self.on_top.say(self.on_top.moment, "")
        self.looking.look_back()
        self.hovering.nothing()
        snapshot = self._studio.snapshot
        self.scene = None if snapshot is None else live(snapshot)
        self._changed_scene()

    def _changed_scene(self) -> None:
        self.on_top.legend.begin()
        self._count()
        self.heed_escape()
        self.hover()
        self.touch()

    def _moment_wanted(self, moment: Moment | None, node: str, caption: str) -> None:
        if moment is None:
            self.back_to_now()
            return
        try:
            self.show_moment(moment, node, caption)
        except (UnderstudyError, LookupError, ValueError) as error:
            self._studio.warn(f"this moment cannot be shown: {error}")

    # ------------------------------------------------------------------------------------------- choosing

    def choose_entity(
        self,
        prompt: str,
        accept: Callable[[int], bool],
        targets: Callable[[], frozenset[int]] = frozenset,
    ) -> None:
        """Let the user click an entity, which `entity_chosen` tells; Escape tells `choosing_ended`.

        Args:
            prompt: What to click, in words.
            accept: Whether an entity can be chosen.
            targets: Those that are marked as such.
        """
        self.back_to_now()
        self.hand.ask(Choice(prompt, accept, targets))

    def _choose_target(self, prompt: str) -> None:
        def targets() -> frozenset[int]:
            meanings = self._studio.teaching.choosing.meanings()
            return frozenset(entity for entity in meanings.values() if entity >= 0)

        self.choose_entity(prompt, lambda _: True, targets)  # the teach panel says in words why one is none

    # --------------------------------------------------------------------------------------------- painting

    def touch(self) -> None:
        """Something that is shown has changed."""
        if self.isVisible():
            self._soon.ask()

    @property
    def is_pending(self) -> bool:
        """Whether something that has changed is not shown yet."""
        return self._soon.is_due

    def _paint_anew(self) -> None:
        self._is_stale = self._is_unseen
        if not self._is_stale:
            self._picture.paint_anew()
            self.update()

    @property
    def _is_unseen(self) -> bool:
        """Whether nobody can see it, though Qt may still want it painted."""
        return self.window().isMinimized()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Show what was painted last."""
        if self._is_unseen:
            self._is_stale = True
            return
        if self._is_stale:
            self.touch()
        self._picture.show(self._studio.theme.color("canvas"))

    def _paint(self, painter: QPainter) -> None:
        """Paint the newest frame."""
        frame = self.frame()
        if frame is None:
            self._paint_empty(painter)
        else:
            colors = controller_colors(frame, self.looking.color_by, self._studio.colors)
            paint(painter, frame, self._ink, colors)

    def _paint_empty(self, painter: QPainter) -> None:
        colors = self._studio.theme.palette
        painter.fillRect(self.rect(), QColor(colors.canvas))
        words = "The world begins…" if self._studio.bridge.is_open else "There is no world: add an arm first"
        at = QPointF(self.width() / 2, self.height() / 2)
        self._ink.write(painter, at, words, QColor(colors.dim), 13, centered=True)

    def _count(self) -> None:
        self.on_top.count(None if self.scene is None else self._colored(self.scene))

    def _told(self) -> None:
        if self._coloring is not None and self._coloring[1] is not self.looking.color_by:
            self.on_top.legend.begin()
        self._counting.hurry()
        self._studio.touch()
        self.touch()

    def _dress(self) -> None:
        self.on_top.dress()
        self.card.dress()
        self._count()
        self.hover()
        self.touch()

    # --------------------------------------------------------------------------------------------- events

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The camera keeps the middle, or the whole world."""
        margins = Margins(left=EDGE, top=EDGE, right=self.on_top.beside, bottom=self.on_top.below)
        self.looking.resize(self.width(), self.height(), margins)
        self._counting.hurry()
        self.on_top.place()
        self.touch()
        super().resizeEvent(event)

    def showEvent(self, event: QShowEvent) -> None:
        """Show what has happened meanwhile."""
        super().showEvent(event)
        snapshot = self._studio.snapshot
        if snapshot is not None and self.is_live:
            scene = live(snapshot)
            self._trails.add(scene)
            self._show(scene)
        self._count()

    def hideEvent(self, event: QHideEvent) -> None:
        """Nothing is held or looked at any more."""
        super().hideEvent(event)
        self._soon.forget()
        self._picture.forget()
        self.hand.let_go()
        self.hovering.nothing()

    def _hand_changed(self) -> None:
        words = self._asks_for()
        self.on_top.say(self.on_top.prompt, words[:1].upper() + words[1:], "Cancel (Esc)", self.hand.cancel)
        self.heed_escape()
        self._set_cursor()
        self.touch()

    def _asks_for(self) -> str:
        """What the hand waits for; empty if for nothing."""
        choice, carried, snapshot = self.hand.choice, self.hand.carried, self._studio.snapshot
        if choice is not None:
            return choice.prompt
        if not carried or snapshot is None:
            return ""
        if len(carried) > 1:
            return f"Ctrl and arrow keys move {counted(len(carried), 'agent')}, Enter puts them down"
        return f"Ctrl and arrow keys move {snapshot.place.entity_called(carried[0])}, Enter puts it down"

    def sizeHint(self) -> QSize:
        """As in the middle of the window."""
        return QSize(720, 520)
