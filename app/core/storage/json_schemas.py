"""The form of the files as JSON Schemas, for editors and for programs in other languages.

``python -m app.core.storage.json_schemas resources/schemas`` writes them anew after a change to a record.
"""

import sys
from collections.abc import Mapping
from pathlib import Path

from .fields import Record
from .project_schema import DemonstrationRecord, ExamplesRecord, LayoutRecord, ProjectRecord
from .schema import AutomatonRecord
from .text import written

DIALECT = "https://json-schema.org/draft/2020-12/schema"
RECORDS: Mapping[str, type[Record]] = {
    "automaton": AutomatonRecord,
    "demonstration": DemonstrationRecord,
    "examples": ExamplesRecord,
    "layout": LayoutRecord,
    "project": ProjectRecord,
}


def json_schemas() -> dict[str, bytes]:
    """File name -> what it holds."""
    return {
        f"{name}.schema.json": written({"$schema": DIALECT, **record.model_json_schema()})
        for name, record in RECORDS.items()
    }


def write(folder: Path) -> None:
    """Write all of them into *folder*."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in json_schemas().items():
        (folder / name).write_bytes(content)


if __name__ == "__main__":
    write(Path(sys.argv[1]))
