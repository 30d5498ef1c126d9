"""The rest of a project between values and files: examples, demonstrations, and ``project.json``."""

from collections.abc import Iterable
from dataclasses import asdict
from typing import Any

from ..examples import Example
from ..hierarchy import Hierarchy, Node
from ..library import NodeType
from ..project import Arm, Demonstration, LevelTable, Pick, Positions, Project
from .convert import Document, state_document, state_value
from .project_schema import (
    ArmRecord,
    DemonstrationRecord,
    ExampleRecord,
    ExamplesRecord,
    LayoutRecord,
    NodeRecord,
    NodeTypeRecord,
    ProjectRecord,
    TableRecord,
)

# ----------------------------------------------------------------------------------- examples and demonstrations


def examples_document(automaton_id: str, examples: Iterable[Example]) -> Document:
    """The examples of one automaton as ``examples/TYPE/ID.json`` holds them."""
    return {"automaton": automaton_id, "examples": [_example_document(example) for example in examples]}


def _example_document(example: Example) -> Document:
    return {
        "id": example.id,
        "source": example.source,
        "label": example.label,
        "values": dict(example.values),
        "continuation": example.continuation,
        "enabled": example.enabled,
        "weight": example.weight,
        "demonstration": example.demonstration,
        "tick": example.tick,
        "node": example.node,
        "snapshot": example.snapshot,
        "pick": example.pick,
    }


def examples_value(record: ExamplesRecord) -> tuple[Example, ...]:
    """The examples that *record* describes."""
    return tuple(_example_value(example) for example in record.examples)


def _example_value(record: ExampleRecord) -> Example:
    return Example(
        record.id,
        record.source,
        record.label,
        record.values,
        record.continuation,
        record.enabled,
        record.weight,
        record.demonstration,
        record.tick,
        record.node,
        record.snapshot,
        record.pick,
    )


def layout_document(automaton_id: str, layout: Positions) -> Document:
    """Where states of one automaton were put, as ``layouts/TYPE/ID.json`` holds it."""
    return {
        "automaton": automaton_id,
        "states": {state: {"x": x, "y": y} for state, (x, y) in layout.items()},
    }


def layout_value(record: LayoutRecord) -> Positions:
    """The layout that *record* describes."""
    return {state: (place.x, place.y) for state, place in record.states.items()}


def demonstration_document(demonstration: Demonstration) -> Document:
    """*demonstration* as ``demonstrations/ID.json`` holds it."""
    return {
        "id": demonstration.id,
        "type": demonstration.type,
        "automaton": demonstration.automaton,
        "arm": demonstration.arm,
        "seed": demonstration.seed,
        "picks": [asdict(pick) for pick in demonstration.picks],
        "ticks": demonstration.ticks,
        "parameters": dict(demonstration.parameters),
        "arguments": dict(demonstration.arguments),
        "others": demonstration.others,
        "note": demonstration.note,
        "removed": [state_document(state) for state in demonstration.removed],
    }


def demonstration_value(record: DemonstrationRecord) -> Demonstration:
    """The demonstration that *record* describes."""
    return Demonstration(
        record.id,
        record.type,
        record.automaton,
        record.arm,
        record.seed,
        tuple(Pick(p.tick, p.node, p.state, p.act, p.entity, p.x, p.y) for p in record.picks),
        record.ticks,
        record.parameters,
        record.arguments,
        record.others,
        record.note,
        tuple(state_value(state) for state in record.removed),
    )


# --------------------------------------------------------------------------------------------------- project.json


def project_document(project: Project, version: int) -> Document:
    """What ``project.json`` holds."""
    return {
        "schema_version": version,
        "name": project.name,
        "scenario": project.scenario,
        "types": [_node_type_document(node_type) for node_type in project.types],
        "worlds": {name: dict(parameters) for name, parameters in project.worlds.items()},
        "arms": [_arm_document(arm) for arm in project.arms],
        "demonstrations": [demonstration.id for demonstration in project.demonstrations],
        "note": project.note,
    }


def project_value(record: ProjectRecord, **parts: Any) -> Project:
    """The project that *record* describes, with the *parts* that other files hold."""
    return Project(
        record.name,
        record.scenario,
        types=tuple(_node_type_value(node_type) for node_type in record.types),
        worlds=record.worlds,
        arms=tuple(_arm_value(arm) for arm in record.arms),
        note=record.note,
        **parts,
    )


def _node_type_document(node_type: NodeType) -> Document:
    return {
        "name": node_type.name,
        "level": node_type.level,
        "subsidiaries": list(node_type.subsidiaries),
    }


def _node_type_value(record: NodeTypeRecord) -> NodeType:
    return NodeType(record.name, record.level, tuple(record.subsidiaries))


def _arm_document(arm: Arm) -> Document:
    return {
        "name": arm.name,
        "hierarchy": _hierarchy_document(arm.hierarchy),
        "top": arm.top,
        "world": arm.world,
        "parameters": dict(arm.parameters),
        "note": arm.note,
    }


def _arm_value(record: ArmRecord) -> Arm:
    forest = record.hierarchy
    hierarchy: LevelTable | Hierarchy
    if isinstance(forest, TableRecord):
        hierarchy = LevelTable(tuple(forest.sizes), tuple(forest.types))
    else:
        hierarchy = Hierarchy(tuple(_node_value(node) for node in forest.roots))
    return Arm(record.name, hierarchy, record.top, record.world, record.parameters, record.note)


def _hierarchy_document(hierarchy: Hierarchy | LevelTable) -> Document:
    if isinstance(hierarchy, LevelTable):
        return {"kind": "table", "sizes": list(hierarchy.sizes), "types": list(hierarchy.types)}
    return {"kind": "forest", "roots": [_node_document(node) for node in hierarchy.roots]}


def _node_document(node: Node) -> Document:
    children = [_node_document(child) for child in node.children]
    return {"id": node.id, "type": node.type, "children": children, "name": node.name}


def _node_value(record: NodeRecord) -> Node:
    children = tuple(_node_value(child) for child in record.children)
    return Node(record.id, record.type, children, record.name)
