"""Bringing the files of older schema versions up to date, one version at a time.

A migration takes all JSON documents of a project, by path, and returns them in the form of the next version. It works
on documents that nothing has checked yet. Every version that was ever shipped keeps its migration.
"""

from collections.abc import Callable, Mapping
from typing import Any

#: The form that is written.
SCHEMA_VERSION = 1

VERSION_KEY = "schema_version"
PROJECT_FILE = "project.json"

#: Path relative to the project's folder -> document.
Documents = dict[str, Any]
Migration = Callable[[Documents], Documents]

#: The version that a migration starts from -> the migration. It need not change the version's number.
MIGRATIONS: Mapping[int, Migration] = {}


class VersionError(ValueError):
    """A version that cannot be read; the message says why, and *where* in ``project.json``."""

    def __init__(self, message: str, where: str = VERSION_KEY) -> None:
        super().__init__(message)
        self.where = where


def version_of(documents: Mapping[str, Any]) -> int:
    """The schema version that ``project.json`` states.

    Raises:
        VersionError: It states none.
    """
    project = documents[PROJECT_FILE]
    if not isinstance(project, dict):
        raise VersionError("must be an object with the key 'schema_version'", "")
    if VERSION_KEY not in project:
        raise VersionError(f"the key {VERSION_KEY!r} is missing, so this is no Understudy project", "")
    version = project[VERSION_KEY]
    if not isinstance(version, int) or isinstance(version, bool) or version < 1:
        raise VersionError(f"must be a whole number from 1 to {SCHEMA_VERSION}")
    return version


def migrated(
    documents: Documents, registry: Mapping[int, Migration] | None = None, current: int | None = None
) -> Documents:
    """*documents* in the form of version *current*, by default the one that is written.

    Raises:
        VersionError: The version is newer, no migration leads on from it, or a document is too damaged to migrate.
    """
    registry, current = MIGRATIONS if registry is None else registry, current or SCHEMA_VERSION
    version = version_of(documents)
    refuse_newer(version, current)
    while version < current:
        documents = _step(documents, version, registry)
        version += 1
        documents = {**documents, PROJECT_FILE: {**documents[PROJECT_FILE], VERSION_KEY: version}}
    return documents


def refuse_newer(version: int, current: int = SCHEMA_VERSION) -> None:
    """Raise a `VersionError` where *version* is one that this program does not know yet."""
    if version > current:
        raise VersionError(
            f"the project was written by a newer Understudy: its schema version is {version}, and this one reads "
            f"versions up to {current}; update Understudy to open it"
        )


def _step(documents: Documents, version: int, registry: Mapping[int, Migration]) -> Documents:
    if version not in registry:
        raise VersionError(f"nothing here can bring schema version {version} to version {version + 1}")
    try:
        return registry[version](documents)
    except (LookupError, TypeError, ValueError, AttributeError) as error:
        raise VersionError(
            f"the files cannot be brought from schema version {version} to {version + 1}: "
            f"{type(error).__name__}: {error}"
        ) from error
