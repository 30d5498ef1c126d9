"""Reading a project from its folder. All problems of all files are found before any is reported."""

import stat
from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypeVar

from pydantic import ValidationError

from ..examples import Example
from ..library import Library
from ..project import Positions, Project
from ..refusals import reason
from .atomic import locked
from .convert import automaton_value
from .convert_project import demonstration_value, examples_value, layout_value, project_value
from .fields import Record
from .layout import (
    BY_TYPE,
    demonstration_file,
    documents,
    id_in,
    moment_file,
    record_of,
    type_in,
)
from .migrations import PROJECT_FILE, Documents, VersionError, migrated
from .moments import Moments, hash_of
from .names import type_name_problem
from .problems import FilesError, Problem, of_document
from .project_schema import DemonstrationRecord, ExamplesRecord, LayoutRecord, ProjectRecord
from .schema import AutomatonRecord
from .text import TextError, parsed

R = TypeVar("R", bound=Record)
Records = Mapping[str, Record]

MAKES_ONE = "`understudy new DIR --scenario NAME`, or New project in the window, makes a project"


def load(folder: Path) -> Project:
    """The project that is stored in *folder*. Nothing that it holds is run.

    Libraries and examples come without those that are empty; moments are made from their files' bytes when needed.

    Raises:
        FilesError: It is no project, was written by a newer Understudy, or files are missing or damaged; all problems
            are named.
    """
    folder = Path(folder)
    refuse_no_project(folder)
    try:
        with locked(folder, for_writing=False):
            return _Loading(folder).project()
    except OSError as error:
        raise FilesError(folder, [Problem("", "", f"cannot be read: {reason(error)}")]) from error


def refuse_no_project(folder: Path) -> None:
    """Raise a `FilesError` that says what is missing, unless *folder* holds a project."""
    try:
        is_folder = stat.S_ISDIR(folder.stat().st_mode)
        message = "" if is_folder else _no_folder(folder)
        if is_folder and not (folder / PROJECT_FILE).exists():
            message = f"this is no project: the folder holds no {PROJECT_FILE}; {MAKES_ONE}"
    except FileNotFoundError:
        message = f"there is no such folder; {MAKES_ONE}"
    except OSError as error:
        message = f"cannot be read: {reason(error)}"
    if message:
        raise FilesError(folder, [Problem("", "", message)])


def _no_folder(file: Path) -> str:
    hint = f"name the folder that holds it: {file.parent}" if file.name == PROJECT_FILE else MAKES_ONE
    return f"a project is a folder, but this is a file; {hint}"


class _Loading:
    """One project while it is read."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._problems: list[Problem] = []
        self._paths: list[str] = []

    def project(self) -> Project:
        """The whole project, or all problems."""
        records = self._records(self._current(self._documents()))
        order = self._order_of_demonstrations(records)
        moments = self._moments(records)
        self._refuse()
        return _assembled(records, order, moments)

    def _refuse(self) -> None:
        if self._problems:
            raise FilesError(self._folder, self._problems)

    def _add(self, file: str, where: str, message: str) -> None:
        self._problems.append(Problem(file, where, message))

    # ------------------------------------------------------------------------------------------------- files

    def _documents(self) -> Documents:
        self._paths = [PROJECT_FILE, *documents(self._folder, self._unreadable)]
        found = {path: self._document(path) for path in self._paths}
        return {path: document[0] for path, document in found.items() if document}

    def _document(self, path: str) -> list[Any]:
        """The document at *path*, or nothing if it cannot be read."""
        data = self._bytes(path)
        try:
            return [] if data is None else [parsed(data)]
        except TextError as error:
            self._add(path, error.where, error.message)
            return []

    def _bytes(self, path: str) -> bytes | None:
        try:
            file = self._folder / path
            if file.is_file():
                return file.read_bytes()
            self._add(path, "", "a file is expected, but this is something else")
        except OSError as error:
            self._unreadable(path, error)
        return None

    def _unreadable(self, path: str, error: OSError) -> None:
        self._add(path, "", f"cannot be read: {reason(error)}")

    def _current(self, found: Documents) -> Documents:
        """*found* in the newest form; a project whose version is unknown or newer is looked at no further."""
        if PROJECT_FILE not in found:
            self._refuse()
        try:
            return migrated(found)
        except VersionError as error:
            version_problem = Problem(PROJECT_FILE, error.where, str(error))
            raise FilesError(self._folder, [version_problem, *self._problems]) from error

    # ----------------------------------------------------------------------------------------------- records

    def _records(self, found: Documents) -> Records:
        checked = {path: self._record(path, document) for path, document in found.items()}
        return {path: record for path, record in checked.items() if record is not None}

    def _record(self, path: str, document: object) -> Record | None:
        if message := _misplaced(path):
            self._add(path, "", message)
            return None
        kind = record_of(path)
        try:
            record = kind.model_validate(document)
        except ValidationError as error:
            self._problems += of_document(path, kind, document, error)
            return None
        self._compare_id(path, record)
        return record

    def _compare_id(self, path: str, record: Record) -> None:
        where = "automaton" if isinstance(record, ExamplesRecord | LayoutRecord) else "id"
        found = getattr(record, where, None)
        if found is None or found == id_in(path):
            return
        other = path.rpartition("/")[0] + f"/{found}.json"
        message = f"must be the name of the file, {id_in(path)!r}, but found {found!r}"
        if other in self._paths:
            message = f"{found!r} is the id of two files, this one and {other}; the other is called so"
        self._add(path, where, message)

    def _order_of_demonstrations(self, records: Records) -> list[str]:
        """Files of demonstrations as ``project.json`` lists them; after them those that it does not list."""
        project = records.get(PROJECT_FILE)
        listed = [demonstration_file(name) for name in getattr(project, "demonstrations", ())]
        for index, path in enumerate(listed):
            if path not in self._paths:
                self._add(PROJECT_FILE, f"demonstrations[{index}]", f"the file {path} is missing")
        return [*listed, *(path for path in _of(records, DemonstrationRecord) if path not in listed)]

    # ----------------------------------------------------------------------------------------------- moments

    def _moments(self, records: Records) -> Moments:
        files: dict[str, bytes] = {}
        for name, (path, index) in _needed_moments(records).items():
            file = moment_file(name)
            if not (self._folder / file).exists():
                message = (
                    f'the file {file} is missing; bring it back, or write "" to keep the example without it'
                )
                self._add(path, f"examples[{index}].snapshot", message)
            elif (data := self._bytes(file)) is not None:
                files[name] = data
                self._compare_hash(file, data)
        return Moments(files)

    def _compare_hash(self, file: str, data: bytes) -> None:
        if hash_of(data) != id_in(file):
            message = f"the file is damaged: it should have the hash {id_in(file)}, but has {hash_of(data)}"
            self._add(file, "", f"{message}; bring back a copy of it")


def _misplaced(path: str) -> str:
    """Why no document may lie at *path*; empty if it may."""
    parts = path.split("/")
    if parts[0] not in BY_TYPE:
        return ""
    if len(parts) == 2:
        return f"it belongs into the folder of a node type: {parts[0]}/TYPE/{parts[1]}"
    if problem := type_name_problem(parts[1]):
        return f"a node type cannot be called {parts[1]!r}: {problem}"
    return ""


def _needed_moments(records: Records) -> dict[str, tuple[str, int]]:
    """Each moment that examples refer to, with the first that does: its file and its place there."""
    needed: dict[str, tuple[str, int]] = {}
    for path, record in _of(records, ExamplesRecord).items():
        for index, example in enumerate(record.examples):
            if example.snapshot:
                needed.setdefault(example.snapshot, (path, index))
    return needed


def _of(records: Records, kind: type[R]) -> dict[str, R]:
    return {path: record for path, record in records.items() if isinstance(record, kind)}


# ------------------------------------------------------------------------------------------------------- assembly


def _assembled(records: Records, order: list[str], moments: Moments) -> Project:
    header = records[PROJECT_FILE]
    assert isinstance(header, ProjectRecord)
    demonstrations = _of(records, DemonstrationRecord)
    return project_value(
        header,
        libraries=_libraries(_of(records, AutomatonRecord)),
        examples=_examples(_of(records, ExamplesRecord)),
        moments=moments,
        layouts=_layouts(_of(records, LayoutRecord)),
        demonstrations=tuple(demonstration_value(demonstrations[path]) for path in order),
    )


def _libraries(records: Mapping[str, AutomatonRecord]) -> dict[str, Library]:
    by_type: dict[str, dict[str, Any]] = {}
    for path, record in records.items():
        by_type.setdefault(type_in(path), {})[record.id] = automaton_value(record)
    return {type_name: Library(automata) for type_name, automata in by_type.items()}


def _examples(records: Mapping[str, ExamplesRecord]) -> dict[str, dict[str, tuple[Example, ...]]]:
    by_type: dict[str, dict[str, tuple[Example, ...]]] = {}
    for path, record in records.items():
        if record.examples:
            by_type.setdefault(type_in(path), {})[record.automaton] = examples_value(record)
    return by_type


def _layouts(records: Mapping[str, LayoutRecord]) -> dict[str, dict[str, Positions]]:
    by_type: dict[str, dict[str, Positions]] = {}
    for path, record in records.items():
        if record.states:
            by_type.setdefault(type_in(path), {})[record.automaton] = layout_value(record)
    return by_type
