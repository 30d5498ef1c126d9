"""From what a user picks to a state: one that the automaton has, or one more."""

from ..automaton import Automaton, Basic, Content, Nested, State
from ..errors import EditError
from ..library import Behavior
from ..project import Project
from ..vocabulary import Vocabulary
from .place import find_automaton, find_state, listed
from .states import add_state


def state_for(
    project: Project, scenario: Vocabulary, type_name: str, automaton_id: str, choice: str | Content
) -> tuple[State, State | None]:
    """The state that a pick means, and the same once more if the automaton lacks it and it is to be added.

    Args:
        choice: A state by id, or what it holds: the first state that holds just this is meant.

    Raises:
        EditError: There is no such state or behavior, a slot is open, or the behavior would make a cycle.
    """
    automaton = find_automaton(project, type_name, automaton_id)
    if isinstance(choice, str):
        return find_state(project, type_name, automaton, choice), None
    for state in automaton.states:
        if state.content == choice:
            return state, None
    if isinstance(choice, Basic | Nested):
        _refuse_bindings(_behavior(project, scenario, type_name, choice), choice, automaton)
    added, state_id = add_state(project, type_name, automaton_id, choice)
    state = find_automaton(added, type_name, automaton_id).state(state_id)
    return state, state


def _behavior(project: Project, scenario: Vocabulary, type_name: str, choice: Basic | Nested) -> Behavior:
    if isinstance(choice, Nested):
        return find_automaton(project, type_name, choice.automaton)
    behaviors = project.types_with(scenario).vocabulary(type_name).behaviors
    if choice.behavior not in behaviors:
        raise EditError(
            f"{type_name!r} has no basic behavior {choice.behavior!r}; there are: {listed(sorted(behaviors))}"
        )
    return behaviors[choice.behavior]


def _refuse_bindings(behavior: Behavior, choice: Basic | Nested, automaton: Automaton) -> None:
    slots, bound = set(behavior.parameters), set(choice.bindings)
    if missing := slots - bound:
        raise EditError(
            f"{min(missing)!r} of {behavior.name} is open: pick a target, or a parameter of {automaton.name}"
        )
    if unknown := bound - slots:
        raise EditError(
            f"{behavior.name} has no parameter {min(unknown)!r}; it has: {listed(behavior.parameters)}"
        )
