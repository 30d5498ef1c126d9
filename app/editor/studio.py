"""What every part of the window is given: the document, the engine, the selection, the actions, the looks."""

from collections.abc import Callable, Mapping
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from ..core.automaton import START
from ..core.errors import UnderstudyError
from ..core.project import Arm, Project, Value
from ..engine.commands import RedoMove, UseArm
from ..engine.scenarios import open_scenario
from ..engine.snapshots import Mode, Refused, Snapshot
from ..sim.physics import KINEMATIC
from ..sim.scenario import Scenario
from .actions import Actions
from .behavior_colors import BehaviorColors, Places
from .bridge import Bridge, MoveMark, PickMark
from .document import Document
from .message import Kind, Message
from .relearning import Relearning
from .selection import BehaviorKey, Selection
from .settings import Settings
from .soon import Soon
from .teach.teaching import Teaching
from .theme import Theme
from .watching import Watching

#: Of so many selected nodes, the last ones, snapshots show what they are about to decide.
MOST_WATCHED = 8


class Studio(QObject):
    """The parts of the window that have no looks of their own, and what concerns several of them.

    Attributes:
        document: The project that is open, with its history.
        bridge: The engine.
        selection: What the user looks at.
        watching: Which nodes snapshots explain.
        colors: Who has which color.
        actions: All that can be done.
        teaching: Who is taught what, and testing it.
        relearning: Learns in the background from what has changed.

    Signals:
        opened: Another project is open.
        said: A `Message` for the user.
        changed: Something that decides what is possible has changed; told once for all of it.
        show_panel: Bring a panel to the front, by its id.
        closing: The window closes: whoever works in the background has to end it.
        world_wanted: Bring the window with the world to the front.
        window_wanted: Open a project in a window of its own: the project, its scenario, an arm, a seed, a tick.
    """

    opened = Signal()
    closing = Signal()
    world_wanted = Signal()
    window_wanted = Signal(object, object, str, int, int)
    said = Signal(object)
    changed = Signal()
    show_panel = Signal(str)
    moment_wanted = Signal(object, str, str)

    def __init__(self, theme: Theme, settings: Settings) -> None:
        super().__init__()
        self.theme = theme
        self.settings = settings
        self.is_open = False
        self.document = Document(_NOTHING, open_scenario(_NOTHING))
        self.bridge = Bridge(self.document)
        self.selection = Selection()
        self.watching = Watching(self.bridge)
        self.colors = BehaviorColors()
        self.actions = Actions(self)
        self.relearning = Relearning(self.document, settings)
        self.teaching = Teaching(self)
        self._opening = object()  # stands for the project that is open
        self._undo_ticket = 0
        self._otherwise = self._undo_alone
        self._steps_waiting: list[Callable[[], None]] = []
        self._arm, self._state_wanted = "", False
        self._settings: Mapping[str, Value] = {}
        self._soon = Soon(self, self._refresh)
        self._connect()

    def _connect(self) -> None:
        document, bridge, selection = self.document, self.bridge, self.selection
        document.project_changed.connect(self._project_changed)
        document.refused.connect(self.warn)
        bridge.told.connect(self.warn)
        self.relearning.told.connect(self.warn)
        bridge.event_came.connect(self._event_came)
        bridge.snapshot_changed.connect(self._snapshot_changed)
        self.theme.changed.connect(self.actions.dress)
        self.settings.changed.connect(self._setting_changed)
        document.history_changed.connect(self._history_changed)
        selection.nodes_changed.connect(self._watch)
        selection.nodes_changed.connect(self._want_state)
        selection.examples_changed.connect(self._show_state_of_examples)
        self.teaching.changed.connect(self._watch)
        for signal in (
            bridge.mode_changed,
            bridge.place_changed,
            selection.nodes_changed,
            selection.behavior_changed,
            selection.state_changed,
            selection.examples_changed,
        ):
            signal.connect(self.touch)

    # ------------------------------------------------------------------------------------ opening, closing

    def open(
        self,
        project: Project,
        scenario: Scenario,
        folder: Path | None,
        *,
        saved: bool = True,
        arm: str = "",
        colors: Places | None = None,
    ) -> None:
        """Open a project, and begin its first arm, or *arm*, paused.

        Args:
            colors: Of its behaviors, as they were when it was saved.
        """
        self._leave()
        self.document.begin(project, scenario, folder, saved=saved)
        self.colors.begin(project, colors or {})
        self.selection.select_nodes(())
        self.selection.select_behavior(_first_behavior(project))
        self.is_open = True
        self._arm, self._settings = arm or (project.arms[0].name if project.arms else ""), {}
        self.opened.emit()
        if self._arm:
            self._begin()
        self.touch()

    def close_project(self) -> None:
        """Close the project; the window shows the welcome page."""
        self._leave()
        self.is_open = False
        self.document.begin(_NOTHING, open_scenario(_NOTHING), None)
        self.selection.select_nodes(())
        self.selection.select_behavior(None)
        self.opened.emit()
        self.touch()

    def _leave(self) -> None:
        """End the session; what was asked of it, or told of its project, counts for no other one."""
        self.bridge.close()
        self._opening = object()
        self._undo_ticket = 0
        self._steps_waiting.clear()

    def shut_down(self) -> None:
        """End all that runs in the background."""
        self.closing.emit()
        self._soon.forget()
        self.bridge.shut_down()
        self.relearning.close()
        self.settings.sync()

    # ------------------------------------------------------------------------------------------- the arm

    @property
    def snapshot(self) -> Snapshot | None:
        """The newest snapshot of the session, if there is one."""
        return self.bridge.snapshot

    @property
    def mode(self) -> Mode | None:
        """What the session is for at the moment; None where there is none."""
        return None if self.snapshot is None else self.snapshot.mode

    @property
    def arm(self) -> Arm | None:
        """The arm whose world is shown."""
        name = self.snapshot.arm if self.snapshot is not None else self._arm
        return next((arm for arm in self.document.project.arms if arm.name == name), None)

    def use_arm(self, name: str, settings: Mapping[str, Value] | None = None) -> None:
        """Begin again with another arm.

        Args:
            settings: As in `UseArm`; by default none but the physics that the user has taken.
        """
        taken = {key: value for key, value in self._settings.items() if key == "physics"}
        self._arm, self._settings = name, taken if settings is None else settings
        if self.bridge.is_open:
            self.bridge.send(UseArm(name, self._settings))
        else:
            self._begin()
        self.touch()

    @property
    def physics(self) -> str:
        """What moves things in the world that is shown."""
        return str(self._settings.get("physics", KINEMATIC))

    @property
    def departures(self) -> Mapping[str, Value]:
        """How the world that is shown departs from its arm, physics aside: that of a run may."""
        settings = self._settings.items()
        return {name.removeprefix("world."): value for name, value in settings if name != "physics"}

    def use_physics(self, physics: str) -> None:
        """Begin the arm again in a world of other physics."""
        if self._arm:
            self.use_arm(self._arm, {**self._settings, "physics": physics})

    def _begin(self) -> None:
        self.bridge.open(self._arm, settings=self._settings)
        self._watch()
        self.watching.begin()

    def _watch(self) -> None:
        """Have snapshots show what the selected nodes, and the one that is taught, are about to decide."""
        nodes, pupils = self.selection.nodes[-MOST_WATCHED:], self.teaching.nodes[:MOST_WATCHED]
        self.watching.want("studio", (*nodes, *pupils, self.teaching.node))

    def _want_state(self) -> None:
        """Where no state was chosen, show how the one decides that a node is in which has just been selected."""
        self._state_wanted = bool(self.selection.node) and self.selection.state == START
        if self._state_wanted and self.snapshot is not None:
            self._show_state(self.snapshot)  # while time stands still, no other may come

    def _show_state(self, snapshot: Snapshot) -> None:
        watched, behavior = snapshot.watched.get(self.selection.node), self.selection.behavior
        if watched is None or behavior is None:
            return
        self._state_wanted = False
        for level in watched.levels:
            if (level.type, level.automaton) == (
                behavior.type,
                behavior.id,
            ) and self.selection.state == START:
                self.selection.show_state(level.state)

    def _show_state_of_examples(self) -> None:
        """Show how the state decides that the first of the examples is of, unless the one shown is another one's."""
        selection, chosen = self.selection, set(self.selection.examples)
        shown = selection.behavior
        automaton = None if shown is None else self.document.automaton(shown.type, shown.id)
        if shown is None or automaton is None or not chosen:
            return
        examples = self.document.project.examples_of(shown.type, shown.id)
        of = dict.fromkeys(example.source for example in examples if example.id in chosen)
        there = [state for state in of if automaton.has_state(state)]
        if there and selection.state not in there:
            selection.show_state(there[0])

    # ------------------------------------------------------------------------------------- undo and redo

    def undo(self) -> None:
        """Take back the last step: an edit, a pick, or something that was moved in the world.

        A pick is taken back by the session, which puts the node back as well; what is undone meanwhile waits for that.
        """
        if self._undo_ticket:
            self._steps_waiting.append(self.undo)
            return
        last = self.document.history.last
        if last is None:
            return
        if isinstance(last.mark, PickMark) and self.bridge.can_take_back(last.mark):
            self.teaching.turn_back(last.mark.recorded)
            self._undo_ticket, self._otherwise = self.bridge.take_back(), self._undo_alone
            return
        edit = self.document.undo()
        if isinstance(edit.mark, MoveMark):
            self.bridge.undo_move(edit.mark)

    @property
    def can_redo(self) -> bool:
        """Whether there is something to do again, or will be once the session has taken back what it was asked to."""
        return self.document.history.can_redo or self._undo_ticket != 0

    def redo(self) -> None:
        """Do again what was undone last; as with `undo`, the session lets the node of a pick do what it did then."""
        if self._undo_ticket:
            self._steps_waiting.append(self.redo)
            return
        following = self.document.history.next
        if following is None:
            return
        if isinstance(following.mark, PickMark) and self.bridge.can_do_again(following.mark):
            self.teaching.turn_back(following.mark.recorded)
            self._undo_ticket, self._otherwise = self.bridge.do_again(), self._redo_alone
            return
        edit = self.document.redo()
        if isinstance(edit.mark, MoveMark):
            self.bridge.send(RedoMove(edit.mark.moved.number))

    def _event_came(self, event: object) -> None:
        if isinstance(event, Refused) and self._undo_ticket and event.ticket == self._undo_ticket:
            self._undo_ticket = 0
            self._otherwise()
            self._step_on()

    def _undo_alone(self) -> None:
        """The lesson of the picks is over: their examples can be undone all the same."""
        self.bridge.forget_picks()
        self.undo()

    def _redo_alone(self) -> None:
        """The node cannot go on with the pick: its examples come back all the same."""
        self.bridge.forget_taken_back()
        self.redo()

    def _snapshot_changed(self, snapshot: Snapshot) -> None:
        if self._state_wanted:
            self._show_state(snapshot)
        if self._undo_ticket and snapshot.acknowledged >= self._undo_ticket:
            self._undo_ticket = 0
            self._step_on()

    def _step_on(self) -> None:
        """Go on with what was asked for while the session was busy with a pick."""
        while self._steps_waiting and not self._undo_ticket:
            self._steps_waiting.pop(0)()

    # --------------------------------------------------------------------------------------------- telling

    def say(self, text: str, answers: tuple[tuple[str, Callable[[], object]], ...] = ()) -> None:
        """Tell the user something that is good to know, and what can be done about it."""
        self.said.emit(Message(text, Kind.INFO, answers, self._while_it_is_open()))

    def warn(self, text: str, answers: tuple[tuple[str, Callable[[], object]], ...] = ()) -> None:
        """Tell the user that something was not possible, and what can be done about it."""
        self.said.emit(Message(text, Kind.WARNING, answers, self._while_it_is_open()))

    def _while_it_is_open(self) -> Callable[[], bool]:
        """Whether the project that is open now, if one is, still is: what is said of it does not hold for another one."""
        opening, of_none = self._opening, not self.is_open
        return lambda: of_none or self._opening is opening

    def attempt(self, act: Callable[[], object]) -> bool:
        """Do something that may fail for reasons the user can mend, which are then told."""
        try:
            act()
        except UnderstudyError as error:
            self.warn(str(error))
            return False
        return True

    def touch(self) -> None:
        """Say that something has changed which decides what is possible."""
        self._soon.ask()

    def _history_changed(self) -> None:
        """A key pressed in the very next moment must find undo ready; the rest has time."""
        self.actions.refresh_some(HISTORY_ACTIONS)
        self.touch()

    def _refresh(self) -> None:
        self.actions.refresh()
        self.changed.emit()

    def _project_changed(self, _before: Project, after: Project) -> None:
        self.colors.use(after)
        shown = self.selection.behavior
        automaton = None if shown is None else self.document.automaton(shown.type, shown.id)
        if automaton is None:
            self.selection.select_behavior(_first_behavior(after))
        elif not automaton.has_state(self.selection.state):
            self.selection.show_state(START)
        if self.bridge.is_open or not after.arms:
            return
        self._arm = after.arms[0].name
        self._begin()

    def _setting_changed(self, name: str) -> None:
        if name == "theme":
            self.theme.use(self.settings.theme)
        elif name == "keys":
            self.actions.take_keys()


#: What the history alone makes possible.
HISTORY_ACTIONS = ("edit.undo", "edit.redo", "file.save")
_NOTHING = Project("", "foraging")


def _first_behavior(project: Project) -> BehaviorKey | None:
    """A behavior to begin with: what the first arm runs, or else the first there is."""
    top = project.arms[0].top if project.arms else ""
    keys = [
        (BehaviorKey(node_type.name, automaton.id), automaton.name == top)
        for node_type in project.types
        for automaton in project.library(node_type.name).automata.values()
    ]
    return max(keys, key=lambda key: key[1])[0] if keys else None
