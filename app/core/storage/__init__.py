"""Projects on disk: a folder that reads well in git.

``load`` and ``save`` are all that the rest of the program needs. Only this package knows file names and JSON; nothing in
it runs what a project holds. Files are checked for their form alone: whether names resolve and bindings are closed is
for `app.core.check` to say.

The layers, from the disk up: `atomic` (writing all or nothing), `text` (JSON), `moments` (snapshots), `problems` (what
the user reads), `fields` and the schemas (the form of each kind of file), the `convert` modules (records and values), `migrations`,
`layout` (which file holds what), `loading` and `saving`.
"""

from .loading import load
from .migrations import SCHEMA_VERSION
from .moments import moment_hash
from .names import file_name_problem, readable, type_name_problem
from .presence import file_is_there, folder_is_there
from .problems import FilesError, Problem
from .saving import save

__all__ = [
    "SCHEMA_VERSION",
    "FilesError",
    "Problem",
    "file_is_there",
    "file_name_problem",
    "folder_is_there",
    "load",
    "moment_hash",
    "readable",
    "save",
    "type_name_problem",
]
