"""What the library lists: all behaviors by type and kind, with who uses whom. Values, worked out without Qt.

Rows are values that compare equal where nothing that they show has changed, so whoever lists them updates no others.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from operator import attrgetter

from ...core.automaton import Automaton, Basic, Nested
from ...core.edits.calls import meanings, root_types, starting
from ...core.errors import UnderstudyError
from ...core.examples import Example
from ...core.hierarchy import Hierarchy
from ...core.library import Library, NodeType, Types, raised_flags
from ...core.naming import natural, shown_state
from ...core.project import Arm, Project
from ...core.remembered import Remembered
from ...core.vocabulary import BasicBehavior, Vocabulary


class Kind(StrEnum):
    """Where a behavior comes from."""

    LEARNED = "learned"
    AUTHORED = "authored"
    BASIC = "basic"
    DERIVED = "derived"


@dataclass(frozen=True, slots=True)
class RowKey:
    """A behavior of a type: an automaton by its id, or a basic one by its name."""

    type: str
    id: str = ""
    name: str = ""


@dataclass(frozen=True, slots=True)
class Use:
    """Somebody who uses a behavior, or whom it uses.

    Attributes:
        words: "state 3 of Forage", "arm 'independent'".
        key: The behavior to jump to; None for an arm.
        state: The state of it that is meant, if one is.
    """

    words: str
    key: RowKey | None = None
    state: str = ""


@dataclass(frozen=True, slots=True)
class Row:
    """One behavior.

    Attributes:
        examples, disabled: How many are learned from, and how many are not.
        once: It is pulsed on entry only.
        raises: The flags that it raises.
    """

    key: RowKey
    name: str
    kind: Kind
    parameters: tuple[str, ...] = ()
    examples: int = 0
    disabled: int = 0
    once: bool = False
    raises: tuple[str, ...] = ()
    used_by: tuple[Use, ...] = ()
    uses: tuple[Use, ...] = ()
    doc: str = ""

    @property
    def shown(self) -> str:
        """The name with the parameters: ``Goto(X)``."""
        return f"{self.name}({', '.join(self.parameters)})" if self.parameters else self.name

    @property
    def is_automaton(self) -> bool:
        """Whether it can be opened and changed."""
        return bool(self.key.id)


@dataclass(frozen=True, slots=True)
class Group:
    """The behaviors of one type and kind.

    Attributes:
        current: Whether the type takes part in the arm that is shown.
    """

    type: str
    kind: Kind
    rows: tuple[Row, ...]
    current: bool = True

    @property
    def title(self) -> str:
        """What stands above them: ``AGENT · LEARNED``."""
        return f"{self.type} · {self.kind}".upper()


Used = Mapping[RowKey, tuple[Use, ...]]


class Surveyor:
    """Lists the behaviors of one project after another, working out again only what has changed.

    What a row is made of is shared from one time to the next where it is equal, so that most rows are the very same.
    """

    def __init__(self) -> None:
        self._used: Remembered[str, Used] = Remembered()
        self._users: dict[RowKey, tuple[Use, ...]] = {}
        self._ordered: Remembered[str, list[str]] = Remembered()
        self._rows: Remembered[RowKey, Row] = Remembered()

    def survey(self, project: Project, types: Types, arm: Arm | None) -> tuple[Group, ...]:
        """All groups, those of the arm's types first."""
        held = (part for node_type in project.types for part in _held_parts(project.library(node_type.name)))
        used = self._used.of("", (project.types, project.arms, *held), lambda: self._used_by(project))
        present = types_in(arm, project)
        ordered = sorted(project.types, key=lambda t: (t.name not in present, project.types.index(t)))
        groups = [
            group
            for node_type in ordered
            for group in self._of_type(project, types, node_type, used, current=node_type.name in present)
            if group.rows
        ]
        self._rows.keep([row.key for group in groups for row in group.rows])
        return tuple(groups)

    def _of_type(
        self, project: Project, types: Types, node_type: NodeType, used: Used, *, current: bool
    ) -> Iterator[Group]:
        name, library = node_type.name, project.library(node_type.name)
        vocabulary = _vocabulary(types, name)
        order = self._ordered.of(name, tuple(_held_parts(library)), lambda: from_the_top(library))
        rows = [self._row(project, name, library.automata[held], vocabulary, used) for held in order]
        for kind in (Kind.LEARNED, Kind.AUTHORED):
            yield Group(name, kind, tuple(row for row in rows if row.kind is kind), current)
        kind = Kind.DERIVED if node_type.level else Kind.BASIC
        basics = [self._basic(name, basic, kind, used) for basic in vocabulary.behaviors.values()]
        yield Group(name, kind, tuple(basics), current)

    def _used_by(self, project: Project) -> Used:
        """The users of every behavior; the same values as before where they are equal."""
        before = self._users
        found = {key: tuple(users) for key, users in _used_by(project).items()}
        self._users = {
            key: before[key] if before.get(key) == users else users for key, users in found.items()
        }
        return self._users

    def _row(
        self, project: Project, type_name: str, automaton: Automaton, vocabulary: Vocabulary, used: Used
    ) -> Row:
        key, examples = RowKey(type_name, automaton.id), project.examples_of(type_name, automaton.id)
        library, users = project.library(type_name), used.get(key, ())
        held = tuple(library.automata.get(held) for held in automaton.nested())
        made_of = automaton, examples, vocabulary.behaviors, users, *held
        return self._rows.of(key, made_of, lambda: _row(project, key, automaton, vocabulary, users))

    def _basic(self, type_name: str, basic: BasicBehavior, kind: Kind, used: Used) -> Row:
        key = RowKey(type_name, name=basic.name)
        users = used.get(key, ())
        return self._rows.of(key, (basic, kind, users), lambda: _basic(key, basic, kind, users))


def _vocabulary(types: Types, type_name: str) -> Vocabulary:
    """What a type can use; nothing where the types contradict each other, which the checks tell."""
    try:
        return types.vocabulary(type_name)
    except UnderstudyError:
        return Vocabulary()


def _kind(automaton: Automaton, examples: Sequence[Example]) -> Kind:
    authored = automaton.rules and not automaton.learned and not examples
    return Kind.AUTHORED if authored else Kind.LEARNED


def _row(
    project: Project, key: RowKey, automaton: Automaton, vocabulary: Vocabulary, users: tuple[Use, ...]
) -> Row:
    examples = project.examples_of(key.type, key.id)
    enabled = sum(map(attrgetter("enabled"), examples))
    return Row(
        key,
        automaton.name,
        _kind(automaton, examples),
        automaton.parameters,
        enabled,
        len(examples) - enabled,
        raises=raised_flags(automaton, vocabulary),
        used_by=users,
        uses=tuple(_uses(project, key.type, automaton)),
        doc=automaton.note,
    )


def _basic(key: RowKey, basic: BasicBehavior, kind: Kind, users: tuple[Use, ...]) -> Row:
    raises = (basic.raises,) if basic.raises else ()
    return Row(
        key,
        basic.name,
        kind,
        basic.parameters,
        once=basic.runs_once,
        raises=raises,
        used_by=users,
        doc=basic.doc,
    )


def types_in(arm: Arm | None, project: Project) -> frozenset[str]:
    """The node types that take part in an arm; all without one."""
    if arm is None:
        return frozenset(node_type.name for node_type in project.types)
    if isinstance(arm.hierarchy, Hierarchy):
        below = {t.name: t.subsidiaries for t in project.types}
        found, waiting = set[str](), list(root_types(arm))
        while waiting:
            name = waiting.pop()
            if name not in found:
                found.add(name)
                waiting += below.get(name, ())
        return frozenset(found)
    return frozenset(arm.hierarchy.types)


def _held_parts(library: Library) -> Iterator[object]:
    """All of a library that says who holds whom: not what was learned, which changes far more often."""
    for automaton in library.automata.values():
        yield automaton.id
        yield automaton.name
        yield automaton.states


def from_the_top(library: Library) -> list[str]:
    """The ids of a library's automata, those that hold others before those that they hold; equals by name, numbers as such."""
    depths: dict[str, int] = {}

    def depth(automaton_id: str, above: frozenset[str]) -> int:
        automaton = library.automata.get(automaton_id)
        if automaton is None or automaton_id in above:  # missing, or a cycle, which the checks tell
            return 0
        if automaton_id not in depths:
            inside = above | {automaton_id}
            depths[automaton_id] = 1 + max((depth(held, inside) for held in automaton.nested()), default=0)
        return depths[automaton_id]

    automata = library.automata.values()
    return [a.id for a in sorted(automata, key=lambda a: (-depth(a.id, frozenset()), natural(a.name)))]


# ------------------------------------------------------------------------------------------- who uses whom


def _used_by(project: Project) -> Mapping[RowKey, list[Use]]:
    """The users of every behavior: states, and arms that start with it."""
    found: dict[RowKey, list[Use]] = {}
    for node_type in project.types:
        library = project.library(node_type.name)
        for automaton in library.automata.values():
            for key, state_id in _held(node_type.name, automaton):
                words = f"state {shown_state(automaton, state_id, library)} of {automaton.name}"
                use = Use(words, RowKey(node_type.name, automaton.id), state_id)
                found.setdefault(key, []).append(use)
    # Most names are not directed, and asking who directs one takes long.
    directed = {key.name for key in found if key.name}
    tops = {arm.top for arm in project.arms}
    for node_type in project.types:
        for automaton in project.library(node_type.name).automata.values():
            name = automaton.name
            if name in directed or name in tops:
                own = found.setdefault(RowKey(node_type.name, automaton.id), [])
                own += _by_name(project, node_type.name, name, found)
    return found


def _by_name(project: Project, type_name: str, name: str, found: Mapping[RowKey, list[Use]]) -> Iterator[Use]:
    """The controllers and arms that know an automaton by its name."""
    for above in meanings(project, type_name, name):
        for use in found.get(RowKey(above, name=name), ()):
            yield replace(use, words=f"{use.words} ({above})")
    for arm, _ in starting(project, type_name, name):
        yield Use(f"arm {arm.name!r}")


def _held(type_name: str, automaton: Automaton) -> Iterator[tuple[RowKey, str]]:
    """What the states of an automaton hold, with the states."""
    for state in automaton.states:
        content = state.content
        if isinstance(content, Nested):
            yield RowKey(type_name, content.automaton), state.id
        elif isinstance(content, Basic):
            yield RowKey(type_name, name=content.behavior), state.id


def _uses(project: Project, type_name: str, automaton: Automaton) -> Iterator[Use]:
    """The behaviors that an automaton holds, each once."""
    library = project.library(type_name)
    for key in dict.fromkeys(key for key, _ in _held(type_name, automaton)):
        held = library.automata.get(key.id)
        yield Use(held.name if held else key.name or key.id, key)


def words_of(automaton: Automaton, library: Library) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The names of an automaton's features and states, for searching."""
    features = tuple(use.shown for use in automaton.features)
    return features, tuple(shown_state(automaton, state.id, library) for state in automaton.states[1:])
