"""Starting behaviors on nodes, all or nothing."""

from ..core.errors import UnderstudyError
from ..core.machine import Machine
from ..core.machine_state import freeze, thaw
from ..core.project import Arm


def direct_roots(machine: Machine, arm: Arm) -> None:
    """Let every root start the arm's top behavior, or idle if it names none.

    Raises:
        SessionError, BindingError: A root cannot do that; all nodes go on with what they did then.
    """
    before = freeze(machine)
    try:
        for root in arm.forest().roots:
            if arm.top:
                machine.direct(root.id, arm.top)
            else:
                machine.actors[root.id].lower()
                machine.actors[root.id].run = None
    except UnderstudyError:
        thaw(machine, before)
        raise
