"""``understudy import``: what was exported becomes part of a project."""

from dataclasses import dataclass
from pathlib import Path

from ..core.storage import save
from ..export.importing import Import, bring
from ..export.library_file import read
from .console import nothing_changes, say, show, show_json, show_table
from .exits import DONE
from .opening import Opened, open_project
from .wording import counted

COLUMNS = ("behavior", "in the project")


@dataclass(frozen=True, slots=True)
class Request:
    """What was asked for on the command line."""

    file: Path
    folder: Path
    arm: bool
    dry_run: bool
    trust: bool


def import_into(request: Request, *, as_json: bool) -> int:
    """Bring the file's behaviors into the project, and say what each is called there."""
    source = read(request.file).project
    opened = open_project(request.folder, trust=request.trust)
    with nothing_changes():
        result = bring(opened.project, opened.scenario, source, with_arm=request.arm)
        if not request.dry_run:
            save(result.project, request.folder, opened.project)
    if as_json:
        show_json(document(result))
    else:
        if result.behaviors:
            show_table(COLUMNS, [[f"{b.type}/{b.name}", b.fate] for b in result.behaviors], words=2)
        show(f"\n{_told(opened, result, dry_run=request.dry_run)}")
    if request.arm and not source.arms:
        say(f"{request.file} brings no arm: the parameters of its behavior are open")
    if bare := [brought.known_as for brought in result.added if brought.lacks_examples]:
        say(f"without examples, so that teaching it anew replaces what it learned: {', '.join(bare)}")
    return DONE


def document(result: Import) -> dict[str, object]:
    """The result for programs."""
    return {
        "behaviors": [
            {
                "type": brought.type,
                "name": brought.name,
                "known_as": brought.known_as,
                "is_here": brought.is_here,
                "lacks_examples": brought.lacks_examples,
                "completed": brought.completed,
            }
            for brought in result.behaviors
        ],
        "types": list(result.types),
        "arm": result.arm or None,
    }


def _told(opened: Opened, result: Import, *, dry_run: bool) -> str:
    what = f"{opened.folder}: {counted(len(result.added), 'new behavior')}"
    if result.arm:
        what += f", the arm {result.arm!r}" + (" was there" if result.arm_is_here else "")
    if result.project is opened.project:
        return f"{what}; all of it was here"
    return f"{what}; not kept: without --dry-run it is" if dry_run else f"{what}; kept"
