"""Going on with a changed project: what it still knows of the arm, and what the nodes lost."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from ..core.errors import EditError, SessionError, UnderstudyError
from ..core.machine import Machine
from ..core.machine_state import MachineState, resume_node
from ..core.project import Arm, Project
from .plan import some
from .snapshots import Edit, edited


class EditLog:
    """The session's own edits, as long as its caller may not have applied them yet."""

    def __init__(self) -> None:
        self._edits: list[Edit] = []
        self._before = 0  # how many came before these

    def add(self, edit: Edit) -> None:
        """One more edit was made."""
        self._edits.append(edit)

    def on_top(self, project: Project, applied: int | None) -> tuple[Project, list[str]]:
        """*project* with the edits that it lacks; also returns why some of them are not possible any more.

        Args:
            applied: How many edits it contains, of all that were ever made; None if all.

        Raises:
            SessionError: That cannot be.
        """
        made = self._before + len(self._edits)
        applied = made if applied is None else applied
        if not self._before <= applied <= made:
            raise SessionError(
                f"{applied} edits are said to be applied; allowed: {self._before} to {made}, as many as were made"
            )
        self._edits, self._before = self._edits[applied - self._before :], applied
        lost = []
        for edit in self._edits:
            try:
                project = edited(project, edit)
            except EditError as error:
                lost.append(str(error))
        return project, lost


def arm_now(arm: Arm, old: Project, new: Project) -> Arm:
    """The arm that a world began with, by the name and with the top behavior that it has in the project now."""
    found = _called(arm.name, new)
    before = _called(arm.name, old)
    if found is None and before is not None:  # renamed, perhaps
        found = next((a for a in new.arms if replace(a, name=before.name) == before), None)
    return arm if found is None else replace(arm, name=found.name, top=found.top)


def _called(name: str, project: Project) -> Arm | None:
    return next((arm for arm in project.arms if arm.name == name), None)


class LeftOff:
    """What nodes did whose behavior was edited away, until they are told to do something else: it may come back by undo."""

    def __init__(self) -> None:
        self._states: dict[str, MachineState] = {}
        self._instead: dict[str, str] = {}

    def forget(self) -> None:
        """All nodes have been told what to do."""
        self._states.clear()
        self._instead.clear()

    def note(self, before: MachineState, machine: Machine) -> None:
        """Remember what nodes did before an edit that do nothing since.

        Args:
            before: As `rebase` returns it.
        """
        for node_id in before["nodes"]:
            if machine.actors[node_id].run is None:
                self._states.setdefault(node_id, before)

    def resume(self, machine: Machine) -> set[str]:
        """Let those go on whose behavior is there again, if they have done nothing else of their own meanwhile.

        Returns:
            Who goes on.
        """
        resumed: set[str] = set()
        for node_id, state in tuple(self._states.items()):
            run = machine.actors[node_id].run
            waits = run is None or run.behavior.name == self._instead.get(node_id)
            if waits and resume_node(machine, node_id, state):
                resumed.add(node_id)
            if not waits or node_id in resumed:
                del self._states[node_id]
                self._instead.pop(node_id, None)
        return resumed

    def begin_instead(self, machine: Machine, arm: Arm) -> Mapping[str, str]:
        """Let roots that do nothing any more start what the arm runs now, if it can be started.

        Returns:
            Who began with what.
        """
        begun: dict[str, str] = {}
        for root in arm.forest().roots:
            if arm.top and root.id in self._states and machine.actors[root.id].run is None:
                try:
                    machine.direct(root.id, arm.top)
                except UnderstudyError:  # the arm cannot run, which is told where it is made
                    continue
                begun[root.id] = arm.top
        self._instead |= begun
        return begun


def losses(nodes: Iterable[str], machine: Machine, begun: Mapping[str, str]) -> Sequence[str]:
    """What nodes have lost that cannot go on as before, because that was edited away.

    Args:
        begun: What nodes that did nothing after it have begun with, by their ids.
    """
    lost = [node_id for node_id in nodes if node_id not in begun]
    idle = [node_id for node_id in lost if machine.actors[node_id].run is None]
    back = [node_id for node_id in lost if machine.actors[node_id].run is not None]
    told = []
    if begun:
        what = " and ".join(dict.fromkeys(begun.values()))
        told.append(f"what these nodes did is gone, so they begin with {what}: {some(list(begun))}")
    if idle:
        told.append(f"what these nodes did is gone, so they idle until it is back: {some(idle)}")
    if back:
        told.append(f"the state is gone, or holds something else, that these nodes were in: {some(back)}")
    return told
