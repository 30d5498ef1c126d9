"""Keeps what the hand does in a lesson as a demonstration of the project, in the steps of the picks themselves."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from itertools import count
from operator import attrgetter
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ...core.automaton import Automaton
from ...core.edits import add_demonstration, remove_demonstration, replace_demonstration
from ...core.errors import EditError
from ...core.examples import Example
from ...core.naming import slug
from ...core.project import Demonstration, Project
from ...engine.snapshots import Demonstrated, Picked, TakenBack

if TYPE_CHECKING:
    from ..studio import Studio
    from .teaching import Teaching

FLAG = "keep_demonstrations"


_Sizes = tuple[tuple[Example, ...], Mapping[str, int]]
_last: list[_Sizes] = []  # thousands of examples are counted once, though many ask


def demonstrations_of(examples: tuple[Example, ...]) -> Mapping[str, int]:
    """How many examples are filed under each name."""
    if not _last or _last[0][0] is not examples:
        _last[:] = [(examples, Counter(map(attrgetter("demonstration"), examples)))]
    return _last[0][1]


def free_name(project: Project, type_name: str, automaton: Automaton) -> str:
    """What the next lesson of an automaton can be filed under: its name, and a number that no other has."""
    used = {
        *demonstrations_of(project.examples_of(type_name, automaton.id)),
        *(demonstration.id for demonstration in project.demonstrations),
    }
    return next(free for n in count(1) if (free := f"{slug(automaton.name)}-{n}") not in used)


class Keeping(QObject):
    """Whether lessons are kept, and why the one that goes on is not.

    Signals:
        changed: One of these is another.
    """

    changed = Signal()

    def __init__(self, studio: Studio, teaching: Teaching) -> None:
        super().__init__()
        self._studio = studio
        self._teaching = teaching
        self._mine: set[str] = set()  # ids that lessons in this window have made
        studio.opened.connect(self._mine.clear)
        studio.bridge.event_came.connect(self._event_came)
        studio.settings.changed.connect(self._setting_changed)

    def _setting_changed(self, name: str) -> None:
        if name == FLAG:
            self.changed.emit()

    @property
    def on(self) -> bool:
        """Whether the user wants lessons to be kept."""
        return self._studio.settings.flag(FLAG, default=True)

    def set_on(self, *, on: bool) -> None:
        """Keep lessons as demonstrations from the next pick on, or do not."""
        self._studio.settings.set_flag(FLAG, on=on)
        self._studio.touch()

    @property
    def is_kept(self) -> bool:
        """Whether what was taught in the lesson so far is in a demonstration."""
        return self._teaching.filed_under in {d.id for d in self._studio.document.project.demonstrations}

    @property
    def obstacle(self) -> str:
        """Why the lesson cannot be kept, or the next one could not be; empty if it can."""
        lesson, key = self._teaching.lesson, self._teaching.key
        if key is None:
            return ""
        known = "" if lesson is None else lesson.obstacle
        return known or self._obstacle(key.type, key.id, self._teaching.filed_under)

    def _obstacle(self, type_name: str, automaton_id: str, filed: str) -> str:
        """What in the project keeps a lesson from being played alone."""
        project = self._studio.document.project
        there = {demonstration.id for demonstration in project.demonstrations}
        if filed in there - self._mine:
            return f"there is a demonstration {filed!r} already. File the lesson under another name"
        sizes = demonstrations_of(project.examples_of(type_name, automaton_id))
        others = sum(size for name, size in sizes.items() if name not in there and name != filed)
        if others:
            were = "example of it is" if others == 1 else "examples of it are"
            return f"{others} {were} from no demonstration, and would be lost when demonstrations are played"
        return ""

    # ------------------------------------------------------------------------------------------- inside

    def _event_came(self, event: object) -> None:
        if isinstance(event, Demonstrated):
            self._take(event)
        if isinstance(event, Demonstrated | Picked | TakenBack):
            self.changed.emit()

    def _take(self, event: Demonstrated) -> None:
        """Bring the project's demonstration up to what was done, as part of the step that the act was."""
        lesson, document = self._teaching.lesson, self._studio.document
        made = event.demonstration
        filed = made.id if made is not None else "" if lesson is None else lesson.plan.demonstration
        keeps = made is not None and self.on and not event.obstacle
        if made is not None and keeps:
            keeps = not self._obstacle(made.type, made.automaton, filed)
        if not keeps and filed not in self._mine:
            return
        try:
            document.amend(lambda project: _kept(project, filed, made if keeps else None))
        except EditError as error:
            self._studio.warn(f"the lesson is not kept as a demonstration: {error}")
            return
        self._mine.add(filed)


def _kept(project: Project, filed: str, made: Demonstration | None) -> Project:
    """*project* with a demonstration as it is now; without it, if there is none."""
    before = next((d for d in project.demonstrations if d.id == filed), None)
    if made == before:
        return project
    if made is None:
        return remove_demonstration(project, filed)
    if before is None:
        return add_demonstration(project, made)[0]
    return replace_demonstration(project, filed, made)
