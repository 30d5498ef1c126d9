"""One color per behavior, the same everywhere: Okabe-Ito first, then a set that keeps its distance."""

from collections.abc import Iterator, Mapping

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QColor

from ..core.project import Project
from .palette import BASIC, OKABE_ITO

#: Type name and automaton id; a basic behavior has no id.
Key = tuple[str, str]

#: Hues apart by the golden angle fill the circle evenly, however many there are.
_GOLDEN = 0.618033988749895
#: Lightness in turn, so that neighbors in hue differ in lightness, which every eye sees.
_LIGHTNESS = (0.62, 0.42, 0.75)


class BehaviorColors(QObject):
    """Who has which color. A behavior keeps its color as long as it lives; those of one name share one.

    Signals:
        changed: Somebody has another color.
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._by_name: dict[str, int] = {}
        self._names: dict[Key, str] = {}

    def use(self, project: Project) -> None:
        """Give every automaton of *project* a color."""
        names = dict(_names(project))
        if names == self._names:
            return
        renamed = {self._names[key]: new for key, new in names.items() if key in self._names}
        for old, new in renamed.items():
            if new not in self._by_name and old not in names.values():
                self._by_name[new] = self._by_name[old]
        self._names = names
        kept = {name: place for name, place in self._by_name.items() if name in set(names.values())}
        for name in dict.fromkeys(names.values()):
            if name not in kept:
                kept[name] = _free(kept)
        self._by_name = kept
        self.changed.emit()

    @property
    def count(self) -> int:
        """The first place from which on `nth_color` gives colors that no automaton has."""
        return max(self._by_name.values(), default=-1) + 1

    def color(self, type_name: str, automaton_id: str) -> QColor:
        """The color of an automaton; grey for a basic behavior."""
        name = self._names.get((type_name, automaton_id))
        return QColor(BASIC) if name is None else nth_color(self._by_name[name])

    def of_name(self, name: str) -> QColor:
        """The color of the automata called *name*; grey if there are none."""
        place = self._by_name.get(name)
        return QColor(BASIC) if place is None else nth_color(place)


def nth_color(place: int) -> QColor:
    """The color of place *place*: those of Okabe and Ito, then generated ones."""
    if place < len(OKABE_ITO):
        return QColor(OKABE_ITO[place])
    further = place - len(OKABE_ITO)
    return QColor.fromHslF((0.08 + further * _GOLDEN) % 1.0, 0.55, _LIGHTNESS[further % len(_LIGHTNESS)])


def _names(project: Project) -> Iterator[tuple[Key, str]]:
    for node_type in project.types:
        for automaton in project.library(node_type.name).automata.values():
            yield (node_type.name, automaton.id), automaton.name


def _free(taken: Mapping[str, int]) -> int:
    """The first place that nobody has."""
    used = set(taken.values())
    return next(place for place in range(len(used) + 1) if place not in used)
