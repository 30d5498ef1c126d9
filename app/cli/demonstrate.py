"""``understudy demonstrate``: play a project's demonstrations again, and keep or compare what they record."""

import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ..core.errors import ExampleError
from ..core.project import Demonstration, Project
from ..core.storage import save
from ..engine.demonstrations import recreate
from .console import nothing_changes, progress, show, show_json
from .exits import DONE, FELL_SHORT
from .naming import Where, named_behaviors
from .opening import Opened, open_project
from .wording import counted

#: What of a project's folder a demonstration can change; layouts, experiments and other files are not ours to compare.
COMPARED = ("project.json", "libraries", "examples", "demonstrations")

#: As many as a user reads; --json names them all.
MOST_LISTED = 20


def demonstrate_project(
    folder: Path, words: Sequence[str], *, only_check: bool, trust: bool, as_json: bool
) -> int:
    """Play demonstrations, and save what they record or say where it differs from what is stored."""
    opened = open_project(folder, trust=trust)
    demonstrated = {(d.type, d.automaton) for d in opened.project.demonstrations}
    only = named_behaviors(opened.project, words, demonstrated) if words else None
    played = chosen(opened.project, only)
    project = play(opened, only)
    differing = differences(project, folder) if only_check else ()
    if not only_check:
        save(project, folder, opened.project)
    if as_json:
        show_json(document(project, played, differing))
    else:
        for line in lines(project, played, differing, only_check=only_check):
            show(line)
    return FELL_SHORT if differing else DONE


def chosen(project: Project, only: Sequence[Where] | None) -> list[Demonstration]:
    """The demonstrations of the behaviors asked for.

    Raises:
        ExampleError: There are none, or a behavior that was asked for has none.
    """
    found = [d for d in project.demonstrations if only is None or (d.type, d.automaton) in only]
    if not found and only is None:
        raise ExampleError(f"project {project.name!r} has no demonstrations to play")
    shown = {(d.type, d.automaton) for d in found}
    for where in only or ():
        if where not in shown:
            name = project.library(where[0]).get(where[1]).name
            raise ExampleError(f"{where[0]}/{name} has no demonstrations to play")
    return found


def play(opened: Opened, only: Sequence[Where] | None = None) -> Project:
    """The project with its examples recorded and its behaviors learned anew, while the user sees how far that is."""
    with nothing_changes(), progress("Playing demonstrations", 1.0) as advance:
        return recreate(opened.project, opened.scenario, only, lambda done, _: advance(done))


def differences(project: Project, folder: Path) -> tuple[str, ...]:
    """The files of *folder* that would come out different if *project* were saved there, byte for byte."""
    with tempfile.TemporaryDirectory() as place:
        fresh = Path(place) / "project"
        save(project, fresh)
        files = sorted(_files(folder) | _files(fresh))
        return tuple(file for file in files if _content(folder / file) != _content(fresh / file))


def _files(folder: Path) -> set[str]:
    """All that is compared in a folder, as paths with ``/``."""
    found = [
        file for top in COMPARED for file in ([folder / top] if "." in top else (folder / top).rglob("*"))
    ]
    files = (file.relative_to(folder) for file in found if file.is_file())
    return {file.as_posix() for file in files if not any(part.startswith(".") for part in file.parts)}


def _content(file: Path) -> bytes | None:
    return file.read_bytes() if file.is_file() else None


# ------------------------------------------------------------------------------------------------------- shaping


def behaviors_of(project: Project, played: Sequence[Demonstration]) -> list[dict[str, Any]]:
    """What was taught: each behavior with its number of demonstrations and examples."""
    counts: dict[Where, int] = {}
    for demonstration in played:
        where = demonstration.type, demonstration.automaton
        counts[where] = counts.get(where, 0) + 1
    return [
        {
            "name": project.library(type_name).get(automaton).name,
            "type": type_name,
            "demonstrations": count,
            "examples": len(project.examples_of(type_name, automaton)),
        }
        for (type_name, automaton), count in counts.items()
    ]


def document(project: Project, played: Sequence[Demonstration], differing: Sequence[str]) -> dict[str, Any]:
    """The result for programs."""
    return {
        "project": project.name,
        "behaviors": behaviors_of(project, played),
        "same": not differing,
        "differing": list(differing),
    }


def lines(
    project: Project, played: Sequence[Demonstration], differing: Sequence[str], *, only_check: bool
) -> list[str]:
    """The result for people."""
    taught = behaviors_of(project, played)
    said = [
        f"{b['type']}/{b['name']}: {counted(b['demonstrations'], 'demonstration')}, {counted(b['examples'], 'example')}"
        for b in taught
    ]
    total = (
        f"{counted(len(played), 'demonstration')}, {counted(sum(b['examples'] for b in taught), 'example')}"
    )
    if not only_check:
        return [*said, f"{total}; kept"]
    verdict = (
        "all files come out the same" if not differing else f"{counted(len(differing), 'file')} would differ:"
    )
    listed = [f"  {file}" for file in differing[:MOST_LISTED]]
    if len(differing) > MOST_LISTED:
        listed.append(f"  and {len(differing) - MOST_LISTED} more")
    return [*said, f"{total}; {verdict}", *listed]
