"""Records keep up with the values that they are the form of."""

from dataclasses import fields
from types import NoneType
from typing import Any

import pytest

from app.core.automaton import Automaton, Cut, Prune, Refit, Rule, Settings, State
from app.core.conditions import AtMost, Equals, InArc
from app.core.examples import Example
from app.core.features import FeatureUse, FlagUp, Sense, Statistic
from app.core.hierarchy import Node
from app.core.library import NodeType
from app.core.project import Arm, Demonstration, LevelTable, Pick, Project
from app.core.storage import project_schema, schema
from app.core.storage.fields import Record
from app.core.storage.tree_schema import TreeRecord
from app.core.tree import FlatTree

PAIRS: dict[Any, type[Record]] = {
    Automaton: schema.AutomatonRecord,
    State: schema.StateRecord,
    Rule: schema.RuleRecord,
    Prune: schema.PruneRecord,
    Cut: schema.CutRecord,
    Settings: schema.SettingsRecord,
    Refit: schema.RefitRecord,
    FlatTree: TreeRecord,
    FeatureUse: schema.FeatureUseRecord,
    Sense: schema.SenseRecord,
    FlagUp: schema.FlagUpRecord,
    Statistic: schema.StatisticRecord,
    AtMost: schema.AtMostRecord,
    Equals: schema.EqualsRecord,
    InArc: schema.InArcRecord,
    Example: project_schema.ExampleRecord,
    Demonstration: project_schema.DemonstrationRecord,
    Pick: project_schema.PickRecord,
    NodeType: project_schema.NodeTypeRecord,
    Node: project_schema.NodeRecord,
    Arm: project_schema.ArmRecord,
    LevelTable: project_schema.TableRecord,
}
#: What only the form has: which of several it is, and whether a test must hold.
FORM = {"kind", "wanted"}


@pytest.mark.parametrize("value", PAIRS, ids=lambda value: value.__name__)
def test_every_field_of_a_value_has_a_place_on_disk(value: Any) -> None:
    assert {field.name for field in fields(value)} == set(PAIRS[value].model_fields) - FORM


def test_every_part_of_a_project_has_a_place_on_disk() -> None:
    elsewhere = {"libraries", "examples", "moments", "layouts"}
    stored = set(project_schema.ProjectRecord.model_fields) - {"schema_version"}
    assert {field.name for field in fields(Project)} == stored | elsewhere


@pytest.mark.parametrize("value", PAIRS, ids=lambda value: value.__name__)
def test_a_key_that_is_left_out_means_what_the_program_would_take(value: Any) -> None:
    records = PAIRS[value].model_fields
    simple = {f.name: f.default for f in fields(value) if isinstance(f.default, str | int | float | NoneType)}
    assert {name: records[name].default for name in simple} == simple
