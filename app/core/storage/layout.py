"""Which file of a project's folder holds what. Paths are relative to the folder, with ``/``."""

from collections.abc import Callable, Iterator
from pathlib import Path, PurePosixPath

from .fields import Record
from .migrations import PROJECT_FILE
from .moments import DIGITS
from .names import MOMENTS
from .project_schema import DemonstrationRecord, ExamplesRecord, LayoutRecord, ProjectRecord
from .schema import AutomatonRecord

LIBRARIES, EXAMPLES, LAYOUTS, DEMONSTRATIONS = "libraries", "examples", "layouts", "demonstrations"
#: Folders that have a folder for each node type.
BY_TYPE = (LIBRARIES, EXAMPLES, LAYOUTS)
MOMENT_FILES = f"{EXAMPLES}/{MOMENTS}"
#: What each folder's documents are.
RECORDS: dict[str, type[Record]] = {
    PROJECT_FILE: ProjectRecord,
    LIBRARIES: AutomatonRecord,
    EXAMPLES: ExamplesRecord,
    LAYOUTS: LayoutRecord,
    DEMONSTRATIONS: DemonstrationRecord,
}


def automaton_file(type_name: str, automaton_id: str) -> str:
    """Holds one automaton."""
    return f"{LIBRARIES}/{type_name}/{automaton_id}.json"


def examples_file(type_name: str, automaton_id: str) -> str:
    """Holds the examples of one automaton."""
    return f"{EXAMPLES}/{type_name}/{automaton_id}.json"


def layout_file(type_name: str, automaton_id: str) -> str:
    """Holds where the user put states of one automaton."""
    return f"{LAYOUTS}/{type_name}/{automaton_id}.json"


def demonstration_file(demonstration_id: str) -> str:
    """Holds one demonstration."""
    return f"{DEMONSTRATIONS}/{demonstration_id}.json"


def moment_file(name: str) -> str:
    """Holds the moment with this hash."""
    return f"{MOMENT_FILES}/{name}.npz"


def record_of(path: str) -> type[Record]:
    """The kind of record that the document at *path* is."""
    return RECORDS[path.split("/", maxsplit=1)[0]]


def id_in(path: str) -> str:
    """The id of what the file at *path* holds: its name without the ending."""
    return PurePosixPath(path).stem


def type_in(path: str) -> str:
    """The node type whose file this is."""
    return path.split("/")[1]


#: Told of a folder that cannot be listed.
Unlistable = Callable[[str, OSError], None]


def documents(folder: Path, unlistable: Unlistable) -> Iterator[str]:
    """All JSON documents that make up the project in *folder*, besides ``project.json``.

    Hidden files and files with other endings are not ours. A document that lies directly in ``libraries``,
    ``examples`` or ``layouts`` is given too: it belongs to no type, and whoever put it there should hear of it.
    """
    for top in BY_TYPE:
        for name in _names(folder, top, unlistable):
            path = f"{top}/{name}"
            if path != MOMENT_FILES and (folder / path).is_dir():
                yield from _json(path, _names(folder, path, unlistable))
            else:
                yield from _json(top, [name])
    yield from _json(DEMONSTRATIONS, _names(folder, DEMONSTRATIONS, unlistable))


def moment_files(folder: Path) -> Iterator[str]:
    """The stored moments in *folder*, needed or not."""
    for name in _names(folder, MOMENT_FILES, lambda _path, _error: None):
        stem, _, ending = name.partition(".")
        if ending == "npz" and len(stem) == DIGITS and set(stem) <= set("0123456789abcdef"):
            yield f"{MOMENT_FILES}/{name}"


def folders(folder: Path) -> list[Path]:
    """All folders that files of a project lie in."""
    by_type = [folder / top for top in BY_TYPE]
    return [
        folder,
        *by_type,
        folder / DEMONSTRATIONS,
        *(inner for top in by_type if top.is_dir() for inner in top.iterdir() if inner.is_dir()),
    ]


def _names(folder: Path, path: str, unlistable: Unlistable) -> list[str]:
    try:
        return sorted(entry.name for entry in (folder / path).iterdir() if not entry.name.startswith("."))
    except FileNotFoundError:
        return []
    except OSError as error:
        unlistable(path, error)
        return []


def _json(path: str, names: list[str]) -> Iterator[str]:
    return (f"{path}/{name}" for name in names if name.endswith(".json"))
