"""Edits of examples: what one pick recorded and its reverse, and corrections by hand.

Nothing here throws an example away except taking back the very pick that recorded it, and replaying demonstrations.
"""

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain, repeat
from math import isfinite
from operator import attrgetter

from ..automaton import Automaton, State
from ..errors import EditError
from ..examples import Example, Moment, changed
from ..naming import next_number
from ..project import Project
from .moments import with_moments, without_stray_moments
from .place import change, find_automaton, listed, with_examples
from .recursion import refuse_recursion
from .states import refuse_content, refuse_states, remove_state
from .words import says


@dataclass(frozen=True, slots=True)
class Recorded:
    """What one pick of the user recorded.

    Attributes:
        state: The state that the pick added, if the automaton lacked what was picked.
        examples: They share one pick number. An id that is empty or taken is replaced by the next number.
        moments: By hash, those that the examples refer to.
    """

    type: str
    automaton: str
    examples: tuple[Example, ...] = ()
    moments: Mapping[str, Moment] = field(default_factory=dict)
    state: State | None = None

    @property
    def pick(self) -> int | None:
        """The number that the examples share; None if there are none."""
        return self.examples[0].pick if self.examples else None

    @property
    def goal(self) -> str:
        """The id of the state that was picked; empty if nothing was recorded."""
        return self.examples[0].label if self.examples else self.state.id if self.state else ""


def next_pick(project: Project, type_name: str, automaton_id: str) -> int:
    """The number for the next pick: one more than any before."""
    return 1 + max((example.pick for example in project.examples_of(type_name, automaton_id)), default=0)


@says("Pick {recorded}")
def record_pick(project: Project, recorded: Recorded) -> Project:
    """Put in what a pick recorded: the state it added, its examples, its moments.

    Raises:
        EditError: The state's id is taken by a state that holds something else, or an example cannot be learned from.
    """
    where = (recorded.type, recorded.automaton)
    automaton = find_automaton(project, *where)
    if recorded.state is not None:
        refuse_content(project, recorded.type, recorded.state.content)
        automaton = _with_state(automaton, recorded.state)
        project = change(project, *where, states=automaton.states)
        refuse_recursion(project, recorded.type)
    before = project.examples_of(*where)
    new = _numbered(before, recorded.examples)
    _refuse_examples(automaton, new)
    return with_moments(with_examples(project, *where, (*before, *new)), recorded.moments)


def _with_state(automaton: Automaton, state: State) -> Automaton:
    if not automaton.has_state(state.id):
        return replace(automaton, states=(*automaton.states, state))
    if automaton.state(state.id).content != state.content:
        raise EditError(f"{automaton.name} already has another state with the id {state.id!r}")
    return automaton


def _numbered(before: Iterable[Example], new: Iterable[Example]) -> tuple[Example, ...]:
    taken = {example.id for example in before}
    highest = next_number(taken) - 1
    numbered = []
    for example in new:
        free = example.id and example.id not in taken
        kept = example if free else replace(example, id=str(highest + 1))
        highest = max(highest, next_number([kept.id]) - 1)
        taken.add(kept.id)
        numbered.append(kept)
    return tuple(numbered)


@says("Take back {recorded}")
def take_back_pick(project: Project, recorded: Recorded) -> Project:
    """The reverse of `record_pick`.

    The pick's examples go, the state it added if nothing else uses that, and moments that nothing refers to any more.
    """
    where = (recorded.type, recorded.automaton)
    find_automaton(project, *where)
    examples = project.examples_of(*where)
    kept = tuple(e for e in examples if e.pick != recorded.pick)
    if len(kept) < len(examples):
        project = with_examples(project, *where, kept)
    if recorded.state is not None and not _in_use(project, *where, recorded.state.id):
        project = remove_state(project, *where, recorded.state.id)
    return without_stray_moments(project)


def _in_use(project: Project, type_name: str, automaton_id: str, state_id: str) -> bool:
    """Whether anything besides the list of states mentions a state; also when it is gone already."""
    automaton = find_automaton(project, type_name, automaton_id)
    examples = project.examples_of(type_name, automaton_id)
    return (
        not automaton.has_state(state_id)
        or any(state_id in (example.source, example.label) for example in examples)
        or any(state_id in (rule.source, rule.target) for rule in automaton.rules)
        or any(state_id == prune.source or state_id in prune.forbidden for prune in automaton.prunes)
    )


@says("Replace the examples of {automaton_id}")
def replace_examples(
    project: Project,
    type_name: str,
    automaton_id: str,
    examples: Collection[Example],
    moments: Mapping[str, Moment],
) -> Project:
    """These examples instead of all that an automaton has, as replaying its demonstrations gives them."""
    automaton = find_automaton(project, type_name, automaton_id)
    numbered = _numbered((), examples)
    _refuse_examples(automaton, numbered)
    project = with_examples(project, type_name, automaton_id, numbered)
    return without_stray_moments(with_moments(project, moments))


@says("Forget the examples of {automaton_id}")
def without_examples(project: Project, type_name: str, automaton_id: str) -> Project:
    """No examples of an automaton any more, e.g. before its demonstrations are played again."""
    return replace_examples(project, type_name, automaton_id, (), {})


# ----------------------------------------------------------------------------------------- by hand


@says("Enable examples of {automaton_id}")
def enable_examples(
    project: Project, type_name: str, automaton_id: str, example_ids: Collection[str]
) -> Project:
    """Learn from these examples again; refused for those of a state that was removed."""
    automaton, wanted = find_automaton(project, type_name, automaton_id), set(example_ids)
    enabled = [e for e in project.examples_of(type_name, automaton_id) if e.id in wanted]
    refuse_states(automaton, dict.fromkeys(chain.from_iterable(map(attrgetter("source", "label"), enabled))))
    return _change_examples(
        project, type_name, automaton_id, example_ids, lambda some: changed(some, enabled=[True] * len(some))
    )


@says("Disable examples of {automaton_id}")
def disable_examples(
    project: Project, type_name: str, automaton_id: str, example_ids: Collection[str]
) -> Project:
    """Keep these examples, but do not learn from them."""
    return _change_examples(
        project, type_name, automaton_id, example_ids, lambda some: changed(some, enabled=[False] * len(some))
    )


@says("Relabel examples of {automaton_id}")
def relabel_examples(
    project: Project, type_name: str, automaton_id: str, example_ids: Collection[str], label: str
) -> Project:
    """Let these examples say "go to *label*"; one that no longer says "stay" is no continuation any more."""
    refuse_states(find_automaton(project, type_name, automaton_id), [label])

    def relabeled(some: Sequence[Example]) -> Sequence[Example]:
        goes_on = [example.continuation and label == example.source for example in some]
        return changed(some, label=repeat(label), continuation=goes_on)

    return _change_examples(project, type_name, automaton_id, example_ids, relabeled)


@says("Weight examples of {automaton_id} by {weight}")
def weight_examples(
    project: Project, type_name: str, automaton_id: str, example_ids: Collection[str], weight: float
) -> Project:
    """Let each of these examples count as much as *weight* examples; above 0."""
    if not (isfinite(weight) and weight > 0.0):
        raise EditError(f"the weight is {weight}; allowed: above 0. To leave an example out, disable it")
    return _change_examples(
        project, type_name, automaton_id, example_ids, lambda some: changed(some, weight=repeat(weight))
    )


@says("Measure features of {automaton_id} again")
def set_values(
    project: Project, type_name: str, automaton_id: str, values: Mapping[str, Mapping[str, float]]
) -> Project:
    """Give examples values of features that were added later: example id -> feature id -> value.

    Values that are not named stay.
    """
    for example_id, row in values.items():
        for feature_id, value in row.items():
            if not isfinite(value):
                raise EditError(
                    f"feature {feature_id!r} of example {example_id!r} is {value}; it must be a finite number"
                )

    def measured(some: Sequence[Example]) -> Sequence[Example]:
        return changed(some, values=[{**example.values, **values[example.id]} for example in some])

    return _change_examples(project, type_name, automaton_id, values, measured)


def _change_examples(
    project: Project,
    type_name: str,
    automaton_id: str,
    example_ids: Collection[str],
    change_them: Callable[[Sequence[Example]], Sequence[Example]],
) -> Project:
    automaton = find_automaton(project, type_name, automaton_id)
    examples = project.examples_of(type_name, automaton_id)
    wanted = set(example_ids)
    chosen = [example for example in examples if example.id in wanted]
    if missing := wanted - {example.id for example in chosen}:
        raise EditError(
            f"{automaton.name} has no example {listed(sorted(missing))}; it has {len(examples)} examples"
        )
    others = iter(change_them(chosen))
    new = tuple(next(others) if example.id in wanted else example for example in examples)
    return with_examples(project, type_name, automaton_id, new) if wanted else project


def _refuse_examples(automaton: Automaton, examples: Iterable[Example]) -> None:
    for example in examples:
        refuse_states(automaton, (example.source, example.label))
        for feature_id, value in example.values.items():
            if not isfinite(value):
                raise EditError(
                    f"feature {feature_id!r} of an example of {automaton.name} is {value}; it must be finite"
                )
