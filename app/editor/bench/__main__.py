"""``python -m app.editor.bench GROUP SHRINK FULL PROJECT``: the figures of a group, as JSON on the standard output."""

import json
import sys
from pathlib import Path

from .groups import GROUPS, Order


def main(group: str, shrink: str, full: str, folder: str) -> None:
    """Measure, and print."""
    order = Order(Path(folder), int(shrink), full == "full")
    sys.stdout.write(json.dumps(GROUPS[group](order)) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
