"""Parameters that copied states are bound to and that the automaton they have come to lacks, and what can be done about it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from ...core.edits import set_parameters
from ...core.edits.bindings import bindings_of
from ...core.features import Parameter
from ...core.naming import shown_state
from ..message import Kind, Message
from ..selection import BehaviorKey

if TYPE_CHECKING:
    from ..studio import Studio


def lacking(studio: Studio, where: tuple[str, str], states: Iterable[str]) -> dict[str, str]:
    """The parameters that an automaton lacks although some of its *states* are bound to them, with the first such state."""
    automaton = studio.document.automaton(*where)
    if automaton is None:
        return {}
    bound = [
        (binding.name, state)
        for state in states
        if automaton.has_state(state)
        for binding in bindings_of(automaton.state(state).content).values()
        if isinstance(binding, Parameter) and binding.name not in automaton.parameters
    ]
    return dict(reversed(bound))


def need(
    studio: Studio, where: tuple[str, str], states: Iterable[str], said: Iterable[str]
) -> Message | None:
    """What copies need before the automaton can be run and learned, with what else is *said* of them; None if nothing."""
    states = tuple(states)
    found = lacking(studio, where, states)
    automaton = studio.document.automaton(*where)
    if automaton is None or not found:
        return None
    library = studio.document.project.library(where[0])
    names, first = [repr(name) for name in found], next(iter(found.values()))
    it = "it" if len(names) == 1 else "them"
    words = (
        f"{shown_state(automaton, first, library)} is bound to {_parameters(names)}, which {automaton.name} lacks: add {it}, "
        f"or bind the state to something else; {automaton.name} cannot be run or learned before"
    )

    def add() -> None:
        current = studio.document.automaton(*where)
        if current is not None:
            studio.document.attempt(
                set_parameters, *where, (*current.parameters, *lacking(studio, where, states))
            )

    def bind() -> None:
        studio.selection.select_behavior(BehaviorKey(*where), first)
        studio.show_panel.emit("graph")
        studio.actions.refresh_some(["graph.edit"])
        studio.actions["graph.edit"].trigger()

    answers = ((f"Add {' and '.join(names)}", add), ("Bind it…", bind))
    return Message(
        "; ".join([words, *said]), Kind.WARNING, answers, lambda: bool(lacking(studio, where, states))
    )


def _parameters(names: list[str]) -> str:
    return f"the parameter{'s' if len(names) > 1 else ''} {' and '.join(names)}"
