"""Edits of where states stand when their automaton is drawn; what they do does not depend on it."""

from collections.abc import Collection, Mapping
from math import isfinite

from ..errors import EditError
from ..project import Position, Project
from .place import find_automaton, with_layout
from .states import refuse_states
from .words import says

#: Coordinates are kept to this many decimals: a tenth of a pixel is more than a hand can place.
DECIMALS = 1


@says("Move states of {automaton_id}")
def move_states(
    project: Project, type_name: str, automaton_id: str, positions: Mapping[str, Position]
) -> Project:
    """Let states stand where the user put them: centers, in pixels, y downward; the others stay where they are.

    Raises:
        EditError: A state is missing, or a coordinate is not a finite number.
    """
    automaton = find_automaton(project, type_name, automaton_id)
    refuse_states(automaton, positions)
    for state_id, (x, y) in positions.items():
        if not (isfinite(x) and isfinite(y)):
            raise EditError(f"state {state_id!r} cannot stand at ({x}, {y}); give finite numbers")
    placed = {state: (round(x, DECIMALS), round(y, DECIMALS)) for state, (x, y) in positions.items()}
    before = project.layout_of(type_name, automaton_id)
    kept = {state: place for state, place in before.items() if automaton.has_state(state)}
    return with_layout(project, type_name, automaton_id, {**kept, **placed})


@says("Arrange {automaton_id} anew")
def forget_layout(
    project: Project, type_name: str, automaton_id: str, state_ids: Collection[str] | None = None
) -> Project:
    """Leave it to the program again where states stand: these, or all."""
    find_automaton(project, type_name, automaton_id)
    before = project.layout_of(type_name, automaton_id)
    gone = set(before) if state_ids is None else set(state_ids)
    kept = {state: place for state, place in before.items() if state not in gone}
    return with_layout(project, type_name, automaton_id, kept)
