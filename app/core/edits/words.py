"""The sentence that the undo menu shows for each edit."""

import inspect
from collections.abc import Callable
from typing import Any, TypeVar

from ..library import Library
from ..naming import shown_content, shown_state
from ..project import Project

Function = TypeVar("Function", bound=Callable[..., Any])

#: Every edit with its sentence, in which {names} stand for its arguments.
SENTENCES: dict[Callable[..., Any], str] = {}


def says(sentence: str) -> Callable[[Function], Function]:
    """Make a function an edit, told to the user by *sentence*."""

    def register(function: Function) -> Function:
        SENTENCES[function] = sentence
        return function

    return register


def describe(edit: Callable[..., Any], project: Project, *args: Any, **kwargs: Any) -> str:
    """What *edit* with these arguments does to *project*, for the undo menu: "Rename state left of Goto to turn".

    Ids of automata, states and features are shown by their names in *project*.
    """
    given = inspect.signature(edit).bind(project, *args, **kwargs)
    given.apply_defaults()
    return SENTENCES[edit].format_map(_shown(project, given.arguments))


def _shown(project: Project, arguments: dict[str, Any]) -> dict[str, Any]:
    library = project.library(arguments.get("type_name", ""))
    return {name: _word(name, value, arguments, library) for name, value in arguments.items()}


def _word(name: str, value: Any, arguments: dict[str, Any], library: Library) -> Any:
    automaton = library.automata.get(arguments.get("automaton_id", ""))
    match name:
        case "automaton_id":
            return automaton.name if automaton else value
        case "state_id" if automaton:
            return shown_state(automaton, value, library)
        case "feature_id" if automaton:
            return next((use.shown for use in automaton.features if use.id == value), value)
        case "content":
            return shown_content(value, library)
        case "recorded":
            return _pick(value, arguments["project"].library(value.type))
    return value


def _pick(recorded: Any, library: Library) -> str:
    """What was picked in which automaton: "left in Goto"."""
    automaton = library.automata.get(recorded.automaton)
    if automaton is None:
        return str(recorded.goal)
    if recorded.state is not None and recorded.goal == recorded.state.id:
        return f"{recorded.state.name or shown_content(recorded.state.content, library)} in {automaton.name}"
    return f"{shown_state(automaton, recorded.goal, library)} in {automaton.name}"
