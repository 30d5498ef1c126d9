"""Automata between values and files: ``*_document`` makes what JSON writes, ``*_value`` takes a checked record.

A document holds every key; whoever writes it checks it against its record first, which also drops defaults.
"""

from collections.abc import Iterable
from typing import Any

from ..automaton import (
    Automaton,
    Basic,
    Content,
    Cut,
    Model,
    Nested,
    Prune,
    RaiseFlag,
    Refit,
    Rule,
    Settings,
    Start,
    State,
)
from ..conditions import AtMost, Condition, Equals, Guard, InArc, Test
from ..features import (
    Bindings,
    FeatureUse,
    FlagUp,
    Ground,
    Parameter,
    Sense,
    Source,
    Statistic,
    TicksInState,
)
from ..tree import FlatTree, Forest, Tree, flatten, unflatten
from .schema import (
    AtMostRecord,
    AutomatonRecord,
    BasicRecord,
    BindingRecords,
    CutRecord,
    EqualsRecord,
    FeatureUseRecord,
    FlagUpRecord,
    GuardRecord,
    InArcRecord,
    ModelRecord,
    NestedRecord,
    PruneRecord,
    RaiseFlagRecord,
    RuleRecord,
    SenseRecord,
    SettingsRecord,
    StartRecord,
    StateRecord,
    StatisticRecord,
    TicksInStateRecord,
)
from .tree_schema import ArraysRecord, ForestRecord, TreeRecord

Document = dict[str, Any]


def automaton_document(automaton: Automaton) -> Document:
    """*automaton* as ``libraries/TYPE/ID.json`` holds it."""
    return {
        "id": automaton.id,
        "name": automaton.name,
        "parameters": list(automaton.parameters),
        "states": [state_document(state) for state in automaton.states],
        "features": [_feature_use_document(use) for use in automaton.features],
        "rules": [_rule_document(rule) for rule in automaton.rules],
        "learned": {state: _model_document(model) for state, model in automaton.learned.items()},
        "learned_from": automaton.learned_from,
        "prunes": [_prune_document(prune) for prune in automaton.prunes],
        "cuts": [_cut_document(cut) for cut in automaton.cuts],
        "settings": _settings_document(automaton.settings),
        "note": automaton.note,
    }


def automaton_value(record: AutomatonRecord) -> Automaton:
    """The automaton that *record* describes."""
    return Automaton(
        record.id,
        record.name,
        tuple(record.parameters),
        tuple(state_value(state) for state in record.states),
        tuple(_feature_use_value(use) for use in record.features),
        tuple(_rule_value(rule) for rule in record.rules),
        {state: _model_value(model) for state, model in record.learned.items()},
        record.learned_from,
        tuple(_prune_value(prune) for prune in record.prunes),
        _settings_value(record.settings),
        record.note,
        tuple(_cut_value(cut) for cut in record.cuts),
    )


# ------------------------------------------------------------------------------------------------------- features


def _bindings_document(bindings: Bindings) -> Document:
    return {
        slot: {"ground": binding.target} if isinstance(binding, Ground) else {"parameter": binding.name}
        for slot, binding in bindings.items()
    }


def _bindings_value(records: BindingRecords) -> Bindings:
    return {
        slot: Parameter(record.parameter) if record.parameter is not None else Ground(record.ground or "")
        for slot, record in records.items()
    }


def _feature_use_document(use: FeatureUse) -> Document:
    return {"id": use.id, "source": _source_document(use.source), "name": use.name}


def _feature_use_value(record: FeatureUseRecord) -> FeatureUse:
    return FeatureUse(record.id, _source_value(record.source), record.name)


def _source_document(source: Source) -> Document:
    match source:
        case Sense(feature, bindings):
            return {"kind": "sense", "feature": feature, "bindings": _bindings_document(bindings)}
        case FlagUp(flag):
            return {"kind": "flag", "flag": flag}
        case TicksInState():
            return {"kind": "ticks in state"}
        case Statistic(operation, of, over):
            return {"kind": "statistic", "operation": operation, "of": _source_document(of), "over": over}


def _source_value(record: SenseRecord | FlagUpRecord | TicksInStateRecord | StatisticRecord) -> Source:
    match record:
        case StatisticRecord():
            return Statistic(record.operation, _summed_value(record.of), record.over)
        case TicksInStateRecord():
            return TicksInState()
        case _:
            return _summed_value(record)


def _summed_value(record: SenseRecord | FlagUpRecord) -> Sense | FlagUp:
    if isinstance(record, FlagUpRecord):
        return FlagUp(record.flag)
    return Sense(record.feature, _bindings_value(record.bindings))


# ----------------------------------------------------------------------------------------- states, rules, prunes


def state_document(state: State) -> Document:
    """*state* as the files of automata and demonstrations hold it."""
    content = _content_document(state.content)
    return {"id": state.id, "content": content, "name": state.name, "note": state.note}


def state_value(record: StateRecord) -> State:
    """The state that *record* describes."""
    return State(record.id, _content_value(record.content), record.name, record.note)


def _content_document(content: Content) -> Document:
    match content:
        case Start():
            return {"kind": "start"}
        case Basic(behavior, bindings):
            return {"kind": "basic", "behavior": behavior, "bindings": _bindings_document(bindings)}
        case Nested(automaton, bindings):
            return {"kind": "automaton", "automaton": automaton, "bindings": _bindings_document(bindings)}
        case RaiseFlag(flag):
            return {"kind": "flag", "flag": flag}


def _content_value(record: StartRecord | BasicRecord | NestedRecord | RaiseFlagRecord) -> Content:
    match record:
        case StartRecord():
            return Start()
        case BasicRecord():
            return Basic(record.behavior, _bindings_value(record.bindings))
        case NestedRecord():
            return Nested(record.automaton, _bindings_value(record.bindings))
        case RaiseFlagRecord():
            return RaiseFlag(record.flag)


def _rule_document(rule: Rule) -> Document:
    return {
        "id": rule.id,
        "source": rule.source,
        "guard": _guard_document(rule.guard),
        "target": rule.target,
        "probability": rule.probability,
    }


def _rule_value(record: RuleRecord) -> Rule:
    return Rule(record.id, record.source, _guard_value(record.guard), record.target, record.probability)


def _prune_document(prune: Prune) -> Document:
    return {
        "id": prune.id,
        "source": prune.source,
        "guard": _guard_document(prune.guard),
        "forbidden": sorted(prune.forbidden),
    }


def _prune_value(record: PruneRecord) -> Prune:
    return Prune(record.id, record.source, _guard_value(record.guard), frozenset(record.forbidden))


def _cut_document(cut: Cut) -> Document:
    test = _test_document(cut.test)
    return {"id": cut.id, "source": cut.source, "guard": _guard_document(cut.guard), "test": test}


def _cut_value(record: CutRecord) -> Cut:
    return Cut(record.id, record.source, _guard_value(record.guard), _guard_value([record.test])[0].test)


def _guard_document(guard: Guard) -> list[Document]:
    return [{**_test_document(condition.test), "wanted": condition.wanted} for condition in guard]


def _guard_value(records: GuardRecord) -> Guard:
    return tuple(Condition(_test_value(record), record.wanted) for record in records)


def _test_document(test: Test) -> Document:
    match test:
        case AtMost(feature, threshold):
            return {"kind": "at most", "feature": feature, "threshold": threshold}
        case Equals(feature, value):
            return {"kind": "equals", "feature": feature, "value": value}
        case InArc(feature, start, end):
            return {"kind": "in arc", "feature": feature, "start": start, "end": end}


def _test_value(record: AtMostRecord | EqualsRecord | InArcRecord) -> Test:
    match record:
        case AtMostRecord():
            return AtMost(record.feature, record.threshold)
        case EqualsRecord():
            return Equals(record.feature, record.value)
        case InArcRecord():
            return InArc(record.feature, record.start, record.end)


# -------------------------------------------------------------------------------------------------------- learned


def _model_document(model: Model) -> Document:
    match model:
        case Tree():
            return {"kind": "tree", "labels": list(model.labels), **_arrays_document(model)}
        case Forest():
            assert all(tree.labels == model.labels for tree in model.trees), (
                "a forest's trees share its labels"
            )
            trees = [_arrays_document(tree) for tree in model.trees]
            return {"kind": "forest", "labels": list(model.labels), "trees": trees}
        case Refit(classifier):
            return {"kind": "refit", "classifier": classifier}


def _model_value(record: ModelRecord) -> Model:
    match record:
        case TreeRecord():
            return _tree_value(record, record.labels)
        case ForestRecord():
            trees = tuple(_tree_value(tree, record.labels) for tree in record.trees)
            return Forest(tuple(record.labels), trees)
        case _:
            return Refit(record.classifier)


def _arrays_document(tree: Tree) -> Document:
    flat = flatten(tree)
    return {
        "features": list(flat.features),
        "slot": list(flat.slot),
        "operation": list(flat.operation),
        "a": list(flat.a),
        "b": list(flat.b),
        "yes": list(flat.yes),
        "no": list(flat.no),
        "counts": [list(counts) for counts in flat.counts],
    }


def _tree_value(record: ArraysRecord, labels: Iterable[str]) -> Tree:
    return unflatten(
        FlatTree(
            tuple(labels),
            tuple(record.features),
            tuple(record.slot),
            tuple(record.operation),
            tuple(record.a),
            tuple(record.b),
            tuple(record.yes),
            tuple(record.no),
            tuple(tuple(counts) for counts in record.counts),
        )
    )


def _settings_document(settings: Settings) -> Document:
    return {
        "classifier": settings.classifier,
        "sampling": settings.sampling,
        "pruning_confidence": settings.pruning_confidence,
        "options": dict(settings.options),
    }


def _settings_value(record: SettingsRecord) -> Settings:
    return Settings(record.classifier, record.sampling, record.pruning_confidence, record.options)
