"""How soon a large project is there, and how quick the window stays with it."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from random import Random
from statistics import median
from time import perf_counter

from PySide6.QtCore import Qt

from ...core.edits import (
    disable_examples,
    duplicate_automaton,
    relabel_examples,
    rename_automaton,
    set_note,
    weight_examples,
)
from ...core.library import Library
from ...core.project import Project
from ...core.storage import save
from ...engine.bench.lessons import TYPE, examples_of, taught
from ...engine.scenarios import open_scenario
from ...learner.trainer import apply, learn
from ..examples.model import Column
from ..examples.panel import ExamplesPanel
from ..library.panel import LibraryPanel
from ..selection import BehaviorKey
from .stage import Stage

#: Half of the examples belong to one behavior.
BEHAVIORS, EXAMPLES = 200, 20_000
LARGEST = "b0"
TIMES = 5
Acts = Sequence[Callable[[], object]]


def large(project: Project, behaviors: int = BEHAVIORS, examples: int = EXAMPLES) -> Project:
    """*project* with so many more behaviors, learned from so many examples."""
    template = next(iter(taught(project, 1).library(TYPE).automata.values()))
    most, rest = examples // 2, examples // 2 // max(1, behaviors - 1)
    automata = {f"b{k}": replace(template, id=f"b{k}", name=f"Behavior{k}") for k in range(behaviors)}
    recorded = {name: tuple(examples_of(most if name == LARGEST else max(20, rest))) for name in automata}
    library = project.library(TYPE)
    stale = replace(
        project,
        libraries={**project.libraries, TYPE: Library({**library.automata, **automata})},
        examples={**project.examples, TYPE: {**project.examples.get(TYPE, {}), **recorded}},
    )
    return apply(stale, learn(stale, open_scenario(stale).vocabulary, [(TYPE, name) for name in automata]))


def seconds_to_open(stage: Stage, folder: Path, arm: str = "") -> float:
    """From the wish to open a project until it can be seen, and nothing is left to do."""
    began = perf_counter()
    stage.window.files.open(folder, arm)
    stage.wait(lambda: stage.studio.is_open and stage.studio.snapshot is not None, "open")
    return perf_counter() - began + stage.settle()


def of_large_project(stage: Stage, project: Project, behaviors: int, examples: int) -> tuple[float, float]:
    """Seconds to open it, and the longest that selecting, filtering, sorting or editing takes until it can be seen."""
    folder = stage.home / "large"
    save(large(project, behaviors, examples), folder)
    opened = seconds_to_open(stage, folder)
    stage.wait(lambda: stage.snapshot.engine == "compiled", "compile")
    stage.settle()
    slowest = max(median(times) for times in _times(stage, behaviors))
    return opened, slowest


def _times(stage: Stage, behaviors: int) -> Iterator[list[float]]:
    """Of each kind of act, how long it takes, several times."""
    chance = Random(1)
    names = [f"b{chance.randrange(1, max(2, behaviors))}" for _ in range(TIMES)]
    for acts in (*_looking(stage, names), *_editing(stage, list(dict.fromkeys(names)))):
        yield [stage.seconds_of(act) for act in acts]


def _looking(stage: Stage, names: Sequence[str]) -> Iterator[Acts]:
    """Selecting, filtering, sorting: the largest behavior is shown from the second kind on."""
    table, library = stage.window.docks["examples"].widget(), stage.window.docks["library"].widget()
    assert isinstance(table, ExamplesPanel)
    assert isinstance(library, LibraryPanel)
    show, select = stage.studio.selection.select_behavior, stage.studio.selection.select_nodes
    rising = Qt.SortOrder.AscendingOrder
    yield [partial(show, BehaviorKey(TYPE, name)) for name in names]
    yield [partial(show, BehaviorKey(TYPE, LARGEST))]
    yield [partial(select, (node,)) for node in stage.snapshot.place.agents[:TIMES]]
    yield [partial(library.filter.setText, text) for text in ("b", "be", "behavior1", "wa", "")]
    yield [partial(table.filters.choose, table.filters.label, label) for label in ("forward", "left", None)]
    yield [partial(table.table.sortByColumn, column, rising) for column in (Column.LABEL, Column.ID)]
    yield [
        partial(stage.studio.show_panel.emit, panel)
        for panel in ("plots", "problems", "timeline", "examples")
    ]


def _editing(stage: Stage, names: Sequence[str]) -> Iterator[Acts]:
    """Edits of the largest behavior and of others, one by one and of all its examples at once; and taking them back."""
    studio, where = stage.studio, (TYPE, LARGEST)
    do, table = studio.document.do, stage.window.docks["examples"].widget()
    assert isinstance(table, ExamplesPanel)
    actions, every = studio.actions, [example.id for example in studio.document.project.examples_of(*where)]
    yield [partial(do, disable_examples, *where, [str(k)]) for k in range(TIMES)]
    yield [partial(do, weight_examples, *where, [str(k)], 2.0) for k in range(TIMES)]
    yield [partial(do, rename_automaton, TYPE, name, f"Renamed{name}") for name in names]
    yield [partial(do, duplicate_automaton, TYPE, name) for name in names]
    yield [partial(do, set_note, *where, f"note {k}") for k in range(TIMES)]
    yield [studio.undo] * TIMES
    yield [studio.redo] * TIMES
    yield [table.table.selectAll]
    yield [actions["examples.disable"].trigger, actions["examples.enable"].trigger]
    yield [partial(do, relabel_examples, *where, every, label) for label in ("left", "right")]
    yield [studio.undo] * 2
