"""Random edits of random projects: undoing all brings back the very same value, and nothing is left dangling.

Arguments are drawn by the names of an edit's parameters, so every edit that is registered is tried.
"""

import copy
import inspect
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from app.core import edits
from app.core.automaton import Automaton, Basic, Content, Nested, RaiseFlag, Refit, Settings, State
from app.core.conditions import AtMost, Condition, Equals, InArc, Test
from app.core.edits import SENTENCES, Recorded, describe
from app.core.errors import EditError
from app.core.examples import Example
from app.core.features import FlagUp, Ground, Operation, Parameter, Sense, Statistic, TicksInState
from app.core.history import History
from app.core.library import Library
from app.core.project import Arm, Demonstration, LevelTable, Pick, Project
from app.core.tree import Branch, Leaf, Tree
from app.core.vocabulary import BasicBehavior
from tests import samples
from tests.strategies import projects

NAMES = ("left", "Go On", "new", "largo", "größe")
Draw = Callable[[st.SearchStrategy[Any]], Any]


class Arguments:
    """Draws arguments that are mostly there in *project*.

    Each method is called like a parameter, or like an edit and its parameter where the name means something else.
    """

    def __init__(self, project: Project, draw: Draw) -> None:
        self.project = project
        self._draw = draw
        held = [(t, a) for t, library in project.libraries.items() for a in library.automata.values()]
        nobody: list[tuple[str, Automaton | None]] = [(t.name, None) for t in project.types]
        self._type, self._automaton = self.pick([*held, *(nobody if not held else [])])
        self._state = str(self.pick(self.states()))
        self._arm = self.pick(project.arms)

    def pick(self, choices: Sequence[Any]) -> Any:
        """One of *choices*; the odd one out if there are none."""
        return self._draw(st.sampled_from(list(choices))) if choices else ""

    def some(self, choices: Sequence[Any]) -> list[Any]:
        return (
            self._draw(st.lists(st.sampled_from(list(choices)), max_size=3, unique=True)) if choices else []
        )

    def argument(self, edit: str, parameter: str) -> Any:
        own = getattr(self, f"{edit}__{parameter}", None)
        return (own or getattr(self, parameter))()

    # ------------------------------------------------------------------------------------ automata

    def automaton_ids(self) -> list[str]:
        return list(self.project.library(self._type).automata)

    def states(self) -> list[str]:
        return [state.id for state in self._automaton.states] if self._automaton else []

    def features(self) -> list[str]:
        return [use.id for use in self._automaton.features] if self._automaton else []

    def examples_there(self) -> list[str]:
        taught = self.project.examples_of(self._type, self._automaton.id) if self._automaton else ()
        return [example.id for example in taught]

    def type_name(self) -> str:
        return str(self._type)

    def automaton_id(self) -> str:
        return self._automaton.id if self._automaton else "gone"

    def name(self) -> str:
        return str(self.pick(NAMES))

    note = new = learned_from = name

    def parameters(self) -> list[str]:
        there = self._automaton.parameters if self._automaton else ()
        return self.some([*there, "target", "other"])

    def settings(self) -> Settings:
        return Settings(pruning_confidence=self.pick([None, 0.25, 0.9]))

    def replacement(self) -> str | BasicBehavior | None:
        found: str | BasicBehavior | None = self.pick([None, BasicBehavior("Forward"), *self.automaton_ids()])
        return found

    def old(self) -> str:
        return str(self.pick(self._automaton.parameters if self._automaton else ()))

    # -------------------------------------------------------------------------------------- states

    def state_id(self) -> str:
        return self._state

    source = state_id

    def target(self) -> str:
        return str(self.pick(self.states()))

    label = target

    def content(self) -> Content:
        bindings = self.pick([{}, {"target": Ground("deposit")}, {"target": Parameter("target")}])
        held = [Nested(i, bindings) for i in self.automaton_ids()]
        found: Content = self.pick([Basic("Forward"), Basic("Face", bindings), RaiseFlag("done"), *held])
        return found

    def slot(self) -> str:
        return str(self.pick(["target", "other"]))

    def binding(self) -> Ground | Parameter | None:
        found: Ground | Parameter | None = self.pick([None, Ground("deposit"), Parameter("target")])
        return found

    def to(self) -> int:
        return int(self._draw(st.integers(-1, 5)))

    def state_ids(self) -> list[str]:
        return self.some(self.states())

    forbidden = state_ids

    def positions(self) -> dict[str, tuple[float, float]]:
        return {state: (float(self.pick([0.0, -3.5, 1e6])), 2.0) for state in self.some(self.states())}

    def copy_states__source(self) -> tuple[str, str]:
        return self._type, self.automaton_id()

    def into(self) -> tuple[str, str]:
        return self._type, str(self.pick(self.automaton_ids()))

    # ------------------------------------------------------------------------- features, transitions

    def feature_id(self) -> str:
        return str(self.pick(self.features()))

    def force(self) -> bool:
        return bool(self._draw(st.booleans()))

    def add_feature__source(self) -> Any:
        sense = Sense("DistanceTo", {"target": self.pick([Ground("deposit"), Parameter("target")])})
        return self.pick([sense, FlagUp("done"), TicksInState(), Statistic(Operation.ANY, sense)])

    rebind_feature__source = add_feature__source

    def guard(self) -> tuple[Condition, ...]:
        tests = [AtMost(self.feature_id(), 2.0), Equals(self.feature_id(), 1.0)]
        return tuple(Condition(test, self.force()) for test in self.some(tests) if test.feature)

    def probability(self) -> float:
        return float(self.pick([0.0, 0.5, 1.0, 2.0]))

    def rule_id(self) -> str:
        return str(self.pick([rule.id for rule in self._automaton.rules] if self._automaton else []))

    def prune_id(self) -> str:
        return str(self.pick([prune.id for prune in self._automaton.prunes] if self._automaton else []))

    def cut_id(self) -> str:
        return str(self.pick([cut.id for cut in self._automaton.cuts] if self._automaton else []))

    def move_cut__guard(self) -> tuple[Condition, ...]:
        return self.guard() if self.force() else ()  # the way to the root

    def test(self) -> Test:
        feature = self.feature_id()
        found: Test = self.pick([AtMost(feature, 2.0), InArc(feature, -1.0, 1.0), Equals(feature, 1.0)])
        return found

    def rule_ids(self) -> list[str]:
        ids = [rule.id for rule in self._automaton.rules_of(self.state_id())] if self._automaton else []
        return list(self._draw(st.permutations(ids)))

    def models(self) -> dict[str, Any]:
        labels = tuple(self.states()[1:])
        counts = (1.0,) * len(labels)
        leaf = Leaf(counts)
        test = AtMost(self.feature_id(), 1.0)
        root = Branch(test, leaf, leaf, counts) if test.feature else leaf
        models = [Tree(labels, root), Refit("knn")] if labels else []
        return {state: self.pick(models) for state in self.some(self.states()) if models}

    def support(self) -> float:
        return float(self.pick([1.0, 2.0, 100.0]))

    # ------------------------------------------------------------------------------------- examples

    def examples(self) -> tuple[Example, ...]:
        values = dict.fromkeys(self.features(), 1.0)
        went = Example("", self.state_id(), self.state_id(), values, snapshot=self.pick(["", "m7"]), pick=9)
        return (went, Example("3", went.label, went.label, values, continuation=True, pick=9))

    def moments(self) -> dict[str, Any]:
        return {"m7": samples.moment()}

    def recorded(self) -> Recorded:
        state = self.pick([None, State("grabbing", Basic("GrabBox"))])
        return Recorded(self._type, self.automaton_id(), self.examples(), self.moments(), state)

    def example_ids(self) -> list[str]:
        return self.some(self.examples_there())

    def weight(self) -> float:
        return float(self.pick([0.5, 2.0, 0.0]))

    def values(self) -> dict[str, dict[str, float]]:
        return {example: dict.fromkeys(self.features(), 3.0) for example in self.example_ids()}

    # ------------------------------------------------------------------------------------ structure

    def arm(self) -> str:
        return self._arm.name if self._arm else "gone"

    rename_arm__name = replace_arm__name = delete_arm__name = move_arm__name = arm

    def add_arm__arm(self) -> Arm:
        return Arm(self.name(), LevelTable((2,), (self._type,)), "forage")

    replace_arm__arm = add_arm__arm

    def set_world__name(self) -> str:
        return str(self.pick(["", "hard", "new"]))

    rename_world__name = rename_world__new = delete_world__name = set_world__name

    def set_world__parameters(self) -> dict[str, int]:
        return {"boxes": 3}

    def hierarchy(self) -> LevelTable:
        return LevelTable((2,), (self._type,))

    def add_type__name(self) -> str:
        return str(self.pick(["robot", "team"]))

    rename_type__new = add_type__name

    def rename_type__name(self) -> str:
        return str(self._type)

    def node_type(self) -> str:
        return str(self.pick([t.name for t in self.project.types]))

    delete_type__name = set_subsidiaries__name = controller_type = node_type

    def subsidiaries(self) -> list[str]:
        return self.some([t.name for t in self.project.types])

    def nodes_there(self) -> list[str]:
        return [node.id for node in self._arm.forest().walk()] if self._arm else []

    def node(self) -> str:
        return str(self.pick(self.nodes_there()))

    def nodes(self) -> list[str]:
        return self.some(self.nodes_there())

    def under(self) -> str:
        return str(self.pick(["", *self.nodes_there()]))

    def demonstration(self) -> Demonstration:
        picks = (Pick(0, "agent-1", self.state_id()),)
        return Demonstration(
            self.demonstration_id(), self._type, self.automaton_id(), self.arm(), 1, picks, 9
        )

    def demonstration_id(self) -> str:
        return str(self.pick([d.id for d in self.project.demonstrations]))


def dangling(project: Project) -> Iterator[str]:
    """References inside the project that no edit may leave behind."""
    for type_name, library in project.libraries.items():
        assert any(t.name == type_name for t in project.types)
        assert not library.cycle()
        for automaton in library.automata.values():
            yield from _dangling(automaton, library, project.examples_of(type_name, automaton.id))
    for type_name, by_id in project.examples.items():
        yield from (f"examples of {i}" for i in by_id if i not in project.library(type_name).automata)
    arms = {arm.name for arm in project.arms}
    for demonstration in project.demonstrations:
        if demonstration.arm not in arms | {""}:
            yield f"arm of {demonstration.id}"


def _dangling(automaton: Automaton, library: Library, examples: Sequence[Example]) -> Iterator[str]:
    states = {state.id for state in automaton.states}
    features = {use.id for use in automaton.features}
    mentioned = [*automaton.learned]
    tested = []
    for rule in automaton.rules:
        mentioned += [rule.source, rule.target]
        tested += [condition.test.feature for condition in rule.guard]
    for prune in automaton.prunes:
        mentioned += [prune.source, *prune.forbidden]
        tested += [condition.test.feature for condition in prune.guard]
    for model in automaton.learned.values():
        if isinstance(model, Tree):
            mentioned += model.labels
            tested += model.features()
    for example in examples:
        mentioned += [example.source, example.label] if example.enabled else []
    yield from (f"state {s} of {automaton.id}" for s in mentioned if s not in states)
    yield from (f"feature {f} of {automaton.id}" for f in tested if f not in features)
    yield from (f"automaton {a} in {automaton.id}" for a in automaton.nested() if a not in library.automata)
    for ids in (
        [s.id for s in automaton.states],
        [f.id for f in automaton.features],
        [r.id for r in automaton.rules],
        [p.id for p in automaton.prunes],
        [e.id for e in examples],
    ):
        if len(ids) != len(set(ids)):
            yield f"an id of {automaton.id} stands twice"


def some_edit(history: History, draw: Draw, edit: Callable[..., Any]) -> bool:
    """Try *edit* with random arguments; whether it was not refused."""
    arguments = Arguments(history.project, draw)
    given = {
        name: arguments.argument(edit.__name__, name) for name in list(inspect.signature(edit).parameters)[1:]
    }
    assert describe(edit, history.project, **given)
    try:
        history.do(edit, **given)
    except EditError:
        return False
    return True


MANY = settings(max_examples=60, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large])


@MANY
@given(st.just(samples.project()) | projects(), st.data())
def test_undoing_all_edits_brings_back_the_very_same_project(first: Project, data: st.DataObject) -> None:
    pristine = copy.deepcopy(first)
    history = History(first)
    allowed = set(dangling(first))
    for edit in data.draw(st.lists(st.sampled_from(list(SENTENCES)), min_size=3, max_size=12)):
        some_edit(history, data.draw, edit)
        assert set(dangling(history.project)) <= allowed, edit.__name__
    last, steps = history.project, len(history.steps)
    reached = copy.deepcopy(last)
    while history.can_undo:
        history.undo()
    assert history.project is first
    assert first == pristine
    for _ in range(steps):
        history.redo()
    assert history.project is last
    assert last == reached


@settings(MANY, max_examples=30)
@given(st.data())
def test_taking_back_picks_in_reverse_brings_back_an_equal_project(data: st.DataObject) -> None:
    first = project = samples.project()
    done: list[Recorded] = []
    for _ in range(data.draw(st.integers(1, 4))):
        drawn = Arguments(project, data.draw).recorded()
        pick = edits.next_pick(project, drawn.type, drawn.automaton)
        recorded = replace(drawn, examples=tuple(replace(e, pick=pick) for e in drawn.examples))
        try:
            project = edits.record_pick(project, recorded)
        except EditError:
            continue
        done.append(recorded)
    for recorded in reversed(done):
        project = edits.take_back_pick(project, recorded)
    assert project == first
