"""What the user's hand did in a lesson, with what it takes to undo it."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from ..core.edits.examples import Recorded
from ..core.hierarchy import Node
from ..core.machine import Machine
from ..core.machine_state import MachineState, thaw_node
from .departures import Departure


@dataclass(frozen=True, slots=True)
class Act:
    """A pick, or "should not have left".

    Attributes:
        goal: The state that the node enters in the next tick.
        before: What the node and all below it did before; None if they have begun anew since.
        was_taught: The node was in training mode before.
        mended: The departure that should not have been.
        done: The tick that carries it out has passed.
    """

    node: str
    recorded: Recorded
    goal: str
    before: MachineState | None
    was_taught: bool
    mended: Departure | None = None
    done: bool = False


def past(acts: Iterable[Act]) -> list[Act]:
    """Acts of before the nodes began anew: undoing them takes back what they recorded, and puts no node back."""
    return [replace(act, before=None, mended=None, done=True) for act in acts]


def part_of(state: MachineState, node: Node) -> MachineState:
    """What a node and all below it did."""
    return {"now": state["now"], "nodes": {below.id: state["nodes"][below.id] for below in node.walk()}}


def put_back(machine: Machine, act: Act) -> None:
    """Let the node of an act and all below it do again what they did; the ticks since then do not count for them."""
    if act.before is not None:
        passed = machine.now - act.before["now"]
        nodes = {node_id: _later(node, passed) for node_id, node in act.before["nodes"].items()}
        thaw_node(machine, act.node, {"now": machine.now, "nodes": nodes})


def _later(node: Mapping[str, Any], ticks: int) -> Mapping[str, Any]:
    return {**node, "run": _run_later(node["run"], ticks)}


def _run_later(run: Mapping[str, Any] | None, ticks: int) -> Mapping[str, Any] | None:
    if run is None:
        return None
    return {**run, "entered": run["entered"] + ticks, "child": _run_later(run["child"], ticks)}
