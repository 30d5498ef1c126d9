"""What every node is doing, as plain data: for snapshots, stepping back, and features added after demonstrating."""

from collections.abc import Mapping
from typing import Any

from .actor import Actor, Argument, Arguments, Run
from .automaton import START, Automaton, Basic, Content, Nested
from .library import Behavior, Types
from .machine import Classifiers, Machine

#: JSON-ready: node id -> what it runs, its flags, and what it last directed.
MachineState = Mapping[str, Any]


def freeze(machine: Machine) -> MachineState:
    """A copy of what all nodes do, and of the tick that comes next."""
    return freeze_actors(machine.now, machine.actors)


def freeze_actors(now: int, actors: Mapping[str, Actor]) -> MachineState:
    """The same of nodes that are in no machine."""
    return {"now": now, "nodes": {node_id: _frozen(actor) for node_id, actor in actors.items()}}


def thaw(machine: Machine, state: MachineState) -> None:
    """Put every node that *state* knows back to what it did; behaviors are taken from the machine's libraries.

    What was edited away meanwhile does not come back. A node whose behavior is gone, or needs a target that it had
    not, idles. An automaton whose state is gone, or holds something else now, is in Start.
    """
    machine.now = state["now"]
    for node_id, frozen in state["nodes"].items():
        if node_id in machine.actors:
            _thaw(machine, machine.actors[node_id], frozen)


def thaw_node(machine: Machine, node_id: str, state: MachineState) -> None:
    """Put one node and all below it back to what they did, as `thaw` does; time and the other nodes go on."""
    for node in machine.actors[node_id].node.walk():
        if node.id in state["nodes"]:
            _thaw(machine, machine.actors[node.id], state["nodes"][node.id])


def resume_node(machine: Machine, node_id: str, state: MachineState) -> bool:
    """Let one node go on with what it did then, as if no time had passed since; whether its behavior is there to go on with."""
    actor, frozen = machine.actors[node_id], state["nodes"][node_id]
    if _thawed_run(machine, actor, frozen["run"]) is None:
        return False
    _thaw(machine, actor, frozen)
    run = actor.run
    while run is not None:
        run.entered = min(machine.now, run.entered + machine.now - state["now"])
        run = run.child
    return True


def rebase(machine: Machine, types: Types, classifiers: Classifiers) -> MachineState:
    """Go on with other libraries and models: every node goes on with what it does, as far as `thaw` can do that.

    Returns:
        What those nodes did that cannot go on with it, or are in another state for it.
    """
    machine.use(types, classifiers)
    now, lost = _Now(machine), {}
    for node_id, actor in machine.actors.items():
        run = None if actor.run is None else now.run(actor.node.type, actor.run)
        if run is not actor.run and _path(run) != _path(actor.run):
            lost[node_id] = _frozen(actor)
        actor.run = run
        if actor.direction is not None:
            actor.direction = _direction(machine, actor.node.type, *actor.direction)
    return {"now": machine.now, "nodes": lost}


class _Now:
    """What runs come to in a machine whose libraries have changed.

    Most nodes do what others do as well, so it is kept what becomes of a behavior, and whether it can stay in a state.
    """

    def __init__(self, machine: Machine) -> None:
        self._machine = machine
        self._behaviors: dict[tuple[str, int], Behavior | None] = {}  # by the old one
        self._stays: dict[tuple[int, str, int | None], bool] = {}  # by behavior, state, and what that runs

    def run(self, kind: str, run: Run) -> Run | None:
        """The run to go on with, the same one if nothing about it is different."""
        behavior = self._behavior(kind, run.behavior)
        if behavior is None or any(parameter not in run.arguments for parameter in behavior.parameters):
            return None
        child = None if run.child is None else self.run(kind, run.child)
        if isinstance(behavior, Automaton) and not self._stays_in(behavior, run.state, child):
            return Run(behavior, run.arguments, run.flags, entered=self._machine.now, pulsed=run.pulsed)
        if behavior is run.behavior and child is run.child:
            return run
        return Run(behavior, run.arguments, run.flags, run.state, run.entered, child, run.key, run.pulsed)

    def _behavior(self, kind: str, old: Behavior) -> Behavior | None:
        key = kind, id(old)
        if key not in self._behaviors:
            name = old.id if isinstance(old, Automaton) else old.name
            self._behaviors[key] = _behavior(self._machine, kind, name, automaton=isinstance(old, Automaton))
        return self._behaviors[key]

    def _stays_in(self, automaton: Automaton, state: str, child: Run | None) -> bool:
        key = id(automaton), state, None if child is None else id(child.behavior)
        if key not in self._stays:
            self._stays[key] = _holds(automaton, state, child)
        return self._stays[key]


def _path(run: Run | None) -> tuple[tuple[str, str], ...] | None:
    """The automata that run, each with its state, outermost first; None of a node that idles."""
    if run is None:
        return None
    path: list[tuple[str, str]] = []
    link: Run | None = run
    while link is not None:
        if isinstance(link.behavior, Automaton):
            path.append((link.behavior.id, link.state))
        link = link.child
    return tuple(path)


def _thaw(machine: Machine, actor: Actor, frozen: Mapping[str, Any]) -> None:
    actor.run = _thawed_run(machine, actor, frozen["run"])
    actor.flags = set(frozen["flags"])
    actor.direction = _thawed_direction(machine, actor, frozen["direction"])
    actor.left = frozen["left"]


def _frozen(actor: Actor) -> Mapping[str, Any]:
    direction = None if actor.direction is None else [actor.direction[0], _plain(actor.direction[1])]
    return {
        "run": None if actor.run is None else _frozen_run(actor.run),
        "flags": sorted(actor.flags),
        "direction": direction,
        "left": actor.left,
    }


def _frozen_run(run: Run) -> Mapping[str, Any]:
    behavior = run.behavior
    return {
        "automaton": behavior.id if isinstance(behavior, Automaton) else None,
        "basic": None if isinstance(behavior, Automaton) else behavior.name,
        "arguments": _plain(run.arguments),
        "flags": sorted(run.flags),
        "state": run.state,
        "entered": run.entered,
        "child": None if run.child is None else _frozen_run(run.child),
        "key": _listed(run.key),
        "pulsed": run.pulsed,
    }


def _thawed_run(machine: Machine, actor: Actor, frozen: Mapping[str, Any] | None) -> Run | None:
    if frozen is None:
        return None
    is_automaton = frozen["automaton"] is not None
    name = frozen["automaton"] if is_automaton else frozen["basic"]
    behavior = _behavior(machine, actor.node.type, name, automaton=is_automaton)
    if behavior is None:
        return None
    arguments = _arguments(machine, frozen["arguments"])
    if any(parameter not in arguments for parameter in behavior.parameters):
        return None
    run = Run(behavior, arguments, set(frozen["flags"]), entered=machine.now, pulsed=frozen["pulsed"])
    child = _thawed_run(machine, actor, frozen["child"])
    if not isinstance(behavior, Automaton) or _holds(behavior, frozen["state"], child):
        run.state, run.entered = frozen["state"], frozen["entered"]
        run.child, run.key = child, _tupled(frozen["key"])
    return run


def _behavior(machine: Machine, kind: str, name: str, *, automaton: bool) -> Behavior | None:
    """The automaton with an id, or the basic behavior with a name, that nodes of *kind* have."""
    if automaton:
        return machine.types.library(kind).automata.get(name)
    return machine.types.vocabulary(kind).behaviors.get(name)


def _holds(automaton: Automaton, state_id: str, child: Run | None) -> bool:
    """Whether a state is there and *child* is a run of what it holds; in Start, and after a flag, there is none."""
    if not automaton.has_state(state_id):
        return False
    content: Content = automaton.state(state_id).content
    match content:
        case Basic(name):
            return (
                child is not None
                and not isinstance(child.behavior, Automaton)
                and child.behavior.name == name
            )
        case Nested(automaton_id):
            return (
                child is not None
                and isinstance(child.behavior, Automaton)
                and child.behavior.id == automaton_id
            )
        case _:
            return state_id == START and child is None


def _thawed_direction(
    machine: Machine, actor: Actor, frozen: list[Any] | None
) -> tuple[str, Arguments] | None:
    if frozen is None:
        return None
    return _direction(machine, actor.node.type, frozen[0], _arguments(machine, frozen[1]))


def _direction(machine: Machine, kind: str, name: str, arguments: Arguments) -> tuple[str, Arguments] | None:
    behavior = _behavior(machine, kind, name, automaton=False)
    if behavior is None or any(parameter not in arguments for parameter in behavior.parameters):
        return None
    return name, arguments


def _plain(arguments: Arguments) -> Mapping[str, list[str]]:
    return {slot: [argument.target, argument.owner] for slot, argument in arguments.items()}


def _arguments(machine: Machine, plain: Mapping[str, list[str]]) -> Arguments:
    return {
        slot: Argument(target, owner) for slot, (target, owner) in plain.items() if owner in machine.actors
    }


def _listed(key: object) -> object:
    return [_listed(part) for part in key] if isinstance(key, tuple) else key


def _tupled(key: object) -> object:
    return tuple(_tupled(part) for part in key) if isinstance(key, list) else key
