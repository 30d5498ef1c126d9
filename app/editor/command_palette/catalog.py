"""What the command palette finds, section by section; entries are made only for what is shown."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from PySide6.QtGui import QAction, QKeySequence

from ...core.edits import replace_arm
from ...core.errors import UnderstudyError
from ...core.naming import lowered
from ...core.project import Value
from ..actions import SUBMENUS, ActionRow
from ..forms.parameter_form import said
from ..searching import words_in
from ..selection import BehaviorKey
from .matching import INITIALS, SCATTERED, matching, score
from .other_words import OTHER_WORDS, SETTING_WORDS

if TYPE_CHECKING:
    from ..studio import Studio

#: As many as are shown.
MOST = 60
#: What has only scattered letters of a query scores less than this, and all else more.
FAR_BELOW = (INITIALS + SCATTERED) // 2
#: As many of one kind as are weighed at most: ten thousand agents would keep the user waiting.
MOST_WEIGHED = 600


@dataclass(frozen=True, slots=True)
class Entry:
    """Something that was found.

    Attributes:
        kind: What it is: "action", "behavior", "agent", ...
        text: Its name.
        detail: What else is to be said.
        keys: Its shortcut.
        do: What choosing it does; None while it is not possible.
        asks: What is asked before it is done, with the value that holds; None if nothing is.
    """

    kind: str
    text: str
    detail: str = ""
    keys: str = ""
    do: Callable[[], object] | None = None
    asks: Ask | None = None


@dataclass(frozen=True, slots=True)
class Ask:
    """A value to be typed.

    Attributes:
        prompt: What it is for.
        value: What holds now.
        take: Uses what was typed; returns why that is not possible, or an empty text.
    """

    prompt: str
    value: str
    take: Callable[[str], str]


@dataclass(slots=True)
class Section:
    """Things of one kind.

    Attributes:
        kind: What they are: it is searched as well.
        texts: Their names.
        entry: Makes the entry at a place.
        weight: Added to the score: actions come before one of ten thousand agents.
        others: What else each is found by; empty if that is nothing.
    """

    kind: str
    texts: Sequence[str]
    entry: Callable[[int], Entry]
    weight: int = 0
    others: Sequence[str] = ()
    matched: tuple[str, list[int]] | None = field(default=None, repr=False)
    lowered: tuple[list[str], list[str]] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self.lowered = [lowered(text) for text in self.texts], [lowered(text) for text in self.others]

    def search(self, query: str) -> list[int]:
        """Places of what matches; an earlier search is narrowed down where it can be."""
        before = self.matched
        among = before[1] if before is not None and query.startswith(before[0]) else range(len(self.texts))
        wanted = [word for word in words_in(query) if not self._is_kind(word)]
        found = matching(wanted, *self.lowered, among)
        self.matched = query, found
        return found

    def weighed(self, words: Sequence[str], found: Sequence[int]) -> Iterator[tuple[int, int]]:
        """The scores of places where *words* were found, with these.

        Where there are very many, only the first ones are weighed, and those that are called just that: what is typed
        next leaves fewer.
        """
        if len(found) > MOST_WEIGHED:
            exact = " ".join(words)
            rest = [at for at in found[MOST_WEIGHED:] if self.lowered[0][at] == exact]
            found = [*found[:MOST_WEIGHED], *rest]
        for at in found:
            others = f"{self.others[at]} {self.kind}" if self.others else self.kind
            yield score(words, self.texts[at], others) + self.weight, at

    def _is_kind(self, word: str) -> bool:
        return any(part.startswith(word) for part in self.kind.split())


class Catalog:
    """All that can be found in a studio as it is now."""

    def __init__(self, sections: Sequence[Section]) -> None:
        self.sections = tuple(sections)

    def find(self, query: str, most: int = MOST) -> list[Entry]:
        """The entries that fit best, the best first; scattered letters count only where nothing else is found."""
        query = lowered(query.lstrip())
        words = words_in(query)
        ranked: list[tuple[int, int, int, int]] = []
        for number, section in enumerate(self.sections):
            places = section.search(query)
            if not words:
                ranked += [(section.weight, -number, -at, at) for at in places[:most]]
                continue
            weighed = ((worth, -number, -at, at) for worth, at in section.weighed(words, places))
            ranked += heapq.nlargest(most, weighed)
        best = heapq.nlargest(most, ranked)
        if best and best[0][0] > FAR_BELOW:
            best = [one for one in best if one[0] > FAR_BELOW]
        return [self.sections[-number].entry(at) for _, number, _, at in best]


def catalog_of(studio: Studio, settings: Sequence[Entry] = (), recent: Sequence[Entry] = ()) -> Catalog:
    """What can be found now."""
    return Catalog(
        [
            _actions(studio),
            _fixed("setting", settings, 3, SETTING_WORDS),
            _behaviors(studio),
            _arms(studio),
            _parameters(studio),
            *_nodes(studio),
            _fixed("project", recent, 0, {}),
        ]
    )


def _fixed(kind: str, entries: Sequence[Entry], weight: int, words: Mapping[str, str]) -> Section:
    others = [f"{words.get(entry.text, '')} {entry.detail}" for entry in entries]
    return Section(kind, [entry.text for entry in entries], lambda at: entries[at], weight, others)


def _actions(studio: Studio) -> Section:
    studio.actions.refresh()
    rows = [row for row in studio.actions.rows.values() if row.id != "help.palette"]
    texts = [studio.actions.text_of(row.id) for row in rows]
    keys = [_keys(studio.actions[row.id]) for row in rows]
    others = [
        f"{OTHER_WORDS.get(row.id, '')} {row.text} {_menu(row)} {row.tip} {pressed}"
        for row, pressed in zip(rows, keys, strict=True)
    ]

    def entry(at: int) -> Entry:
        row, action = rows[at], studio.actions[rows[at].id]
        do = action.trigger if action.isEnabled() else None
        where = " · ".join(filter(None, (row.menu, row.tip)))
        detail = where if do is not None else f"not now: {studio.actions.why_not(row.id)}"
        return Entry("action", texts[at], detail, keys[at], do)

    return Section("action", texts, entry, 6, others)


def _keys(action: QAction) -> str:
    return action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)


def _menu(row: ActionRow) -> str:
    return f"{row.menu} {SUBMENUS.get((row.menu, row.group), '')}"


def _behaviors(studio: Studio) -> Section:
    found: list[tuple[str, str, str]] = []
    if studio.is_open:
        for node_type in studio.document.project.types:
            library = studio.document.project.library(node_type.name)
            found += [(a.name, node_type.name, a.id) for a in library.automata.values()]
            basics = studio.document.types.vocabulary(node_type.name).behaviors
            names = {a.name for a in library.automata.values()}
            found += [(name, node_type.name, "") for name in basics if name not in names]

    def entry(at: int) -> Entry:
        name, type_name, automaton = found[at]

        def show() -> None:
            if automaton:
                studio.selection.select_behavior(BehaviorKey(type_name, automaton))
            studio.show_panel.emit("library")

        return Entry("behavior", name, type_name if automaton else f"{type_name} · basic", do=show)

    others = [f"{'automaton' if automaton else 'basic'} {type_name}" for _, type_name, automaton in found]
    return Section("behavior", [name for name, _, _ in found], entry, 5, others)


def _arms(studio: Studio) -> Section:
    arms = studio.document.project.arms if studio.is_open else ()

    def entry(at: int) -> Entry:
        arm = arms[at]
        return Entry("arm", arm.name, arm.note, do=lambda: studio.use_arm(arm.name))

    return Section("arm", [arm.name for arm in arms], entry, 4, [arm.note for arm in arms])


def _parameters(studio: Studio) -> Section:
    arm = studio.arm if studio.is_open else None
    fields = studio.document.scenario.parameter_fields() if arm is not None else {}
    names = list(fields)
    texts = [name.replace("_", " ") for name in names]

    def entry(at: int) -> Entry:
        declared = fields[names[at]]
        value = _value(studio, names[at])
        unit = declared.metadata.get("unit", "")
        detail = f"{said(value)} {unit}".strip() + f" · {declared.metadata.get('doc', '')}"
        prompt = f"{texts[at]} in arm {arm.name}" if arm is not None else texts[at]
        ask = Ask(prompt, str(value), lambda typed: set_parameter(studio, names[at], typed))
        return Entry("parameter", texts[at], detail, asks=ask)

    others = [f"{declared.metadata.get('doc', '')} {name}" for name, declared in fields.items()]
    return Section("parameter", texts, entry, 3, others)


def _value(studio: Studio, name: str) -> Value:
    arm, document = studio.arm, studio.document
    if arm is None:
        return ""
    return document.scenario.settle(document.project.parameters_of(arm))[name]


def set_parameter(studio: Studio, name: str, typed: str) -> str:
    """Give a parameter of the arm that is shown another value, and begin it again; why not, if that is not possible."""
    arm, document = studio.arm, studio.document
    if arm is None:
        return "no arm is shown"
    try:
        default = document.scenario.parameter_fields()[name].default
        value = _typed(typed, default)
        changed = replace(arm, parameters={**arm.parameters, name: value})
        document.scenario.settle(document.project.parameters_of(changed))
        document.do(replace_arm, arm.name, changed)
    except (UnderstudyError, ValueError) as error:
        return str(error)
    studio.use_arm(arm.name)
    return ""


def _typed(text: str, default: object) -> float | int | str | bool:
    """*text* as a value of the same kind as *default*."""
    plain = text.strip()
    if isinstance(default, bool):
        if plain.lower() not in ("true", "false", "yes", "no"):
            raise ValueError(f"it is yes or no, but not {plain!r}")
        return plain.lower() in ("true", "yes")
    if isinstance(default, str):
        return plain
    kind = int if isinstance(default, int) else float
    try:
        return kind(plain)
    except ValueError:
        what = "a whole number" if kind is int else "a number"
        raise ValueError(f"it is {what}, but not {plain!r}") from None


def _nodes(studio: Studio) -> tuple[Section, ...]:
    """Controllers and agents, by what the user calls them and by their ids."""
    if studio.snapshot is None or not studio.is_open:
        return ()
    place = studio.snapshot.place
    agents = len(place.ids) - len(place.agents)
    kinds = ("controller", slice(agents)), ("agent", slice(agents, None))
    return tuple(_nodes_of(studio, kind, place.ids[part], place.names[part]) for kind, part in kinds)


def _nodes_of(studio: Studio, kind: str, ids: Sequence[str], names: Sequence[str]) -> Section:
    def entry(at: int) -> Entry:
        def show() -> None:
            studio.selection.select_nodes((ids[at],))
            studio.show_panel.emit("agents")

        return Entry(kind, names[at], ids[at], do=show)

    return Section(kind, names, entry, others=ids)
