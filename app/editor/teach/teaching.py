"""Who is taught what: from the user's choices to commands of the session."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ...core.automaton import Automaton, Content
from ...core.edits import Recorded
from ...engine.commands import Others, Pick, RunArm, ShouldNotHaveLeft, Step, Teach, Test
from ...engine.snapshots import Interrupted, LessonView, Mode, Picked, Snapshot, TakenBack
from ..selection import BehaviorKey
from .arguments import Arguments
from .asking import Asking
from .choosing import Choosing
from .keeping import Keeping, free_name
from .pupils import Pupils, members, nobody_to_teach, state_of

if TYPE_CHECKING:
    from ..studio import Studio


class Teaching(QObject):
    """Teaches the behavior that is shown to the nodes that are selected.

    Attributes:
        others: What the nodes that are not taught do meanwhile.
        demonstration: What examples are filed under; empty for a name made from the behavior's.
        asking: Asks the user during a test.
        choosing: The targets that are to be chosen, from a menu or in the world.
        keeping: Keeps lessons as demonstrations.
        picked: The state that was picked last and that no tick has carried out yet; empty otherwise.
        last: Examples that the last pick recorded, the first of which says it; None before the first.

    Signals:
        changed: Something of the above is another, or the node whose turn it is.
        choose_requested: A target is to be chosen in the world: what to tell the user.
        choose_ended: No more.
        follow_requested: The camera is to follow a node.
    """

    changed = Signal()
    choose_requested = Signal(str)
    choose_ended = Signal()
    follow_requested = Signal(str)

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self.others = Others.IDLE
        self.demonstration = ""
        self.picked = ""
        self.last: Picked | None = None
        self._arguments = Arguments()
        self._pupils = Pupils()
        self._turn = ""
        self._then_teach = self._then_test = False  # once what a lesson lacks is there: an arm, or a target
        self.asking = Asking(studio, self)
        self.choosing = Choosing(studio, self)
        self.keeping = Keeping(studio, self)
        self.keeping.changed.connect(self.changed)
        studio.opened.connect(self._opened)
        studio.selection.nodes_changed.connect(self._selected)
        studio.bridge.mode_changed.connect(self._mode_changed)
        studio.bridge.place_changed.connect(self._place_changed)
        studio.bridge.event_came.connect(self._event_came)
        studio.bridge.snapshot_changed.connect(self._snapshot_changed)

    # ------------------------------------------------------------------------------------------ looking

    @property
    def is_teaching(self) -> bool:
        """Whether a lesson is going on, its test included."""
        return self._studio.mode in (Mode.TEACHING, Mode.LEARNING, Mode.TESTING)

    @property
    def lesson(self) -> LessonView | None:
        """The lesson that is going on."""
        snapshot = self._studio.snapshot
        return None if snapshot is None else snapshot.lesson

    @property
    def key(self) -> BehaviorKey | None:
        """What is taught, or would be."""
        lesson = self.lesson
        if lesson is None:
            return self._studio.selection.behavior
        return BehaviorKey(lesson.plan.type, lesson.plan.automaton)

    @property
    def automaton(self) -> Automaton | None:
        """The automaton that is taught, or would be."""
        key = self.key
        return None if key is None else self._studio.document.automaton(key.type, key.id)

    @property
    def nodes(self) -> tuple[str, ...]:
        """The nodes that are taught in turn, or would be."""
        lesson = self.lesson
        if lesson is not None:
            return lesson.plan.nodes
        key = self._studio.selection.behavior
        return () if key is None else self._nodes_for(key)

    @property
    def node(self) -> str:
        """The node that a pick is for: whose turn it is; in a test also another that is selected."""
        lesson = self.lesson
        if lesson is None:
            return (*self.nodes, "")[0]
        return self._turn if self.can_pick_for(self._turn) else lesson.plan.nodes[0]

    @property
    def state(self) -> str:
        """The state that the node is in, in the automaton that is taught; empty if it does not run it."""
        snapshot, key = self._studio.snapshot, self.key
        return "" if snapshot is None or key is None else state_of(snapshot, self.node, key)

    @property
    def arguments(self) -> Mapping[str, str]:
        """Ground targets for the automaton's parameters while it is taught, those that have been chosen."""
        key, automaton = self.key, self.automaton
        if key is None or automaton is None:
            return {}
        return self._arguments.of(key, automaton, self.lesson)

    @property
    def open(self) -> tuple[str, ...]:
        """The automaton's parameters for which no target was chosen yet."""
        automaton = self.automaton
        return tuple(p for p in automaton.parameters if p not in self.arguments) if automaton else ()

    @property
    def filed_under(self) -> str:
        """What the examples of the lesson are filed under, or would be."""
        lesson = self.lesson
        if lesson is not None:
            return lesson.plan.demonstration
        key, automaton = self.key, self.automaton
        if self.demonstration or key is None or automaton is None:
            return self.demonstration
        return free_name(self._studio.document.project, key.type, automaton)

    # ----------------------------------------------------------------------------- beginning and ending

    def teach(self) -> None:
        """Take the selected nodes of the behavior's type into training mode for the behavior that is shown.

        Where that cannot be, the user is told why and what can be done; an open parameter is asked for in the panel.
        """
        self._then_test = False
        self._teach()

    def _make_one(self) -> None:
        self._studio.actions["behavior.new"].trigger()

    def _teach(self) -> None:
        key = self._studio.selection.behavior
        if key is None or self._studio.document.automaton(key.type, key.id) is None:
            make_one = "New automaton…", self._make_one
            self._studio.warn(
                "choose a behavior to teach in the library, or make a new one there", (make_one,)
            )
            return
        nodes = self._nodes_for(key)
        if not nodes:
            self._studio.warn(
                *nobody_to_teach(self._studio.document.project, self._studio.arm, key.type, self._use_arm)
            )
            return
        if self._is_going_on(key, nodes):
            return
        self._studio.selection.select_nodes((*nodes[1:], nodes[0]))  # panels show the last, whose turn it is
        self._studio.show_panel.emit("teach")
        self._then_teach = bool(self._missing(key))
        if self._then_teach:
            self.choosing.ask_for(self._missing(key)[0])
        else:
            self._begin(key, nodes)
        self.changed.emit()

    def test(self) -> None:
        """Learn, then let all nodes of the type run it; a lesson begins with it where none is going on."""
        self.choosing.cancel()
        self._then_test = not self.is_teaching
        if self._then_test:
            self._teach()
        else:
            self._studio.bridge.send(Test())

    def stop(self) -> None:
        """End the lesson: the arm runs. While something is being chosen, only that ends."""
        self._then_teach = False
        if self.choosing.is_busy:
            self.choosing.cancel()
        else:
            self._studio.bridge.send(RunArm())

    def set_argument(self, parameter: str, target: str) -> None:
        """From now on *parameter* means *target*; a lesson goes on with it, from Start."""
        key, lesson = self.key, self.lesson
        if key is None:
            return
        self._arguments.choose(key, parameter, target)
        if lesson is not None and lesson.plan.arguments.get(parameter) != target:
            self._again(lesson, {**lesson.plan.arguments, parameter: target}, lesson.plan.others)
        elif self._then_teach:
            self._teach()
        self.changed.emit()

    def set_others(self, others: Others) -> None:
        """Let the nodes that are not taught do something else; a lesson goes on with it, from Start."""
        self.others = others
        lesson = self.lesson
        if lesson is not None and lesson.plan.others is not others:
            self._again(lesson, lesson.plan.arguments, others)
        self.changed.emit()

    def set_demonstration(self, name: str) -> None:
        """File the examples of the next lesson under *name*."""
        self.demonstration = name.strip()
        self.changed.emit()

    # ---------------------------------------------------------------------------------------- the lesson

    def pick(self, choice: str | Content) -> None:
        """What the node is to do from the next tick on: a state by its id, or what a new state is to hold."""
        lesson = self.lesson
        if lesson is None:
            self._studio.warn("nobody is taught now; choose a behavior and nodes, and press Teach first")
            return
        self._studio.bridge.send(Pick(self.node, choice))
        snapshot = self._studio.snapshot
        if self.steps_on and snapshot is not None and snapshot.speed == 0.0 and snapshot.asked is None:
            self._studio.bridge.send(Step())

    def can_pick_for(self, node: str) -> bool:
        """Whether a pick can be for *node*: one that is taught, or in a test any other that runs the behavior."""
        lesson = self.lesson
        return lesson is not None and (
            node in lesson.plan.nodes or (lesson.testing and self._may_pick(node, lesson))
        )

    def pick_for(self, node: str, choice: str | Content) -> None:
        """Pick for a node, whose turn it is from now on."""
        self._studio.selection.select_nodes(
            (*(other for other in self._studio.selection.nodes if other != node), node)
        )
        self.pick(choice)

    @property
    def steps_on(self) -> bool:
        """Whether a pick while time stands still passes one tick."""
        return self._studio.settings.flag("step_after_pick")

    def set_steps_on(self, *, on: bool) -> None:
        """Let a pick while time stands still pass one tick, or not."""
        self._studio.settings.set_flag("step_after_pick", on=on)
        self._studio.touch()

    @property
    def can_mend(self) -> bool:
        """Whether there may be a state that the node should not have left."""
        lesson, snapshot = self.lesson, self._studio.snapshot
        return lesson is not None and lesson.testing and snapshot is not None and self.state != ""

    def should_not_have_left(self) -> None:
        """The state that the node left by itself last, it should have stayed in."""
        self._studio.bridge.send(ShouldNotHaveLeft(self.node))

    def next_node(self) -> None:
        """It is the next node's turn."""
        nodes = self.nodes
        if len(nodes) < 2:
            return
        at = nodes.index(self.node) if self.node in nodes else -1
        self._turn_to(nodes[(at + 1) % len(nodes)])

    def turn_back(self, recorded: Recorded) -> None:
        """A pick is taken back: the next one is for the same node, whoever's turn it was meanwhile."""
        lesson, node = self.lesson, recorded.examples[0].node if recorded.examples else ""
        if lesson is not None and node in lesson.plan.nodes and node != self.node:
            self._turn_to(node)

    def _turn_to(self, turn: str) -> None:
        """It is a node's turn: panels show it, and the camera finds it."""
        rest = [node for node in self._studio.selection.nodes if node != turn]
        self._turn = turn
        self._studio.selection.select_nodes((*rest, turn))
        self.changed.emit()
        self.follow_requested.emit(turn)

    # ------------------------------------------------------------------------------------------- inside

    def _begin(self, key: BehaviorKey, nodes: tuple[str, ...]) -> None:
        document, lesson = self._studio.document, self.lesson
        automaton = document.automaton(key.type, key.id)
        if automaton is None:
            return
        self._then_teach = False
        self._turn = nodes[0]
        self.last, self.picked = None, ""
        arguments = self._arguments.of(key, automaton)
        filed = self.demonstration or free_name(document.project, key.type, automaton)
        plan = Teach(key.type, key.id, nodes, arguments, self.others, filed)
        if lesson is not None and not self.demonstration:
            going_on = replace(plan, demonstration=lesson.plan.demonstration)
            if replace(going_on, nodes=lesson.plan.nodes) == lesson.plan:
                plan = going_on  # after a test the lesson goes on, as one demonstration
        self._studio.bridge.send(plan)
        if self._then_test:
            self._studio.bridge.send(Test())

    def _again(self, lesson: LessonView, arguments: Mapping[str, str], others: Others) -> None:
        self._studio.bridge.send(replace(lesson.plan, arguments=arguments, others=others))

    def _is_going_on(self, key: BehaviorKey, nodes: tuple[str, ...]) -> bool:
        lesson = self.lesson
        same = lesson is not None and self.key == key and set(lesson.plan.nodes) == set(nodes)
        return lesson is not None and same and not lesson.testing

    def _missing(self, key: BehaviorKey) -> tuple[str, ...]:
        """Parameters of an automaton for which no target that exists was chosen."""
        document = self._studio.document
        automaton, targets = document.automaton(key.type, key.id), document.vocabulary(key.type).targets
        return () if automaton is None else self._arguments.missing(key, automaton, targets)

    def _nodes_for(self, key: BehaviorKey) -> tuple[str, ...]:
        """The selected nodes of the behavior's type, or else the first there is."""
        snapshot = self._studio.snapshot
        if snapshot is None:
            return ()
        return self._pupils.of(snapshot.place.hierarchy, key.type, self._studio.selection.nodes)

    def _use_arm(self, name: str) -> None:
        self._then_teach = True
        self._studio.use_arm(name)

    def _may_pick(self, node: str, lesson: LessonView) -> bool:
        snapshot = self._studio.snapshot
        return snapshot is not None and node in members(snapshot.place.hierarchy, lesson.plan.type)

    # -------------------------------------------------------------------------------------------- hearing

    def _opened(self) -> None:
        self._arguments.forget()
        self._turn, self.picked, self.last = "", "", None
        self._then_teach = self._then_test = False
        self.demonstration = ""
        self.choosing.cancel()
        self.changed.emit()

    def _selected(self) -> None:
        lesson, selected = self.lesson, self._studio.selection.node
        if lesson is None or selected in lesson.plan.nodes or (lesson.testing and selected):
            self._turn = selected
        self.changed.emit()

    def _mode_changed(self) -> None:
        if not self.is_teaching:
            self.picked = ""
            if self.choosing.adding is not None:
                self.choosing.cancel()  # there is no lesson any more in which it could be picked
        selected = self._studio.selection.node
        if self._studio.mode is Mode.TESTING and self.can_pick_for(selected):
            self._turn = selected  # also who was only looked at while others were taught
        self.changed.emit()

    def _place_changed(self) -> None:
        self.picked = ""
        if self._then_teach:
            self._teach()
        self.changed.emit()

    def _event_came(self, event: object) -> None:
        match event:
            case Picked(recorded):
                self.picked, self.last = recorded.goal, event
            case TakenBack():
                self.picked, self.last = "", None
            case Interrupted():
                self.choosing.cancel()
            case _:
                return
        self.changed.emit()

    def _snapshot_changed(self, snapshot: Snapshot) -> None:
        lesson = snapshot.lesson
        if self.picked and (lesson is None or self.node not in lesson.waiting):
            self.picked = ""
            self.changed.emit()
