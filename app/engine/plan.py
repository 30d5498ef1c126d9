"""What a lesson is about: who is taught what, and whether that is possible here."""

from collections.abc import Iterable

from ..core.actor import Run
from ..core.automaton import Automaton
from ..core.errors import SessionError
from ..core.hierarchy import Hierarchy, Node
from ..core.machine import Machine
from ..core.project import Project
from .commands import Others, Teach

#: How many names a message lists before it says how many more there are.
MOST_NAMES = 8


def check_plan(machine: Machine, plan: Teach) -> None:
    """Refuse a plan that cannot be taught here.

    Raises:
        SessionError: A node does not exist or is of another type, or a parameter of the automaton is open.
        LibraryError: There is no such automaton.
    """
    if not plan.nodes:
        raise SessionError("choose at least one agent or controller to teach")
    for node_id in plan.nodes:
        actor = machine.actors.get(node_id)
        if actor is None:
            there = some(list(machine.actors))
            raise SessionError(f"there is no node {node_id!r} in this world; there are: {there}")
        if actor.node.type != plan.type:
            raise SessionError(
                f"{node_id!r} is of type {actor.node.type!r}, but {plan.type!r} is being taught"
            )
    _check_arguments(machine, plan)


def _check_arguments(machine: Machine, plan: Teach) -> None:
    targets = machine.types.vocabulary(plan.type).targets
    automaton = automaton_of(machine, plan)
    for parameter in automaton.parameters:
        given = plan.arguments.get(parameter)
        if given not in targets:
            what = "open" if given is None else f"{given!r}"
            raise SessionError(
                f"while teaching, {parameter!r} is {what}; choose one of: {some(list(targets))}"
            )
    if unknown := [name for name in plan.arguments if name not in automaton.parameters]:
        there = some(list(automaton.parameters))
        raise SessionError(f"{automaton.name!r} has no parameter {unknown[0]!r}; there are: {there}")


def automaton_of(machine: Machine, plan: Teach) -> Automaton:
    """The automaton that is taught."""
    return machine.types.library(plan.type).get(plan.automaton)


def deleted(plan: Teach, before: Project, now: Project) -> str:
    """That what is taught was deleted, and how it comes back; empty if it is still there."""
    gone = before.library(plan.type).automata.get(plan.automaton)
    if gone is None or plan.automaton in now.library(plan.type).automata:
        return ""
    return f"{gone.name} was deleted; undo brings it back"


def is_taught_one(run: Run | None, plan: Teach) -> bool:
    """Whether what a node does is the automaton that is taught."""
    behavior = None if run is None else run.behavior
    return isinstance(behavior, Automaton) and behavior.id == plan.automaton


def still_nodes(forest: Hierarchy, pupils: Iterable[Node], others: Others) -> frozenset[str]:
    """The nodes that do not tick: the pupils' ancestors, and unless the others are to run all that is not below a pupil."""
    pupils = tuple(pupils)
    if others is Others.RUN:
        return _ancestors(forest, pupils)
    at_work = {node.id for pupil in pupils for node in pupil.walk()}
    return frozenset(node.id for node in forest.walk()) - at_work


def _ancestors(forest: Hierarchy, nodes: Iterable[Node]) -> frozenset[str]:
    parents, above = forest.parents(), set[str]()
    for node in nodes:
        node_id = node.id
        while node_id in parents and parents[node_id] not in above:
            node_id = parents[node_id]
            above.add(node_id)
    return frozenset(above)


def some(names: list[str], most: int = MOST_NAMES) -> str:
    """The first of *names* as a list to read, and how many more there are."""
    listed = ", ".join(names[:most]) or "none"
    return listed + (f" and {len(names) - most} more" if len(names) > most else "")
