"""Writing a project into its folder: only what changed, all or nothing."""

import contextlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from pydantic import ValidationError

from ..errors import StorageError
from ..examples import Example
from ..project import Project
from ..refusals import reason
from .atomic import WriteError, change_files, clear_unfinished, locked
from .convert import Document, automaton_document
from .convert_project import demonstration_document, examples_document, layout_document, project_document
from .layout import (
    EXAMPLES,
    LAYOUTS,
    LIBRARIES,
    automaton_file,
    demonstration_file,
    documents,
    examples_file,
    folders,
    layout_file,
    moment_file,
    moment_files,
    record_of,
)
from .migrations import PROJECT_FILE, SCHEMA_VERSION, VersionError, refuse_newer, version_of
from .moments import file_of
from .names import folded, type_name_problem
from .problems import FilesError, Problem, of_document
from .text import TextError, parsed, written


def save(project: Project, folder: Path, previous: Project | None = None) -> None:
    """Make *folder* hold *project*. Files whose content would not change are left alone, and so are files of others.

    Args:
        folder: Made if it is missing.
        previous: What the folder is known to hold. Files of what it has and *project* lacks are removed; behaviors,
            examples, moments and demonstrations that both share are not even compared with their files. Without it all
            files are compared, and if the folder holds a project already, that is replaced.

    Raises:
        FilesError: The project holds something that cannot be stored, a newer Understudy wrote the folder, or the
            system refused. Nothing has changed then.
    """
    folder = Path(folder)
    try:
        with _made(folder), locked(folder, for_writing=True):
            clear_unfinished(folders(folder))
            _Saving(folder).save(project, previous)
    except OSError as error:
        raise FilesError(folder, [Problem("", "", f"cannot be written: {reason(error)}")]) from error


@contextlib.contextmanager
def _made(folder: Path) -> Iterator[None]:
    """Makes a folder, and takes that back when what it was made for fails."""
    missing = [above for above in (folder, *folder.parents) if not above.exists()]
    folder.mkdir(parents=True, exist_ok=True)
    try:
        yield
    except BaseException:
        for above in missing:
            with contextlib.suppress(OSError):
                above.rmdir()
        raise


@dataclass(frozen=True, slots=True)
class _File:
    """What one file is made from.

    Attributes:
        content: Makes a document, or the bytes themselves.
        value: Equal values make equal files; None if only the content tells.
    """

    content: Callable[[], Document | bytes]
    value: object = None

    def same(self, other: "_File | None") -> bool:
        """Whether both surely have the same content."""
        if other is None or self.value is None:
            return False
        try:
            return self.value == other.value
        except RecursionError:  # a tree too deep to be compared
            return False


class _Saving:
    """One project while it is written."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._problems: list[Problem] = []

    def save(self, project: Project, previous: Project | None) -> None:
        """Write what changed, and remove what is gone."""
        version = self._version()
        files = _files(project)
        before = _files(previous) if previous is not None else {}
        self._problems += [*_wrong_names(project), *_met_names(files), *_missing_moments(project)]
        known = before if version == SCHEMA_VERSION else {}
        contents = {path: self._content(path, file, known.get(path)) for path, file in files.items()}
        former = before if previous is not None else self._former_files()
        if self._problems:
            raise FilesError(self._folder, self._problems)
        self._change(
            {self._folder / path: data for path, data in contents.items() if data is not None},
            [
                path
                for name in reversed(former)
                if name not in files and (path := self._folder / name).is_file()
            ],
        )

    def _change(self, contents: Mapping[Path, bytes], gone: list[Path]) -> None:
        try:
            change_files(contents, gone)
        except WriteError as error:
            message = f"cannot be written: {reason(error.error)}; nothing has been changed"
            file = error.path.relative_to(self._folder).as_posix()
            raise FilesError(self._folder, [Problem(file.removeprefix("."), "", message)]) from error

    def _version(self) -> int | None:
        """The schema version of the project that the folder holds, if it can be told; a newer one is refused."""
        try:
            version = version_of({PROJECT_FILE: parsed((self._folder / PROJECT_FILE).read_bytes())})
        except (FileNotFoundError, TextError, VersionError):
            return None
        try:
            refuse_newer(version)
        except VersionError as error:
            raise FilesError(self._folder, [Problem(PROJECT_FILE, error.where, str(error))]) from error
        return version

    def _former_files(self) -> list[str]:
        """What the project that the folder holds is made of; nothing where it holds none."""
        if not (self._folder / PROJECT_FILE).is_file():
            return []
        return [*moment_files(self._folder), *documents(self._folder, lambda _path, _error: None)]

    # ------------------------------------------------------------------------------------------------ content

    def _content(self, path: str, file: _File, before: _File | None) -> bytes | None:
        """What is to be written to *path*; None if that is what it holds, or a problem was found."""
        on_disk = self._folder / path
        if file.same(before) and on_disk.is_file():
            return None
        try:
            content = file.content()
        except StorageError as error:
            self._problems.append(Problem(path, "", str(error)))
            return None
        data = content if isinstance(content, bytes) else self._text(path, content)
        return None if data is None or _holds(on_disk, data) else data

    def _text(self, path: str, document: Document) -> bytes | None:
        kind = record_of(path)
        try:
            record = kind.model_validate(document)
            return written(record.model_dump(mode="json", exclude_defaults=True))
        except ValidationError as error:
            self._problems += of_document(path, kind, document, error)
        except TextError as error:
            self._problems.append(Problem(path, error.where, error.message))
        return None


def _holds(path: Path, data: bytes) -> bool:
    try:
        return path.is_file() and path.read_bytes() == data
    except OSError:
        return False


# -------------------------------------------------------------------------------------------------- a project's files


def _files(project: Project) -> dict[str, _File]:
    """All files of *project*, in the order in which they are renamed.

    What is referred to comes first, so that a save that the machine's end interrupts leaves nothing dangling.
    """
    return {
        **_moment_files(project),
        **_automaton_files(project),
        **_examples_files(project),
        **_layout_files(project),
        **_demonstration_files(project),
        PROJECT_FILE: _File(partial(project_document, project, SCHEMA_VERSION)),
    }


def _moment_files(project: Project) -> dict[str, _File]:
    """The moments that examples refer to; no others are kept."""
    names = {example.snapshot for _, _, examples in _example_sets(project) for example in examples}
    return {
        moment_file(name): _File(partial(file_of, project.moments, name), name)
        for name in sorted(names)
        if name in project.moments
    }


def _automaton_files(project: Project) -> dict[str, _File]:
    return {
        automaton_file(type_name, key): _File(partial(automaton_document, automaton), automaton)
        for type_name, library in project.libraries.items()
        for key, automaton in library.automata.items()
    }


def _examples_files(project: Project) -> dict[str, _File]:
    return {
        examples_file(type_name, automaton_id): _File(
            partial(examples_document, automaton_id, examples), examples
        )
        for type_name, automaton_id, examples in _example_sets(project)
        if examples
    }


def _layout_files(project: Project) -> dict[str, _File]:
    return {
        layout_file(type_name, automaton_id): _File(partial(layout_document, automaton_id, layout), layout)
        for type_name, by_id in project.layouts.items()
        for automaton_id, layout in by_id.items()
        if layout
    }


def _demonstration_files(project: Project) -> dict[str, _File]:
    return {
        demonstration_file(known.id): _File(partial(demonstration_document, known), known)
        for known in project.demonstrations
    }


def _example_sets(project: Project) -> Iterator[tuple[str, str, tuple[Example, ...]]]:
    for type_name, by_id in project.examples.items():
        for automaton_id, examples in by_id.items():
            yield type_name, automaton_id, examples


# -------------------------------------------------------------------------------------------------- what is refused


def _wrong_names(project: Project) -> Iterator[Problem]:
    """Names that would lead to wrong files."""
    tops: dict[str, Iterable[str]] = {
        LIBRARIES: project.libraries,
        EXAMPLES: project.examples,
        LAYOUTS: project.layouts,
    }
    for top, names in tops.items():
        for name in names:
            if problem := type_name_problem(name):
                yield Problem(f"{top}/{name}", "", f"a node type cannot be called {name!r}: {problem}")
    for type_name, library in project.libraries.items():
        for key, automaton in library.automata.items():
            if key != automaton.id:
                message = f"the library lists it as {key!r}, but its id is {automaton.id!r}"
                yield Problem(automaton_file(type_name, key), "id", message)


def _met_names(files: Iterable[str]) -> Iterator[Problem]:
    """Names that are one and the same on some file systems."""
    met: dict[str, str] = {}
    for path in dict.fromkeys(part for file in files for part in _path_and_above(file)):
        other = met.setdefault(folded(path), path)
        if other != path:
            yield Problem(path, "", f"its name and that of {other} are the same on systems that ignore case")


def _path_and_above(file: str) -> Iterator[str]:
    steps = file.split("/")
    return ("/".join(steps[:length]) for length in range(1, len(steps) + 1))


def _missing_moments(project: Project) -> Iterator[Problem]:
    for type_name, automaton_id, examples in _example_sets(project):
        for index, example in enumerate(examples):
            if example.snapshot and example.snapshot not in project.moments:
                message = f"the project has no moment with the hash {example.snapshot!r}"
                yield Problem(examples_file(type_name, automaton_id), f"examples[{index}].snapshot", message)
