"""One color per behavior, the same everywhere: Okabe-Ito first, then a set that keeps its distance."""

from collections.abc import Iterator, Mapping
from functools import cache

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QColor

from ..core.project import Project
from .palette import BASIC, OKABE_ITO

#: Type name and automaton id; a basic behavior has no id.
Key = tuple[str, str]

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
    for node_type in project.types:
        for automaton in project.library(node_type.name).automata.values():
            yield (node_type.name, automaton.id), automaton.name


def _free(taken: Mapping[str, int]) -> int:
    """The first place that nobody has."""
    used = set(taken.values())
    return next(place for place in range(len(used) + 1) if place not in used)
