"""Lowering: what the nodes of a forest may come to run, found from what they run now, as rows of flat tables."""

from collections.abc import Hashable, Iterable
from dataclasses import dataclass, field
from itertools import accumulate

import numpy as np

from ...core.actor import Actor
from ...core.automaton import (
    START,
    Automaton,
    Basic,
    Content,
    Nested,
    RaiseFlag,
    Sampling,
    State,
)
from ...core.errors import ProgramError, UnderstudyError
from ...core.features import (
    Binding,
    Bindings,
    FeatureUse,
    FlagUp,
    Ground,
    Operation,
    Over,
    Sense,
    Statistic,
    TicksInState,
    describe,
    empty_statistic,
)
from ...core.library import Types, statistic_vocabulary
from ...core.machine import Classifiers
from ...core.tree import Forest, Tree
from ...core.vocabulary import FINISHED, BasicBehavior, Feature
from ..scenario import Scenario
from . import tables
from .code import Code, Transition
from .needs import Needs
from .reach import Reached
from .tables import TABLE_COLUMNS, Program, Sizes, StateRow


def lower(
    actors: Iterable[Actor], types: Types, scenario: Scenario, classifiers: Classifiers, needs: Needs
) -> Program:
    """The program of a forest whose nodes are in the middle of *needs*.

    Args:
        actors: All nodes, in the order in which they tick.

    Raises:
        ProgramError: Something that can be reached has no flat form: a classifier that is no tree, an open binding.
    """
    try:
        return _Lowering(actors, types, scenario, classifiers).program(needs)
    except ProgramError:
        raise
    except (UnderstudyError, KeyError) as error:
        raise ProgramError(f"not everything that may run can be lowered: {error}") from error


@dataclass(slots=True)
class _Rows:
    """Columns while they grow, by name."""

    columns: dict[str, list[int]] = field(default_factory=dict)

    def add(self, **row: int) -> None:
        for name, value in row.items():
            self.columns.setdefault(name, []).append(value)


class _Lowering:
    def __init__(
        self, actors: Iterable[Actor], types: Types, scenario: Scenario, classifiers: Classifiers
    ) -> None:
        self._types = types
        self._classifiers = classifiers
        self._actors = list(actors)
        self._agent_features = statistic_vocabulary(types)
        self._type_rows = {name: k for k, name in enumerate(dict.fromkeys(a.node.type for a in self._actors))}
        self._reached = Reached(types, self._actors)
        self._automata, self._basics = self._reached.automata, self._reached.basics
        self._states = self._reached.states
        self._features = {name: k for k, name in enumerate(scenario.features)}
        self._behaviors = {name: k for k, name in enumerate(scenario.behaviors)}
        self._targets = {name: k for k, name in enumerate(scenario.targets)}
        self._automaton_rows: dict[tuple[str, str], int] = {}
        self._basic_rows: dict[tuple[str, str], int] = {}
        self._flags: dict[str, int] = {}
        self._uses: dict[Hashable, int] = {}
        self._use_names: list[str] = []
        self._bindings: list[int] = []
        self._labels: list[int] = []
        self._rows = _Rows()
        self._floats: dict[str, list[float]] = {"default": [], "empty": []}
        self._code = Code()
        self._slots = 1
        self._flag(FINISHED)

    # ----------------------------------------------------------------------------------- what is reached

    def program(self, needs: Needs) -> Program:
        for flag in sorted(needs.flags):
            self._flag(flag)
        self._reached.find(needs)
        self._automaton_rows = {key: row for row, key in enumerate(self._automata)}
        self._basic_rows = {key: row for row, key in enumerate(self._basics)}
        self._rows.add(**_STATE_NOWHERE)
        for key, row in self._automata.items():
            self._rows.add(start=row.states[START])
            for state_id, number in row.states.items():
                self._state(key, row.automaton.state(state_id), number)
        for (kind, _), basic in self._basics.items():
            self._basic(kind, basic)
        self._nodes()
        return self._assembled()

    # ------------------------------------------------------------------------------------------ states

    def _state(self, key: tuple[str, str], state: State, number: int) -> None:
        kind, automaton = key[0], self._automata[key].automaton
        transition = self._transition(key, state.id, number)
        self._states[number] = StateRow(
            self._states[number].automaton,
            state.id,
            tuple(rule.id for rule in transition.rules),
            transition.labels,
            len(transition.trees),
            bool(transition.prunes),
            transition.is_plain,
        )
        content, held, slots, bindings = self._content(kind, state.content)
        self._rows.add(
            code=self._code.write(transition),
            sampling=list(Sampling).index(automaton.settings.sampling),
            labels_at=len(self._labels),
            labels=len(transition.labels),
            trees=len(transition.trees) if isinstance(transition.model, Forest) else 0,
            prunable=int(bool(transition.prunes)),
            content=content,
            held=held,
            bound_at=self._bound(slots, bindings, automaton),
            bound=len(slots),
        )
        self._labels += [transition.goals(label) for label in transition.labels]

    def _transition(self, key: tuple[str, str], state_id: str, number: int) -> Transition:
        kind, automaton = key[0], self._automata[key].automaton
        states = self._automata[key].states
        model = self._classifiers(kind, automaton, state_id)
        if not (model is None or isinstance(model, Tree | Forest)):
            raise ProgramError(
                f"{automaton.name} decides by its {automaton.settings.classifier} model, which cannot be compiled: "
                "ticks are slower"
            )
        if model is not None and model != automaton.learned.get(state_id):
            raise ProgramError(
                f"state {state_id!r} of {automaton.name!r} decides by another model than it stores"
            )
        if isinstance(model, Forest) and not model.trees:
            raise ProgramError(f"state {state_id!r} of {automaton.name!r} has a forest without trees")
        return Transition(
            number,
            automaton.rules_of(state_id),
            model,
            automaton.prunes_of(state_id) if model is not None else (),
            automaton.settings.sampling,
            lambda goal: states.get(goal, tables.NOWHERE),
            lambda feature_id: self._use(key, automaton.feature(feature_id)),
        )

    def _content(self, kind: str, content: Content) -> tuple[int, int, tuple[str, ...], Bindings]:
        match content:
            case Basic(name, bindings):
                key = (kind, name)
                return tables.BASIC, self._basic_rows[key], self._basics[key].parameters, bindings
            case Nested(automaton_id, bindings):
                key = (kind, automaton_id)
                nested = self._automata[key].automaton
                return tables.NESTED, self._automaton_rows[key], nested.parameters, bindings
            case RaiseFlag(flag):
                return tables.FLAG, self._flag(flag), (), {}
            case _:
                return tables.NOTHING, 0, (), {}

    def _flag(self, name: str) -> int:
        """The mask of a flag."""
        mask = self._flags.setdefault(name, 1 << len(self._flags))
        if len(self._flags) > tables.MOST_BITS:
            raise ProgramError(f"more than {tables.MOST_BITS} flags are in use")
        return mask

    def _bound(self, slots: Iterable[str], bindings: Bindings, automaton: Automaton) -> int:
        """Write the bindings of *slots*; returns where they begin."""
        at = len(self._bindings)
        self._bindings += [self._binding(slot, bindings.get(slot), automaton) for slot in slots]
        self._slots = max(self._slots, len(self._bindings) - at)
        return at

    def _binding(self, slot: str, binding: Binding | None, automaton: Automaton) -> int:
        if isinstance(binding, Ground):
            return self._targets[binding.target]
        if binding is None or binding.name not in automaton.parameters:
            raise ProgramError(f"{slot!r} is open somewhere in {automaton.name!r}")
        return -1 - automaton.parameters.index(binding.name)

    # ---------------------------------------------------------------------------------------- features

    def _use(self, key: tuple[str, str], use: FeatureUse) -> int:
        automaton = self._automata[key].automaton
        identity = _identity(key, use)
        if identity not in self._uses:
            self._uses[identity] = len(self._use_names)
            self._use_names.append(describe(use.source))
            self._describe_use(key[0], automaton, use)
        return self._uses[identity]

    def _describe_use(self, kind: str, automaton: Automaton, use: FeatureUse) -> None:
        match use.source:
            case FlagUp(flag):
                self._put_use(tables.FLAG_UP, flag=self._flag(flag))
            case TicksInState():
                self._put_use(tables.TICKS_IN_STATE)
            case Sense(name, bindings):
                feature = self._types.vocabulary(kind).feature(name)
                if feature.whose == "group":
                    self._put_use(tables.GROUP, feature=self._features[name])
                else:
                    at = self._bound(feature.parameters, bindings, automaton)
                    self._put_sense(tables.SENSE, feature, at)
            case Statistic(operation, of, over):
                self._statistic(automaton, operation, of, direct=over is Over.SUBSIDIARIES)

    def _statistic(
        self, automaton: Automaton, operation: Operation, of: Sense | FlagUp, *, direct: bool
    ) -> None:
        number = list(Operation).index(operation)
        if isinstance(of, FlagUp):
            empty = empty_statistic(operation, 0.0)
            self._put_use(
                tables.STATISTIC_OF_FLAG,
                empty,
                flag=self._flag(of.flag),
                statistic=number,
                direct=int(direct),
            )
            return
        feature = self._agent_features.feature(of.feature)
        at = self._bound(feature.parameters, of.bindings, automaton)
        empty = empty_statistic(operation, feature.default)
        self._put_sense(tables.STATISTIC_OF_SENSE, feature, at, empty, statistic=number, direct=int(direct))

    def _put_sense(self, source: int, feature: Feature, at: int, empty: float = 0.0, **rest: int) -> None:
        self._put_use(
            source,
            empty,
            feature.default,
            feature=self._features[feature.name],
            slots_at=at,
            slots=len(feature.parameters),
            **rest,
        )

    def _put_use(self, source: int, empty: float = 0.0, default: float = 0.0, **given: int) -> None:
        row = dict.fromkeys(("feature", "slots_at", "slots", "flag", "statistic", "direct"), 0)
        self._rows.add(source=source, **{**row, **given})
        self._floats["default"].append(default)
        self._floats["empty"].append(empty)

    # ---------------------------------------------------------------------------- behaviors and nodes

    def _basic(self, kind: str, basic: BasicBehavior) -> None:
        self._slots = max(self._slots, len(basic.parameters))
        self._rows.add(
            behavior=-1 if basic.derived else self._behaviors[basic.name],
            once=int(basic.runs_once),
            raises=0 if basic.raises is None else self._flag(basic.raises),
            finishes=int(basic.finishes),
            derived=int(basic.derived),
            arity=len(basic.parameters),
        )
        below = self._reached.below.get(kind, ()) if basic.derived else ()
        for name in self._type_rows:
            self._rows.add(
                directs=self._what(name, self._reached.started(name, basic)) if name in below else 0
            )

    def _what(self, kind: str, started: str | BasicBehavior) -> int:
        """How a run says what it is: an automaton's row, or -1 - a basic behavior's."""
        if isinstance(started, BasicBehavior):
            return -1 - self._basic_rows[kind, started.name]
        return self._automaton_rows[kind, started]

    def _nodes(self) -> None:
        actors = self._actors
        rows = {actor.node.id: row for row, actor in enumerate(actors)}
        ends = list(accumulate(len(actor.children) for actor in actors))
        self._rows.columns |= {  # whole columns: there may be ten thousand nodes
            "type": [self._type_rows[actor.node.type] for actor in actors],
            "parent": [-1 if actor.parent is None else rows[actor.parent] for actor in actors],
            "first_member": [actor.members.start for actor in actors],
            "end_member": [actor.members.stop for actor in actors],
            "children_at": [0, *ends[:-1]],
            "children_end": ends,
            "child": [rows[child.node.id] for actor in actors for child in actor.children],
        }

    # -------------------------------------------------------------------------------------- the result

    def _assembled(self) -> Program:
        code = self._code
        found: dict[str, list[int] | list[float]] = {
            **self._rows.columns,
            **self._floats,
            "binding": self._bindings,
            "label": self._labels,
        }
        for name in ("operation", "use", "low", "high", "yes", "no", "goal", "mask", *_LEAF_COLUMNS):
            found[name] = getattr(code, name)
        found["goal"] = [  # only now are the sources of all uses known
            self._rows.columns["source"][use] if operation == tables.TEST else goal
            for operation, use, goal in zip(code.operation, code.use, code.goal, strict=True)
        ]
        return Program(
            self._sizes(),
            {name: _column(found.get(name, []), letter) for name, letter in TABLE_COLUMNS.items()},
            tuple(self._automata.values()),
            tuple((kind, basic) for (kind, _), basic in self._basics.items()),
            tuple(self._states),
            tuple(code.leaves),
            self._automaton_rows,
            self._basic_rows,
            code.leaf_rows,
            tuple(self._flags),
            tuple(self._targets),
            tuple(actor.node.id for actor in self._actors),
            tuple(self._use_names),
        )

    def _sizes(self) -> Sizes:
        parameters = [basic.parameters for basic in self._basics.values()]
        parameters += [row.automaton.parameters for row in self._automata.values()]
        return Sizes(
            nodes=len(self._actors),
            controllers=sum(not actor.is_agent for actor in self._actors),
            types=len(self._type_rows),
            levels=self._reached.levels(),
            arguments=max([1, *map(len, parameters)]),
            key_words=tables.KEY_HEAD + max(1, *(state.trees for state in self._states)),
            slots=self._slots,
            entries=1 + max(len(state.rules) + len(state.labels) for state in self._states),
            states=len(self._states),
            uses=len(self._use_names),
            targets=len(self._targets),
        )


_STATE_COLUMNS = "code sampling labels_at labels trees prunable content held bound_at bound"
_STATE_NOWHERE = dict.fromkeys(_STATE_COLUMNS.split(), 0)
_LEAF_COLUMNS = ("shares_at", "share", "running")


def _column(values: list[int] | list[float], letter: str) -> tables.Column:
    """A column that nobody writes to; one entry at least, so that it has an address."""
    column: tables.Column = np.array(values or [0], dtype=np.float64 if letter == "f" else np.int64)
    column.flags.writeable = False
    return column


def _identity(key: tuple[str, str], use: FeatureUse) -> Hashable:
    """Uses that always have the same value for one node in one tick are one: those bound to ground targets alone."""
    source = use.source
    sense = source.of if isinstance(source, Statistic) else source
    bindings = tuple(sorted(sense.bindings.items())) if isinstance(sense, Sense) else ()
    if isinstance(sense, FlagUp | TicksInState) or any(not isinstance(b, Ground) for _, b in bindings):
        return (*key, use.id)
    shape = (source.operation, source.over) if isinstance(source, Statistic) else ()
    assert isinstance(sense, Sense)
    return (sense.feature, bindings, shape)
