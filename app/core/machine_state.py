"""What every node is doing, as plain data: for snapshots, stepping back, and features added after demonstrating."""

from collections.abc import Mapping
from typing import Any

from .automaton import Automaton
from .library import Behavior
from .machine import Actor, Argument, Machine, Run

#: JSON-ready: node id -> what it runs, its flags, and what it last directed.
MachineState = Mapping[str, Any]


def freeze(machine: Machine) -> MachineState:
    """A copy of what all nodes do, and of the tick that comes next."""
    return {"now": machine.now, "nodes": {node_id: _frozen(actor) for node_id, actor in machine.actors.items()}}


def thaw(machine: Machine, state: MachineState) -> None:
    """Put every node that *state* knows back to what it did; behaviors are taken from the machine's libraries.

    A node whose behavior or state is no longer there idles.
    """
    machine.now = state["now"]
    for node_id, frozen in state["nodes"].items():
        if node_id in machine.actors:
            actor = machine.actors[node_id]
            actor.run = _thawed_run(machine, actor, frozen["run"])
            actor.flags = set(frozen["flags"])
            direction = frozen["direction"]
            actor.direction = None if direction is None else (direction[0], _arguments(direction[1]))


def _frozen(actor: Actor) -> Mapping[str, Any]:
    direction = None if actor.direction is None else [actor.direction[0], _plain(actor.direction[1])]
    return {
        "run": None if actor.run is None else _frozen_run(actor.run),
        "flags": sorted(actor.flags),
        "direction": direction,
    }


def _frozen_run(run: Run) -> Mapping[str, Any]:
    is_automaton = isinstance(run.behavior, Automaton)
    return {
        "automaton": run.behavior.id if isinstance(run.behavior, Automaton) else None,
        "basic": None if is_automaton else run.behavior.name,
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
    if isinstance(behavior, Automaton) and not behavior.has_state(frozen["state"]):
        return None
    return Run(
        behavior,
        _arguments(frozen["arguments"]),
        set(frozen["flags"]),
        frozen["state"],
        frozen["entered"],
        _thawed_run(machine, actor, frozen["child"]),
        _tupled(frozen["key"]),
        frozen["pulsed"],
    )


def _behavior(machine: Machine, actor: Actor, frozen: Mapping[str, Any]) -> Behavior | None:
    if frozen["automaton"] is not None:
        return machine.types.library(actor.node.type).automata.get(frozen["automaton"])
    return machine.types.vocabulary(actor.node.type).behaviors.get(frozen["basic"])


def _plain(arguments: Mapping[str, Argument]) -> Mapping[str, list[str]]:
    return {slot: [argument.target, argument.owner] for slot, argument in arguments.items()}


def _arguments(plain: Mapping[str, list[str]]) -> Mapping[str, Argument]:
    return {slot: Argument(target, owner) for slot, (target, owner) in plain.items()}


def _listed(key: object) -> object:
    return [_listed(part) for part in key] if isinstance(key, tuple) else key


def _tupled(key: object) -> object:
    return tuple(_tupled(part) for part in key) if isinstance(key, list) else key
