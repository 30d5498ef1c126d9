"""Self-contained JSON: one file that ``understudy run FILE.json`` runs, without the project that it came from."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from pydantic import Field, ValidationError

from ..core.examples import Example
from ..core.library import Library
from ..core.project import Project
from ..core.refusals import reason
from ..core.storage import SCHEMA_VERSION, FilesError, Problem
from ..core.storage.atomic import WriteError, change_files
from ..core.storage.convert import automaton_document, automaton_value
from ..core.storage.convert_project import (
    examples_document,
    examples_value,
    project_document,
    project_value,
)
from ..core.storage.problems import of_document
from ..core.storage.project_schema import ExamplesRecord, ProjectRecord
from ..core.storage.schema import AutomatonRecord
from ..core.storage.text import TextError, parsed, written

#: What the first key of such a file says.
FORMAT = "understudy export"
FILE_ENDING = ".json"
#: How there comes to be one.
MAKES_ONE = "`understudy export PROJECT -o FILE.json` makes one"


class ExportRecord(ProjectRecord):
    """The whole file: a project's own record, with the libraries beside it.

    ``examples`` are those of models that are fitted again, or all where they were wanted; ``scenario_code`` is the
    project's own scenario, if it has one.
    """

    format: Literal["understudy export"]
    libraries: dict[str, list[AutomatonRecord]] = Field(default_factory=dict)
    examples: dict[str, list[ExamplesRecord]] = Field(default_factory=dict)
    scenario_code: str = ""


@dataclass(frozen=True, slots=True)
class Exported:
    """What such a file holds.

    Attributes:
        scenario_code: The text of the scenario, where the project brings its own; never run before it is trusted.
    """

    project: Project
    scenario_code: str = ""


def content(exported: Exported) -> bytes:
    """The bytes of the file."""
    project = exported.project
    document = {
        "format": FORMAT,
        **project_document(project, SCHEMA_VERSION),
        "libraries": {
            type_name: [automaton_document(automaton) for automaton in library.automata.values()]
            for type_name, library in project.libraries.items()
        },
        "examples": {
            type_name: [examples_document(automaton_id, examples) for automaton_id, examples in by_id.items()]
            for type_name, by_id in project.examples.items()
        },
        "scenario_code": exported.scenario_code,
    }
    return written(document)


def write(exported: Exported, path: Path) -> None:
    """Write the file, whole or not at all.

    Raises:
        FilesError: It cannot be written there.
    """
    try:
        if not path.parent.is_dir():
            raise FilesError(path, [Problem("", "", f"there is no folder {path.parent}")])
        change_files({path: content(exported)}, ())
    except (OSError, WriteError) as error:
        why = reason(error.error if isinstance(error, WriteError) else error)
        raise FilesError(path, [Problem("", "", f"cannot be written: {why}")]) from error


def names_export(path: Path) -> bool:
    """Whether *path* can only mean such an export, by its name, be it there or not."""
    return path.suffix == FILE_ENDING and path.name != "project.json" and not path.is_dir()


def is_export(path: Path) -> bool:
    """Whether *path* is a file that may be such an export, by its name."""
    return names_export(path) and path.is_file()


def read(path: Path) -> Exported:
    """What the file at *path* holds. Nothing of it is run.

    Raises:
        FilesError: It cannot be read, is damaged, is something else, or was written by a newer Understudy.
    """
    try:
        document = parsed(path.read_bytes())
    except FileNotFoundError as error:
        raise FilesError(path, [Problem("", "", f"there is no such file; {MAKES_ONE}")]) from error
    except OSError as error:
        raise FilesError(path, [Problem("", "", f"cannot be read: {reason(error)}")]) from error
    except TextError as error:
        raise FilesError(path, [Problem("", error.where, error.message)]) from error
    _refuse_other(path, document)
    try:
        record = ExportRecord.model_validate(document)
    except ValidationError as error:
        raise FilesError(path, of_document("", ExportRecord, document, error)) from error
    return Exported(_project(record), record.scenario_code)


def _refuse_other(path: Path, document: object) -> None:
    """Refuse what is no export, or one of a version that is not known here."""
    found = document.get("format") if isinstance(document, Mapping) else None
    if not isinstance(document, Mapping) or found != FORMAT:
        said = "does not" if found is None else f"says {found!r}"
        message = f'this is no export of Understudy: it should say "format": "{FORMAT}", but {said}'
        raise FilesError(path, [Problem("", "", f"{message}; `understudy export PROJECT` makes one")])
    version = document.get("schema_version")
    if isinstance(version, int) and version > SCHEMA_VERSION:
        message = f"written by a newer Understudy: version {version}, known here are up to {SCHEMA_VERSION}"
        raise FilesError(path, [Problem("", "schema_version", message)])


def _project(record: ExportRecord) -> Project:
    libraries = {
        type_name: Library({one.id: automaton_value(one) for one in automata})
        for type_name, automata in record.libraries.items()
    }
    examples: dict[str, dict[str, tuple[Example, ...]]] = {
        type_name: {one.automaton: examples_value(one) for one in sets}
        for type_name, sets in record.examples.items()
    }
    return project_value(record, libraries=libraries, examples=examples)
