"""What can be done about a problem with one click: a table of ways, each of which looks whether it applies.

A problem's own repair comes first. Where there are several ways, such as targets that a slot can be bound to, all are given.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from difflib import get_close_matches
from functools import partial
from typing import Any

from ..automaton import START, Automaton, Basic, Nested, State, reachable
from ..edits import (
    bind_state,
    disable_examples,
    drop_feature,
    rebind_feature,
    remove_demonstration,
    remove_node,
    remove_state,
    rename_automaton,
    replace_arm,
    set_content,
)
from ..edits.bindings import bindings_of
from ..edits.calls import root_types
from ..errors import UnderstudyError
from ..features import Binding, FeatureUse, FlagUp, Ground, Over, Parameter, Sense, Statistic
from ..library import Types
from ..naming import fresh_name
from ..project import Arm, Project
from ..vocabulary import Vocabulary
from .problem import Problem
from .spots import Spot, spot_of

#: More ways than this are no help.
MOST = 16


@dataclass(frozen=True, slots=True)
class Fix:
    """One way to mend a problem.

    Attributes:
        text: What it does: "bind 'target' to deposit".
        mend: The edit. It can be refused, like every edit.
    """

    text: str
    mend: Callable[[Project], Project]


@dataclass(frozen=True, slots=True)
class Case:
    """A problem with what is needed to mend it.

    Attributes:
        automaton: The behavior that it is about, if it is about one that is there.
    """

    problem: Problem
    spot: Spot
    project: Project
    types: Types
    automaton: Automaton | None

    @property
    def where(self) -> tuple[str, str]:
        """The behavior, as edits name it."""
        return self.spot.type, self.spot.automaton

    def edit(self, edit: Callable[..., Project], *args: Any, **kwargs: Any) -> Callable[[Project], Project]:
        """*edit* of the behavior with further arguments, to be applied to a project."""
        return lambda project: edit(project, *self.where, *args, **kwargs)

    @property
    def state(self) -> State | None:
        """The state that it is about."""
        states = self.automaton.states if self.automaton else ()
        return next((state for state in states if state.id == self.spot.state), None)

    @property
    def feature(self) -> FeatureUse | None:
        """The feature that it is about."""
        features = self.automaton.features if self.automaton else ()
        return next((use for use in features if use.id == self.spot.feature), None)


def fixes(problem: Problem, project: Project, types: Types) -> tuple[Fix, ...]:
    """All ways to mend *problem*, the best first; none where the user has to decide more than a click can say."""
    spot = spot_of(problem, project)
    case = Case(problem, spot, project, types, project.library(spot.type).automata.get(spot.automaton))
    found = [] if problem.mend is None or problem.fix is None else [Fix(problem.fix, problem.mend)]
    for way in WAYS:
        found += way(case)
    return tuple({fix.text: fix for fix in found}.values())[:MOST]


# ------------------------------------------------------------------------------------------- bindings


def _bind_slot(case: Case) -> Iterator[Fix]:
    """Bind what is open, or bound to what is not there, to what is."""
    value = _bound_value(case)
    if "bindings" not in case.spot.part or value is None or case.automaton is None:
        return
    for slot in _slots(case, value):
        if not case.problem.message.startswith(repr(slot)):
            continue
        for binding in _bindings(case):
            name = binding.target if isinstance(binding, Ground) else f"parameter {binding.name!r}"
            yield Fix(f"bind {slot!r} to {name}", partial(_bound, case.where, case.spot, slot, binding))


def _bound_value(case: Case) -> Basic | Nested | Sense | None:
    if case.state is not None and isinstance(case.state.content, Basic | Nested):
        return case.state.content
    source = case.feature.source if case.feature is not None else None
    inner = source.of if isinstance(source, Statistic) else source
    return inner if isinstance(inner, Sense) else None


def _slots(case: Case, value: Basic | Nested | Sense) -> tuple[str, ...]:
    vocabulary = _vocabulary(case)
    match value:
        case Basic(name):
            return vocabulary.behaviors[name].parameters if name in vocabulary.behaviors else ()
        case Nested(held):
            automaton = case.types.library(case.spot.type).automata.get(held)
            return automaton.parameters if automaton else ()
        case Sense(name):
            known = {**case.types.agent_features().features, **vocabulary.features}
            return known[name].parameters if name in known else ()


def _bindings(case: Case) -> Iterator[Binding]:
    """What a slot can be bound to: parameters of the behavior first."""
    for name in case.automaton.parameters if case.automaton else ():
        yield Parameter(name)
    for target in _vocabulary(case).targets:
        yield Ground(target)


def _bound(where: tuple[str, str], spot: Spot, slot: str, binding: Binding, project: Project) -> Project:
    if spot.state:
        return bind_state(project, *where, spot.state, slot, binding)
    use = project.library(where[0]).get(where[1]).feature(spot.feature)
    bindings = {**bindings_of(use.source), slot: binding}
    source = use.source
    if isinstance(source, Statistic) and isinstance(source.of, Sense):
        source = replace(source, of=replace(source.of, bindings=bindings))
    elif isinstance(source, Sense):
        source = replace(source, bindings=bindings)
    return rebind_feature(project, *where, spot.feature, source)


def _vocabulary(case: Case) -> Vocabulary:
    try:
        return case.types.vocabulary(case.spot.type)
    except UnderstudyError:
        return Vocabulary()


# ------------------------------------------------------------------------------------ states and features


def _remove_unreachable(case: Case) -> Iterator[Fix]:
    """Take a state away that is never entered."""
    state, automaton = case.state, case.automaton
    if state is None or automaton is None or case.spot.part or state.id == START:
        return
    if case.problem.severity == "warning" and state.id not in reachable(automaton) and not case.spot.rule:
        yield Fix(
            "remove the state",
            case.edit(remove_state, state.id),
        )


def _replace_missing(case: Case) -> Iterator[Fix]:
    """Let a state hold the behavior with the nearest name, or take the state away."""
    state = case.state
    if state is None or case.spot.part not in ("content.behavior", "content.automaton"):
        return
    if isinstance(state.content, Basic):
        for name in get_close_matches(state.content.behavior, list(_vocabulary(case).behaviors), n=2):
            content = replace(state.content, behavior=name)
            yield Fix(f"let it hold {name}", case.edit(set_content, state.id, content))
    yield Fix("remove the state", case.edit(remove_state, state.id))


def _drop_feature(case: Case) -> Iterator[Fix]:
    """Look at something else, or not at all."""
    use = case.feature
    if use is None or "bindings" in case.spot.part:
        return
    if isinstance(use.source, Statistic) and case.spot.part == "source.over":
        wider = replace(use.source, over=Over.AGENTS)
        yield Fix("range over all agents below", case.edit(rebind_feature, use.id, wider))
    if isinstance(use.source, Sense) and case.spot.part == "source.feature":
        for name in get_close_matches(use.source.feature, list(_vocabulary(case).features), n=2):
            source = replace(use.source, feature=name)
            yield Fix(f"look at {name}", case.edit(rebind_feature, use.id, source))
    what = "stop looking at the flag" if isinstance(use.source, FlagUp) else "drop the feature"
    yield Fix(what, case.edit(drop_feature, use.id, force=True))


def _rename_twin(case: Case) -> Iterator[Fix]:
    """Give a behavior a name of its own."""
    if case.automaton is None or case.spot.part != "name" or not case.automaton.name.strip():
        return
    taken = {automaton.name for automaton in case.project.library(case.spot.type).automata.values()}
    name = fresh_name(taken | set(_vocabulary(case).behaviors), case.automaton.name)
    yield Fix(f"rename it to {name}", case.edit(rename_automaton, name))


def _disable_unmeasured(case: Case) -> Iterator[Fix]:
    """Set examples aside that lack the value of a feature."""
    if case.automaton is None or case.problem.file.partition("/")[0] != "examples" or case.spot.example:
        return
    features = {use.id for use in case.automaton.features}
    lacking = [
        example.id
        for example in case.project.examples_of(*case.where)
        if example.enabled and not features <= example.values.keys()
    ]
    if lacking:
        yield Fix("disable the examples that lack it", case.edit(disable_examples, lacking))


# ------------------------------------------------------------------------------- arms and demonstrations


def _mend_arm(case: Case) -> Iterator[Fix]:
    """Let an arm start with what its roots can do, in a world that is there."""
    arm = next((arm for arm in case.project.arms if arm.name == case.spot.arm), None)
    if arm is None:
        return
    if case.spot.part.startswith("top"):
        for name in _tops(case, arm):
            yield Fix(f"start with {name}", _changed_arm(arm, top=name))
    if case.spot.part == "world":
        for name in get_close_matches(arm.world, [name for name in case.project.worlds if name], n=2):
            yield Fix(f"take the world {name!r}", _changed_arm(arm, world=name))
        yield Fix("take the project's own parameters", _changed_arm(arm, world=""))
    if case.spot.node:
        yield Fix("remove the node", partial(remove_node, arm=arm.name, node=case.spot.node))


def _tops(case: Case, arm: Arm) -> list[str]:
    """Behaviors without parameters that all the roots can do, names like the present one first."""
    try:
        repertoires = [case.types.repertoire(name) for name in sorted(root_types(arm))]
    except UnderstudyError:
        return []
    first, *others = repertoires or [{}]
    free = [
        name
        for name, behavior in first.items()
        if not behavior.parameters and all(name in other for other in others)
    ]
    near = get_close_matches(arm.top, free, n=3)
    return [*near, *(name for name in reversed(free) if name not in near)]


def _changed_arm(arm: Arm, **fields: str) -> Callable[[Project], Project]:
    changed = replace(arm, **fields)  # type: ignore[arg-type]  # top and world, which are words
    return partial(_with_arm, arm.name, changed)


def _with_arm(name: str, arm: Arm, project: Project) -> Project:
    return replace_arm(project, name, arm)


def _remove_demonstration(case: Case) -> Iterator[Fix]:
    """Take a demonstration away that cannot be played; its examples stay."""
    if case.spot.demonstration:
        gone = case.spot.demonstration
        yield Fix("remove the demonstration", partial(remove_demonstration, demonstration_id=gone))


#: The ways, in the order in which they are offered.
WAYS: tuple[Callable[[Case], Iterator[Fix]], ...] = (
    _bind_slot,
    _remove_unreachable,
    _replace_missing,
    _drop_feature,
    _rename_twin,
    _disable_unmeasured,
    _mend_arm,
    _remove_demonstration,
)
