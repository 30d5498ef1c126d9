"""What the user's hand did in a lesson, with what it takes to undo it and to do it again."""

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


@dataclass(frozen=True, slots=True)
class Undone:
    """An act that was taken back.

    Attributes:
        after: What the node and all below it did when it was taken back; None if they have begun anew since the act.
        was_taught: The node was in training mode then.
    """

    act: Act
    after: MachineState | None
    was_taught: bool


def past(acts: Iterable[Act]) -> list[Act]:
    """Acts of before the nodes began anew: undoing them takes back what they recorded, and puts no node back."""
    return [replace(act, before=None, mended=None, done=True) for act in acts]


def past_undone(undone: Iterable[Undone]) -> list[Undone]:
    """The same for acts that were taken back: doing them again brings back what they recorded."""
    return [Undone(past([each.act])[0], None, was_taught=False) for each in undone]


def part_of(state: MachineState, node: Node) -> MachineState:
    """What a node and all below it did."""
    return {"now": state["now"], "nodes": {below.id: state["nodes"][below.id] for below in node.walk()}}


def put_back(machine: Machine, node_id: str, did: MachineState) -> None:
    """Let a node and all below it do again what they *did*; the ticks since then do not count for them."""
    passed = machine.now - did["now"]
    nodes = {below: _later(node, passed) for below, node in did["nodes"].items()}
    thaw_node(machine, node_id, {"now": machine.now, "nodes": nodes})


def _later(node: Mapping[str, Any], ticks: int) -> Mapping[str, Any]:
    return {**node, "run": _run_later(node["run"], ticks)}


def _run_later(run: Mapping[str, Any] | None, ticks: int) -> Mapping[str, Any] | None:
    if run is None:
        return None
    return {**run, "entered": run["entered"] + ticks, "child": _run_later(run["child"], ticks)}
