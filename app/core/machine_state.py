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
        What the nodes did before.
    """
    state = freeze(machine)
    machine.use(types, classifiers)
    thaw(machine, state)
    return state


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
    behavior = None if frozen is None else _behavior(machine, actor, frozen)
    if frozen is None or behavior is None:
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


def _behavior(machine: Machine, actor: Actor, frozen: Mapping[str, Any]) -> Behavior | None:
    if frozen["automaton"] is not None:
        return machine.types.library(actor.node.type).automata.get(frozen["automaton"])
    return machine.types.vocabulary(actor.node.type).behaviors.get(frozen["basic"])


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
    name, arguments = frozen[0], _arguments(machine, frozen[1])
    behavior = machine.types.vocabulary(actor.node.type).behaviors.get(name)
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
