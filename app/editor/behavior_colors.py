"""One color per behavior, the same everywhere: Okabe-Ito first, then a set that keeps its distance."""

from collections.abc import Collection, Iterable, Iterator, Mapping
from functools import cache
from itertools import count

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QColor

from ..core.project import Project
from .palette import BASIC, OKABE_ITO

#: Type name and automaton id; a basic behavior has no id.
Key = tuple[str, str]
#: By name, which place a behavior has in the row of colors.
Places = Mapping[str, int]

#: Hues apart by the golden angle fill the circle evenly, however many there are.
_GOLDEN = 0.618033988749895
#: Relative luminance in turn, so that neighbors in hue differ in it, which every eye sees; each stands out from dark
#: grounds and from light ones.
_LUMINANCE = (0.28, 0.15, 0.42)
_SATURATION, _HALVINGS = 0.55, 12


class BehaviorColors(QObject):
    """Who has which color. A behavior keeps its color as long as it lives; those of one name share one.

    Signals:
        changed: Somebody has another color.
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._by_name: dict[str, int] = {}
        self._before: dict[str, int] = {}  # of those that are gone, and may come back by undoing
        self._names: dict[Key, str] = {}

    def begin(self, project: Project, places: Places) -> None:
        """Another project is open, whose behaviors had these *places* when it was saved."""
        self._by_name, self._names = {}, {}
        self._before = dict(places)
        self.use(project)

    def use(self, project: Project) -> None:
        """Give every automaton of *project* a color."""
        names = dict(_names(project))
        if names == self._names:
            return
        there = set(names.values())
        known = self._before | self._by_name
        for key, new in names.items():
            old = self._names.get(key, new)
            if old not in there and old in self._by_name and new not in self._by_name:
                known[new] = self._by_name[old]  # it was renamed
        self._names, self._before = names, known
        self._by_name = _placed(there, names.values(), known)
        self.changed.emit()

    @property
    def places(self) -> Places:
        """Which color each behavior has, by its name, for `begin`."""
        return dict(self._by_name)

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
    return QColor(_of_luminance((0.08 + further * _GOLDEN) % 1.0, _LUMINANCE[further % len(_LUMINANCE)]))


@cache
def _of_luminance(hue: float, wanted: float) -> str:
    """The color of a hue that is as bright to the eye as wanted; equal lightness in HSL is far from that."""
    low, high = 0.0, 1.0
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        if luminance(QColor.fromHslF(hue, _SATURATION, middle)) < wanted:
            low = middle
        else:
            high = middle
    return QColor.fromHslF(hue, _SATURATION, high).name()


def luminance(color: QColor) -> float:
    """Relative luminance as the Web Content Accessibility Guidelines have it, in [0, 1]."""
    parts = [
        part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4
        for part in (color.redF(), color.greenF(), color.blueF())
    ]
    return sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), parts, strict=True))


def _names(project: Project) -> Iterator[tuple[Key, str]]:
    """All automata in an order that does not depend on when they were added."""
    for node_type in project.types:
        for automaton_id, automaton in sorted(project.library(node_type.name).automata.items()):
            yield (node_type.name, automaton_id), automaton.name


def first_places(project: Project) -> Places:
    """What the behaviors of a project get of which nothing is known: the first by their ids get the first colors."""
    names = dict(_names(project)).values()
    return _placed(set(names), names, {})


def _placed(there: Collection[str], names: Iterable[str], known: Places) -> dict[str, int]:
    """The known places of those who are there, and free ones for the others, and for those whose place is taken."""
    places: dict[str, int] = {}
    taken: set[int] = set()
    for name, place in known.items():
        if name in there and place not in taken:
            places[name] = place
            taken.add(place)
    free = (place for place in count() if place not in taken)
    for name in dict.fromkeys(names):
        if name not in places:
            places[name] = next(free)
    return places
