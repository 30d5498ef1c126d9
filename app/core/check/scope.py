"""What an automaton is checked against: its library, what its type can use, and which flags can be up."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from ..automaton import Automaton
from ..errors import UnderstudyError
from ..features import Over
from ..library import Library, NodeType, Types, raised_flags, statistic_vocabulary
from ..naming import shown_state
from ..project import Project
from ..vocabulary import FINISHED, Vocabulary
from .problem import Problem, Severity, automaton_file


@dataclass(frozen=True, slots=True)
class Scope:
    """One node type of a project.

    Attributes:
        scenario: The vocabulary that the scenario declares, with the features and targets of every level.
        vocabulary: What automata of this type are made from.
        raised: Automaton id -> the flags that the automaton can raise.
        shown: For each kind of statistic, the flags that nodes below can show.
        senses: For each kind of statistic, whether agents are among the nodes that it ranges over.
    """

    type: NodeType
    library: Library
    scenario: Vocabulary
    vocabulary: Vocabulary
    statistics: Vocabulary
    raised: Mapping[str, frozenset[str]]
    shown: Mapping[Over, frozenset[str]]
    senses: Mapping[Over, bool]


def scopes(types: Types, scenario: Vocabulary) -> dict[str, Scope]:
    """A scope for each type, by name. The types must be in order, see `app.core.check.checker.types_of`."""
    raised = {name: _raised(types, name) for name in types.types}
    showing = {name: _shown(types, name, raised[name]) for name in types.types}
    made = {}
    for name, node_type in types.types.items():
        agents = _agent_types(types, name)
        below = {Over.SUBSIDIARIES: frozenset(node_type.subsidiaries), Over.AGENTS: agents}
        made[name] = Scope(
            node_type,
            types.library(name),
            scenario,
            types.vocabulary(name),
            statistic_vocabulary(types),
            raised[name],
            {over: frozenset().union(*(showing[t] for t in names)) for over, names in below.items()},
            {over: any(types.type(t).level == 0 for t in names) for over, names in below.items()},
        )
    return made


def _raised(types: Types, type_name: str) -> dict[str, frozenset[str]]:
    vocabulary = types.vocabulary(type_name)
    automata = types.library(type_name).automata
    return {key: frozenset(raised_flags(automaton, vocabulary)) for key, automaton in automata.items()}


def _shown(types: Types, type_name: str, raised: Mapping[str, frozenset[str]]) -> frozenset[str]:
    """The flags that a node of a type can show to a controller."""
    basics = types.vocabulary(type_name).behaviors.values()
    own = {basic.raises for basic in basics if basic.raises is not None}
    finished = {FINISHED for basic in basics if basic.finishes}
    return frozenset().union(own, finished, *raised.values())


def _agent_types(types: Types, type_name: str) -> frozenset[str]:
    """The types of agents anywhere below nodes of a type."""
    found: set[str] = set()
    for child in types.type(type_name).subsidiaries:
        found |= _agent_types(types, child) if types.type(child).subsidiaries else {child}
    return frozenset(found)


@dataclass(frozen=True, slots=True)
class Subject:
    """One automaton while it is checked."""

    scope: Scope
    automaton: Automaton

    @property
    def file(self) -> str:
        """The automaton's file."""
        return automaton_file(self.scope.type.name, self.automaton.id)

    def state(self, state_id: str) -> str:
        """What the user calls a state."""
        return shown_state(self.automaton, state_id, self.scope.library)

    def error(
        self,
        where: str,
        message: str,
        raises: type[UnderstudyError],
        fix: str | None = None,
        mend: Callable[[Project], Project] | None = None,
    ) -> Problem:
        """Something that keeps the automaton from running."""
        return self._problem(where, message, "error", fix, mend, raises)

    def warning(
        self,
        where: str,
        message: str,
        fix: str | None = None,
        mend: Callable[[Project], Project] | None = None,
    ) -> Problem:
        """Something to look at."""
        return self._problem(where, message, "warning", fix, mend, UnderstudyError)

    def _problem(
        self,
        where: str,
        message: str,
        severity: Severity,
        fix: str | None,
        mend: Callable[[Project], Project] | None,
        raises: type[UnderstudyError],
    ) -> Problem:
        return Problem(self.file, where, message, severity, fix, mend, raises)

    def edit(self, edit: Callable[..., Project], *args: Any, **kwargs: Any) -> Callable[[Project], Project]:
        """*edit* of this automaton with further arguments, to be applied to a project."""
        return partial(_apply, edit, (self.scope.type.name, self.automaton.id, *args), kwargs)


def _apply(
    edit: Callable[..., Project], args: tuple[Any, ...], kwargs: dict[str, Any], project: Project
) -> Project:
    return edit(project, *args, **kwargs)
