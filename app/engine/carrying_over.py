"""Going on with a changed project: what it still knows of the arm, and what the nodes lost."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from ..core.errors import EditError, SessionError
from ..core.project import Arm, Project
from .plan import some
from .snapshots import Edit, NodeView, edited


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


def losses(before: Mapping[str, NodeView], after: Mapping[str, NodeView]) -> Sequence[str]:
    """Who does not do any more what it did, because that was edited away."""
    idle = [n for n, now in after.items() if before[n].behavior and not now.behavior]
    back = [n for n, now in after.items() if now.behavior and now.path != before[n].path]
    told = []
    if idle:
        told.append(f"what these nodes did is gone, so they idle: {some(idle)}")
    if back:
        told.append(f"the state is gone, or holds something else, that these nodes were in: {some(back)}")
    return told
