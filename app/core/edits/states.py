"""Edits of an automaton's states.

Removing a state takes its rules, prunes and learned models along. Examples that mention it stay, disabled, so that
nothing a user demonstrated is lost, and demonstrations in which it was picked keep what it was, so that they can still
be played; its id is not given out again while these are there.
"""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from ..automaton import START, Automaton, Basic, Content, Nested, Prune, RaiseFlag, Refit, Start, State
from ..errors import EditError
from ..examples import Example
from ..features import Binding
from ..naming import fresh_id, shown_content
from ..project import Demonstration, Project
from .place import change, find_automaton, find_state, listed, moved, with_examples, with_layout
from .recursion import refuse_recursion
from .words import says


@says("Add state {content} to {automaton_id}")
def add_state(
    project: Project, type_name: str, automaton_id: str, content: Content, name: str = "", note: str = ""
) -> tuple[Project, str]:
    """One more state, the last; also returns its id.

    Raises:
        EditError: *content* is Start, or an automaton that is missing or would make a cycle.
    """
    automaton = find_automaton(project, type_name, automaton_id)
    refuse_content(project, type_name, content)
    taken = taken_state_ids(project, type_name, automaton_id)
    state_id = fresh_id(taken, name or _id_of(content, project, type_name), "state")
    states = (*automaton.states, State(state_id, content, name, note))
    project = change(project, type_name, automaton_id, states=states)
    refuse_recursion(project, type_name)
    return project, state_id


def taken_state_ids(project: Project, type_name: str, automaton_id: str) -> frozenset[str]:
    """Ids that a new state may not have: those of states, and those that examples and demonstrations mention."""
    automaton = find_automaton(project, type_name, automaton_id)
    taken = {state.id for state in automaton.states}
    for example in project.examples_of(type_name, automaton_id):
        taken |= {example.source, example.label}
    for demonstration in project.demonstrations:
        if (demonstration.type, demonstration.automaton) == (type_name, automaton_id):
            taken |= {pick.state for pick in demonstration.picks}
    return frozenset(taken)


def _id_of(content: Content, project: Project, type_name: str) -> str:
    plain = replace(content, bindings={}) if isinstance(content, Basic | Nested) else content
    return shown_content(plain, project.library(type_name))


def refuse_content(project: Project, type_name: str, content: Content) -> None:
    """Raise an `EditError` if no state can hold this: Start, a missing automaton, or a flag without a name."""
    match content:
        case Start():
            raise EditError(
                "there is one Start only; a state holds a basic behavior, an automaton, or a flag"
            )
        case Nested(held, _):
            find_automaton(project, type_name, held)
        case RaiseFlag(flag) if not flag.strip():
            raise EditError("a flag needs a name")


@says("Remove state {state_id} from {automaton_id}")
def remove_state(project: Project, type_name: str, automaton_id: str, state_id: str) -> Project:
    """No such state any more, nor its rules, prunes and learned models; examples that mention it are disabled."""
    automaton = find_automaton(project, type_name, automaton_id)
    removed = find_state(project, type_name, automaton, state_id)
    if state_id == START:
        raise EditError(f"Start of {automaton.name} cannot be removed")
    learned = {
        source: model
        for source, model in automaton.learned.items()
        if source != state_id and (isinstance(model, Refit) or state_id not in model.labels)
    }
    project = change(
        project,
        type_name,
        automaton_id,
        states=tuple(state for state in automaton.states if state.id != state_id),
        rules=tuple(rule for rule in automaton.rules if state_id not in (rule.source, rule.target)),
        prunes=_prunes_without(automaton.prunes, state_id),
        cuts=tuple(cut for cut in automaton.cuts if cut.source != state_id),
        learned=learned,
        learned_from=automaton.learned_from if len(learned) == len(automaton.learned) else "",
    )
    examples = project.examples_of(type_name, automaton_id)
    places = {i: at for i, at in project.layout_of(type_name, automaton_id).items() if i != state_id}
    project = with_layout(project, type_name, automaton_id, places)
    project = _remembered(project, type_name, automaton_id, removed)
    return with_examples(project, type_name, automaton_id, tuple(_disabled(e, state_id) for e in examples))


def _remembered(project: Project, type_name: str, automaton_id: str, removed: State) -> Project:
    """*project* whose demonstrations keep what a removed state was, where it was picked."""

    def remembering(demonstration: Demonstration) -> Demonstration:
        where = demonstration.type, demonstration.automaton
        known = removed.id in {state.id for state in demonstration.removed}
        if known or where != (type_name, automaton_id) or not demonstration.mentions(removed.id):
            return demonstration
        return replace(demonstration, removed=(*demonstration.removed, removed))

    demonstrations = tuple(map(remembering, project.demonstrations))
    same = demonstrations == project.demonstrations
    return project if same else replace(project, demonstrations=demonstrations)


def _prunes_without(prunes: Iterable[Prune], state_id: str) -> tuple[Prune, ...]:
    kept = (replace(p, forbidden=p.forbidden - {state_id}) for p in prunes if p.source != state_id)
    return tuple(prune for prune in kept if prune.forbidden)


def _disabled(example: Example, state_id: str) -> Example:
    mentions = state_id in (example.source, example.label)
    return replace(example, enabled=False) if mentions and example.enabled else example


@says("Rename state {state_id} of {automaton_id} to {name}")
def rename_state(project: Project, type_name: str, automaton_id: str, state_id: str, name: str) -> Project:
    """Another name for a state; an empty one shows what the state does."""
    return _change_state(project, type_name, automaton_id, state_id, name=name)


@says("Change the note on state {state_id} of {automaton_id}")
def note_state(project: Project, type_name: str, automaton_id: str, state_id: str, note: str) -> Project:
    """Another note on a state."""
    return _change_state(project, type_name, automaton_id, state_id, note=note)


@says("Bind {slot} of state {state_id} of {automaton_id}")
def bind_state(
    project: Project, type_name: str, automaton_id: str, state_id: str, slot: str, binding: Binding | None
) -> Project:
    """Bind a slot of what a state holds; None leaves it open.

    Raises:
        EditError: The state holds nothing that has slots.
    """
    automaton = find_automaton(project, type_name, automaton_id)
    content = find_state(project, type_name, automaton, state_id).content
    if not isinstance(content, Basic | Nested):
        raise EditError(
            f"state {state_id!r} of {automaton.name} holds no behavior, so nothing of it can be bound"
        )
    bindings = {name: bound for name, bound in content.bindings.items() if name != slot}
    if binding is not None:
        bindings = {**content.bindings, slot: binding}
    return set_content(project, type_name, automaton_id, state_id, replace(content, bindings=bindings))


@says("Let state {state_id} of {automaton_id} hold {content}")
def set_content(
    project: Project, type_name: str, automaton_id: str, state_id: str, content: Content
) -> Project:
    """Let a state hold something else; its transitions and examples stay."""
    if state_id == START:
        raise EditError("Start holds nothing; add a state for the behavior")
    refuse_content(project, type_name, content)
    project = _change_state(project, type_name, automaton_id, state_id, content=content)
    refuse_recursion(project, type_name)
    return project


@says("Move state {state_id} of {automaton_id}")
def move_state(project: Project, type_name: str, automaton_id: str, state_id: str, to: int) -> Project:
    """Put a state at place *to* among the states; Start stays the first."""
    automaton = find_automaton(project, type_name, automaton_id)
    state = find_state(project, type_name, automaton, state_id)
    if state_id == START:
        raise EditError(f"Start of {automaton.name} stays the first state")
    states = moved(automaton.states, automaton.states.index(state), max(1, to))
    return change(project, type_name, automaton_id, states=states)


def _change_state(
    project: Project, type_name: str, automaton_id: str, state_id: str, **fields: Any
) -> Project:
    automaton = find_automaton(project, type_name, automaton_id)
    old = find_state(project, type_name, automaton, state_id)
    new = replace(old, **fields)
    states = tuple(new if state is old else state for state in automaton.states)
    return change(project, type_name, automaton_id, states=states)


def refuse_states(automaton: Automaton, state_ids: Iterable[str]) -> None:
    """Raise an `EditError` that names the first of these that is no state of the automaton."""
    for state_id in state_ids:
        if not automaton.has_state(state_id):
            there = listed(repr(state.id) for state in automaton.states)
            raise EditError(f"{automaton.name} has no state {state_id!r}; there are: {there}")
