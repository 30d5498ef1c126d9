"""Checks of arms and demonstrations: forests, tops, worlds, and what a demonstrator's hand did."""

from collections.abc import Iterator, Mapping, Sequence

from ..automaton import Automaton
from ..errors import BindingError, HierarchyError, LibraryError, ParameterError, SessionError
from ..hierarchy import Hierarchy, problems
from ..library import Types
from ..project import Arm, Demonstration, LevelTable, Project
from .problem import PROJECT_FILE, Problem, allowed, demonstration_file, place, twice

#: What a hand can do, see `app.core.project.Pick`.
ACTS = ("pick", "answer", "should not have left", "undo", "redo", "test", "learn", "teach", "move")
#: What the nodes that are not taught can do meanwhile.
OTHERS = ("idle", "run")


def arm_problems(project: Project, types: Types) -> Iterator[Problem]:
    """What is wrong with the arms."""
    for index, name in twice(arm.name for arm in project.arms):
        message = f"the arm {name!r} stands twice"
        yield Problem(PROJECT_FILE, place("arms", index, "name"), message, raises=HierarchyError)
    for index, arm in enumerate(project.arms):
        if not arm.name.strip():
            yield Problem(
                PROJECT_FILE, place("arms", index, "name"), "the arm has no name", raises=HierarchyError
            )
        if arm.world and arm.world not in project.worlds:
            message = f"arm {arm.name!r} names the world {arm.world!r}; {allowed(arm.world, project.worlds)}"
            yield Problem(PROJECT_FILE, place("arms", index, "world"), message, raises=ParameterError)
        yield from _forest_problems(index, arm, types)


def _forest_problems(index: int, arm: Arm, types: Types) -> Iterator[Problem]:
    try:
        forest = _outline(arm)
    except HierarchyError as error:
        where = place("arms", index, "hierarchy")
        yield Problem(PROJECT_FILE, where, f"arm {arm.name!r}: {error}", raises=HierarchyError)
        return
    written = isinstance(arm.hierarchy, Hierarchy)
    for node_id, message in problems(forest, types.types):
        where = place("arms", index, "hierarchy") + (f", node {node_id!r}" if written and node_id else "")
        who = f"arm {arm.name!r}, node {node_id!r}" if node_id else f"arm {arm.name!r}"
        yield Problem(PROJECT_FILE, where, f"{who}: {message}", raises=HierarchyError)
    yield from top_problems(index, arm, types)


def top_problems(index: int, arm: Arm, types: Types) -> Iterator[Problem]:
    """What keeps the roots of an arm from starting with its behavior.

    Raises:
        HierarchyError: The arm has no forest.
    """
    for root_type in dict.fromkeys(root.type for root in _outline(arm).roots):
        if root_type in types.types:
            yield from _top_problems(index, arm, root_type, types)


def _outline(arm: Arm) -> Hierarchy:
    """A forest with the same types above each other as the arm's: of a table, one node a level is enough."""
    if isinstance(arm.hierarchy, Hierarchy):
        return arm.hierarchy
    sizes = tuple(min(size, 1) for size in arm.hierarchy.sizes)
    return Arm("", LevelTable(sizes, arm.hierarchy.types), "").forest()


def _top_problems(index: int, arm: Arm, root_type: str, types: Types) -> Iterator[Problem]:
    repertoire = types.repertoire(root_type)
    where = place("arms", index, "top")
    if arm.top not in repertoire:
        message = f"arm {arm.name!r} starts with {arm.top!r}, which {root_type!r} cannot do; {allowed(arm.top, repertoire)}"
        yield Problem(PROJECT_FILE, where, message, raises=LibraryError)
    elif slots := repertoire[arm.top].parameters:
        free = [name for name, behavior in repertoire.items() if not behavior.parameters]
        message = (
            f"{slots[0]!r} of {arm.top} is open in arm {arm.name!r}: nobody above {root_type!r} binds it. "
            f"Let the arm start with a behavior without parameters; {allowed(arm.top, free)}"
        )
        yield Problem(PROJECT_FILE, where, message, raises=BindingError)


# -------------------------------------------------------------------------------------- demonstrations


def demonstration_problems(project: Project, types: Types) -> Iterator[Problem]:
    """What keeps demonstrations from being played."""
    for _, name in twice(d.id for d in project.demonstrations):
        yield _error(name, "id", f"the demonstration {name!r} stands twice")
    nodes: dict[str, Mapping[str, str]] = {}
    for demonstration in project.demonstrations:
        yield from _demonstration_problems(project, types, demonstration, nodes)


def _demonstration_problems(
    project: Project, types: Types, demonstration: Demonstration, nodes: dict[str, Mapping[str, str]]
) -> Iterator[Problem]:
    """Args: nodes: The node ids of each arm met so far, with their types."""
    name = demonstration.id
    arms = [arm for arm in project.arms if arm.name == demonstration.arm]
    automaton = None
    if demonstration.type not in types.types:
        message = f"there is no node type {demonstration.type!r}; {allowed(demonstration.type, types.types)}"
        yield _error(name, "type", message)
    else:
        automata = types.library(demonstration.type).automata
        automaton = automata.get(demonstration.automaton)
        if automaton is None:
            message = f"{demonstration.type!r} has no behavior with the id {demonstration.automaton!r}"
            yield _error(name, "automaton", f"{message}; {allowed(demonstration.automaton, automata)}")
    if not arms:
        message = f"there is no arm {demonstration.arm!r}; {allowed(demonstration.arm, [a.name for a in project.arms])}"
        yield _error(name, "arm", message)
    elif demonstration.arm not in nodes:
        nodes[demonstration.arm] = _nodes(arms[0])
    if demonstration.others not in OTHERS:
        message = f"the others can {' or '.join(map(repr, OTHERS))}, but not {demonstration.others!r}"
        yield _error(name, "others", message)
    if automaton is not None:
        yield from _argument_problems(types, demonstration, automaton)
    yield from _tick_problems(demonstration)
    yield from _pick_problems(demonstration, automaton, nodes.get(demonstration.arm))


def _nodes(arm: Arm) -> Mapping[str, str]:
    try:
        return {node.id: node.type for node in arm.forest().walk()}
    except HierarchyError:
        return {}


def _argument_problems(types: Types, demonstration: Demonstration, automaton: Automaton) -> Iterator[Problem]:
    targets = types.vocabulary(demonstration.type).targets
    for slot in automaton.parameters:
        if slot not in demonstration.arguments:
            message = f"{slot!r} of {automaton.name} is open while it is taught: name a target; {allowed('', targets)}"
            yield _error(demonstration.id, "arguments", message)
    for slot, target in demonstration.arguments.items():
        where = place("arguments", slot)
        if slot not in automaton.parameters:
            message = (
                f"{automaton.name} has no parameter {slot!r}; {allowed(slot, automaton.parameters, 'it has')}"
            )
            yield _error(demonstration.id, where, message)
        elif target not in targets:
            message = f"{demonstration.type!r} cannot bind the target {target!r}; {allowed(target, targets)}"
            yield _error(demonstration.id, where, message)


def _tick_problems(demonstration: Demonstration) -> Iterator[Problem]:
    before = 0
    for index, pick in enumerate(demonstration.picks):
        where = place("picks", index, "tick")
        if not 0 <= pick.tick <= demonstration.ticks:
            message = f"the demonstration goes on for {demonstration.ticks:,} ticks, but a pick is at tick {pick.tick:,}"
            yield _error(demonstration.id, where, message)
        elif pick.tick < before:
            message = (
                f"the picks must be in the order of their ticks, but {pick.tick:,} comes after {before:,}"
            )
            yield _error(demonstration.id, where, message)
        before = max(before, pick.tick)


def _pick_problems(
    demonstration: Demonstration, automaton: Automaton | None, nodes: Mapping[str, str] | None
) -> Iterator[Problem]:
    states_now = automaton.states if automaton is not None else ()
    there = {state.id for state in (*states_now, *demonstration.removed)}
    for index, pick in enumerate(demonstration.picks):
        if pick.act not in ACTS:
            message = f"{pick.act!r} is nothing that a hand can do; {allowed(pick.act, ACTS)}"
            yield _error(demonstration.id, place("picks", index, "act"), message)
        if pick.act == "move" and None in (pick.entity, pick.x, pick.y):
            message = "a move needs the entity that is moved, and x and y, where it is put"
            yield _error(demonstration.id, place("picks", index, "act"), message)
        picks = pick.act in ("pick", "answer")
        if nodes is not None and (pick.node or picks):
            for message in _node_problems(demonstration, pick.node, nodes):
                yield _error(demonstration.id, place("picks", index, "node"), message)
        if picks and automaton is not None and pick.state not in there:
            states = [state.id for state in automaton.states]
            message = f"{automaton.name} has no state {pick.state!r}; {allowed(pick.state, states)}"
            yield _error(demonstration.id, place("picks", index, "state"), message)


def _node_problems(demonstration: Demonstration, node: str, nodes: Mapping[str, str]) -> Iterator[str]:
    if node not in nodes:
        there = _some([other for other, type_name in nodes.items() if type_name == demonstration.type])
        yield f"arm {demonstration.arm!r} has no node {node!r}; nodes of type {demonstration.type!r} are: {there}"
    elif nodes[node] != demonstration.type:
        yield f"{node!r} is of type {nodes[node]!r}, but {demonstration.type!r} is taught"


def _some(names: Sequence[str], most: int = 8) -> str:
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(map(repr, names[:most])) + more if names else "none"


def _error(demonstration_id: str, where: str, message: str) -> Problem:
    return Problem(demonstration_file(demonstration_id), where, message, raises=SessionError)
