"""Bringing what was exported into another project.

What the project has already, by the same name and to the same effect, is used; what shares only its name comes under a
new one, also for the controllers and the arm of the file that know it by name. Nothing that was there is changed.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from ..core.automaton import Automaton, Basic, Nested, State
from ..core.edits.place import with_automaton, with_examples
from ..core.errors import EditError, LibraryError, ParameterError, UnderstudyError
from ..core.hierarchy import problems
from ..core.library import NodeType
from ..core.naming import fresh_id, fresh_name
from ..core.project import Arm, Project, Value
from ..core.storage.names import file_name_problem, folded, type_name_problem
from ..core.vocabulary import Vocabulary
from ..sim.scenario import Scenario
from .likeness import Likeness
from .missing import refuse_missing

#: A type's name and an automaton's id.
Key = tuple[str, str]
#: How many behaviors a sentence names; the others are counted.
MOST_NAMED = 3


@dataclass(frozen=True, slots=True)
class Brought:
    """One behavior of the file, and what it is in the project.

    Attributes:
        name: What the file calls it.
        id, known_as: Its id and its name in the project.
        is_here: The project had the same already.
        lacks_examples: It runs what was learned, but the examples of that have stayed behind.
        completed: The project had it without examples, and gets those of the file.
    """

    type: str
    name: str
    id: str
    known_as: str
    is_here: bool = False
    lacks_examples: bool = False
    completed: bool = False

    @property
    def fate(self) -> str:
        """What becomes of it, in words."""
        if self.completed:
            return "here already, without examples: those of the file are added"
        if self.is_here:
            return "here already, the same"
        if self.known_as != self.name:
            return f"new, as {self.known_as}: it would not be the {self.name} that is here"
        return "new"


@dataclass(frozen=True, slots=True)
class Import:
    """What comes of it.

    Attributes:
        project: With all that was brought; the same value if all of it was there.
        behaviors: Those of the file, each after those that it holds, types in the file's order.
        types: Node types that the project lacked.
        arm: What the arm of the file is called in the project; empty where it stayed behind.
        arm_is_here: The project had the very same arm.
    """

    project: Project
    behaviors: tuple[Brought, ...]
    types: tuple[str, ...]
    arm: str = ""
    arm_is_here: bool = False

    @property
    def added(self) -> tuple[Brought, ...]:
        """The behaviors that are new in the project."""
        return tuple(brought for brought in self.behaviors if not brought.is_here)

    @property
    def words(self) -> str:
        """What was brought: "Import Goto 2, Wander and the arm 'one level'"."""
        names = [brought.known_as for brought in self.added]
        names += [f"examples of {brought.known_as}" for brought in self.behaviors if brought.completed]
        more = [f"{len(names) - MOST_NAMED} more"] if len(names) > MOST_NAMED else []
        arm = [f"the arm {self.arm!r}"] if self.arm and not self.arm_is_here else []
        told = [*names[:MOST_NAMED], *more, *arm] or [f"the node type {name!r}" for name in self.types]
        return f"Import {' and '.join([', '.join(told[:-1]), told[-1]] if len(told) > 1 else told)}"


def bring(project: Project, scenario: Scenario, source: Project, *, with_arm: bool = False) -> Import:
    """Bring the behaviors of *source*, which was exported, into *project*.

    Args:
        scenario: Of *project*.
        with_arm: Whether its arm comes along as well, with its hierarchy and its world.

    Returns:
        What the project becomes, and what became of each behavior. Of a file that has several arms, the first counts.

    Raises:
        EditError: The file is damaged, its node types stand elsewhere, or the scenario lacks what it needs.
    """
    _refuse_damaged(source)
    typed = _with_types(project, source)
    bringing = _Bringing(typed, scenario, source)
    brought = tuple(bringing.brought())
    result = bringing.project
    refuse_missing(result, scenario, source, [(b.type, b.id) for b in brought if not b.is_here])
    new_types = tuple(t.name for t in typed.types[len(project.types) :])
    if not with_arm or not source.arms:
        return Import(result, brought, new_types)
    arm = replace(source.arms[0], top=bringing.top(source.arms[0]))
    result, name = _with_arm(result, scenario, source, arm)
    return Import(result, brought, new_types, name, result is bringing.project)


# ---------------------------------------------------------------------------------------------------- the file


def _refuse_damaged(source: Project) -> None:
    """Raise an `EditError` where the file contradicts itself, or could not be stored."""
    types = {node_type.name for node_type in source.types}
    for name in sorted(types | source.libraries.keys()):
        if problem := type_name_problem(name):
            raise EditError(f"the file is damaged: its node type {name!r} cannot name a folder: {problem}")
    for type_name, library in source.libraries.items():
        if type_name not in types:
            raise EditError(f"the file is damaged: it has behaviors of {type_name!r}, but no such node type")
        for reason in _damage(tuple(library.automata.values())):
            raise EditError(f"the file is damaged: {reason}")
        try:
            library.refuse_cycle()
        except LibraryError as error:
            raise EditError(f"the file is damaged: {error}") from error


def _damage(automata: tuple[Automaton, ...]) -> Iterator[str]:
    ids, names = {automaton.id for automaton in automata}, [automaton.name for automaton in automata]
    for automaton in automata:
        if not automaton.name.strip():
            yield f"its behavior {automaton.id!r} has no name"
        if names.count(automaton.name) > 1:
            yield f"two of its behaviors are called {automaton.name!r}"
        yield from (
            f"{automaton.name} holds {held!r}, which is not in it"
            for held in automaton.nested()
            if held not in ids
        )


# ---------------------------------------------------------------------------------------------------- node types


def _with_types(project: Project, source: Project) -> Project:
    """*project* with the node types that it lacks."""
    here = {node_type.name: node_type for node_type in project.types}
    new = [node_type for node_type in source.types if node_type.name not in here]
    for node_type in source.types:
        _refuse_other_level(node_type, here.get(node_type.name))
    for node_type in new:
        if alike := [name for name in here if folded(name) == folded(node_type.name)]:
            raise EditError(
                f"the file has a node type {node_type.name!r}, and the project {alike[0]!r}: rename that first"
            )
    return replace(project, types=(*project.types, *new)) if new else project


def _refuse_other_level(theirs: NodeType, ours: NodeType | None) -> None:
    if ours is not None and ours.level != theirs.level:
        raise EditError(
            f"the node type {theirs.name!r} is of level {theirs.level} in the file, and of level {ours.level} in the "
            "project: rename the project's first"
        )


# ---------------------------------------------------------------------------------------------------- behaviors


class _Bringing:
    """Brings the behaviors of a file into a project, which has all its node types.

    Attributes:
        project: With what has been brought so far.
    """

    def __init__(self, project: Project, scenario: Scenario, source: Project) -> None:
        self.project = project
        self._source = source
        self._likeness = Likeness(project, source, scenario.vocabulary)
        self._names = self._new_names(scenario.vocabulary)

    def _new_names(self, vocabulary: Vocabulary) -> Mapping[str, str]:
        """What those behaviors of the file are called here whose names mean something else."""
        taken = set(vocabulary.behaviors)
        for project in (self.project, self._source):
            taken |= {a.name for library in project.libraries.values() for a in library.automata.values()}
        names: dict[str, str] = {}
        for name in sorted(self._likeness.taken):
            names[name] = fresh_name(taken, name)
            taken.add(names[name])
        return names

    def brought(self) -> Iterator[Brought]:
        """Bring all of them, each after those that it holds."""
        for node_type in self._source.types:
            ids: dict[str, str] = {}
            for automaton in self._source.library(node_type.name).bottom_up():
                brought = self._one(node_type.name, automaton, ids)
                ids[automaton.id] = brought.id
                yield brought

    def _one(self, type_name: str, automaton: Automaton, ids: Mapping[str, str]) -> Brought:
        here = self.project.library(type_name).by_name(automaton.name)
        if here is not None and automaton.name not in self._names:
            completed = self._likeness.completes(type_name, automaton)
            if completed:
                self._complete(type_name, here, automaton, ids)
            return Brought(type_name, here.name, here.id, here.name, is_here=True, completed=completed)
        name = self._names.get(automaton.name, automaton.name)
        new_id = self._free_id(type_name, automaton.id, name)
        states = tuple(self._state(type_name, state, ids) for state in automaton.states)
        new = replace(automaton, id=new_id, name=name, states=states)
        examples = self._source.examples_of(type_name, automaton.id)
        project = with_automaton(self.project, type_name, new)
        self.project = with_examples(project, type_name, new_id, examples)
        lacks = bool(automaton.learned) and not examples
        return Brought(type_name, automaton.name, new_id, name, lacks_examples=lacks)

    def _complete(
        self, type_name: str, here: Automaton, automaton: Automaton, ids: Mapping[str, str]
    ) -> None:
        """Add examples to a behavior that had none, and the states that only they speak of."""
        states = tuple(
            here.state(state.id) if here.has_state(state.id) else self._state(type_name, state, ids)
            for state in automaton.states
        )
        whole = replace(here, states=states, learned_from=automaton.learned_from)
        examples = self._source.examples_of(type_name, automaton.id)
        self.project = with_examples(
            with_automaton(self.project, type_name, whole), type_name, here.id, examples
        )

    def _free_id(self, type_name: str, wanted: str, name: str) -> str:
        """The id of the file where it is free, since others would know it by that."""
        taken = self.project.library(type_name).automata
        if file_name_problem(wanted) or folded(wanted) in map(folded, taken):
            return fresh_id(taken, name, "behavior")
        return wanted

    def _state(self, type_name: str, state: State, ids: Mapping[str, str]) -> State:
        match state.content:
            case Nested(automaton, bindings):
                return replace(state, content=Nested(ids[automaton], bindings))
            case Basic(behavior, bindings) if self._likeness.directs(type_name, behavior):
                return replace(state, content=Basic(self._names.get(behavior, behavior), bindings))
        return state

    def top(self, arm: Arm) -> str:
        """What the roots of the file's arm start with, by its name here."""
        return self._names.get(arm.top, arm.top)


# ---------------------------------------------------------------------------------------------------------- the arm


def _with_arm(project: Project, scenario: Scenario, source: Project, arm: Arm) -> tuple[Project, str]:
    """*project* with the arm, in a world like that of the file; also returns the name that it has."""
    wanted = _settled(scenario, source.parameters_of(source.arms[0]), arm)
    base = _settled(scenario, project.worlds.get("", {}), arm)
    parameters = {name: value for name, value in wanted.items() if base[name] != value}
    arm = replace(arm, world="", parameters=parameters)
    for there in project.arms:
        alike = replace(there, world="", parameters=parameters, note=arm.note) == arm
        if alike and _is_in(project, scenario, there, wanted):
            return project, there.name
    arm = replace(arm, name=fresh_name({there.name for there in project.arms}, arm.name))
    return _checked(replace(project, arms=(*project.arms, arm)), arm), arm.name


def _settled(scenario: Scenario, given: Mapping[str, Value], arm: Arm) -> Mapping[str, Value]:
    """All parameters of a world that *arm* needs."""
    try:
        return scenario.settle(given)
    except ParameterError as error:
        raise EditError(f"the arm {arm.name!r} cannot come along: {error}; leave it out") from error


def _is_in(project: Project, scenario: Scenario, arm: Arm, parameters: Mapping[str, Value]) -> bool:
    """Whether an arm of the project is in a world with these parameters; one that cannot be made is in none."""
    try:
        return scenario.settle(project.parameters_of(arm)) == parameters
    except UnderstudyError:
        return False


def _checked(project: Project, arm: Arm) -> Project:
    """*project*, whose node types may stand below each other as they do in *arm*."""
    for node, problem in problems(arm.forest(), {node_type.name: node_type for node_type in project.types}):
        raise EditError(f"the arm {arm.name!r} cannot come along: node {node!r}: {problem}; leave it out")
    return project
