"""Which nodes can be taught a behavior, where, and which of its states they are in."""

from collections.abc import Callable, Mapping
from functools import lru_cache, partial
from itertools import islice

from ...core.hierarchy import Hierarchy, Node
from ...core.project import Arm, Project
from ...core.remembered import Remembered
from ...engine.snapshots import Snapshot
from ..selection import BehaviorKey

#: So many other arms are offered where the one that is shown has nobody to teach.
MOST_ARMS = 3


def nodes_of(forest: Hierarchy, type_name: str) -> tuple[str, ...]:
    """The nodes of a type, parents first."""
    return tuple(members(forest, type_name))


def members(forest: Hierarchy, type_name: str) -> Mapping[str, Node]:
    """The nodes of a type by id, parents first."""
    return _by_type(_Same(forest)).get(type_name, {})


class _Same:
    """A forest that is equal to itself only: comparing thousands of nodes would cost more than walking them."""

    def __init__(self, forest: Hierarchy) -> None:
        self.forest = forest

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and other.forest is self.forest

    def __hash__(self) -> int:
        return id(self.forest)


@lru_cache(maxsize=8)  # of the last forests only: selecting and picking ask for the same one again and again
def _by_type(same: _Same) -> Mapping[str, Mapping[str, Node]]:
    """By type, the nodes of a forest by id, parents first."""
    found: dict[str, dict[str, Node]] = {}
    for node in same.forest.walk():
        found.setdefault(node.type, {})[node.id] = node
    return found


class Pupils:
    """Finds who is to be taught, once for each selection: ten thousand may be selected."""

    def __init__(self) -> None:
        self._found: Remembered[str, tuple[str, ...]] = Remembered()

    def of(self, forest: Hierarchy, type_name: str, selected: tuple[str, ...]) -> tuple[str, ...]:
        """The selected nodes of a type, or else the first there is."""

        def found() -> tuple[str, ...]:
            of_type = members(forest, type_name)
            return tuple(node for node in selected if node in of_type) or tuple(islice(of_type, 1))

        return self._found.of(type_name, (forest, selected), found)


def arms_with(project: Project, type_name: str) -> tuple[str, ...]:
    """The names of the arms that have a node of a type."""
    return tuple(arm.name for arm in project.arms if nodes_of(arm.forest(), type_name))


def nobody_to_teach(
    project: Project, shown: Arm | None, type_name: str, use_arm: Callable[[str], None]
) -> tuple[str, tuple[tuple[str, Callable[[], None]], ...]]:
    """Where the arm that is shown has no node of a type: words that say so, and answers that use another arm."""
    arms = arms_with(project, type_name)
    where = f"the arm {shown.name!r}" if shown else "this project"
    what = "choose an arm that has one" if arms else "make an arm that has one"
    answers = tuple((f"Use {name}", partial(use_arm, name)) for name in arms[:MOST_ARMS])
    return f"there is no node of type {type_name!r} in {where}; {what}", answers


def state_of(snapshot: Snapshot, node: str, key: BehaviorKey) -> str:
    """The state of an automaton that a node is in, at any depth; empty if it does not run it."""
    doing = snapshot.doing
    row = doing.rows.get(node)
    if row is None:
        return ""
    for number in doing.state[row].tolist():
        if number >= 0:
            ref = doing.states[number]
            if (ref.type, ref.automaton) == (key.type, key.id):
                return ref.state
    return ""
