"""``understudy export``: one self-contained file out of a project."""

import sys
from dataclasses import dataclass
from pathlib import Path

from ..core.check import refuse
from ..core.errors import LibraryError, ParameterError
from ..core.project import Project
from ..engine.scenarios import OWN_CODE, brings_code
from ..export.bundle import bundle_of_arm, bundle_of_behavior
from ..export.library_file import Exported, content, write
from .console import PROGRAM, say, show_json, writing
from .exits import DONE
from .naming import named_behaviors
from .opening import Opened, open_project
from .run import chosen_arm
from .staleness import warn_of_stale
from .wording import counted, unknown

FORMATS = ("json",)


@dataclass(frozen=True, slots=True)
class Request:
    """What was asked for on the command line."""

    folder: Path
    behavior: str | None
    arm: str | None
    form: str
    out: Path | None
    trust: bool
    examples: bool = False


def export_project(request: Request, *, as_json: bool) -> int:
    """Export, and say what went where."""
    _refuse(request, as_json=as_json)
    opened = open_project(request.folder, trust=request.trust)
    warn_of_stale(opened)
    bundle = bundled(request, opened)
    if bundle.arms:
        refuse(bundle, opened.scenario.vocabulary, bundle.arms[0].name)
    exported = Exported(bundle, scenario_code(opened))
    if request.out is None:
        with writing():
            sys.stdout.buffer.write(content(exported))
            sys.stdout.buffer.flush()
        return DONE
    write(exported, request.out)
    if as_json:
        show_json(document(bundle, request.out))
    else:
        say(_told(bundle, request.out))
    return DONE


def _refuse(request: Request, *, as_json: bool) -> None:
    """Raise an error if the request contradicts itself, before any work is done."""
    if request.form not in FORMATS:
        raise ParameterError(unknown("format", request.form, FORMATS))
    if request.behavior is not None and request.arm is not None:
        raise ParameterError("name a behavior or an arm, not both")
    if as_json and request.out is None:
        raise ParameterError("--json says what was written where, so it needs -o FILE")


def bundled(request: Request, opened: Opened) -> Project:
    """What is to leave the project."""
    project, scenario, examples = opened.project, opened.scenario, request.examples
    if request.behavior is None:
        arm = chosen_arm(project, request.arm)
        return bundle_of_arm(project, scenario, arm.name, examples=examples)
    found = named_behaviors(project, [request.behavior])
    if len(found) > 1:
        there = ", ".join(f"{type_name}/{request.behavior}" for type_name, _ in found)
        raise LibraryError(f"several types have a behavior {request.behavior!r}; name one of: {there}")
    return bundle_of_behavior(project, scenario, *found[0], examples=examples)


def scenario_code(opened: Opened) -> str:
    """The text of the project's own scenario; empty if it uses one that ships."""
    if not brings_code(opened.project):
        return ""
    return (opened.folder / OWN_CODE).read_text(encoding="utf-8")


def document(bundle: Project, path: Path) -> dict[str, object]:
    """The result for programs."""
    return {
        "file": str(path),
        "arm": bundle.arms[0].name if bundle.arms else None,
        "behaviors": [
            f"{type_name}/{automaton.name}"
            for type_name, library in bundle.libraries.items()
            for automaton in library.automata.values()
        ],
    }


def _told(bundle: Project, path: Path) -> str:
    count = sum(len(library.automata) for library in bundle.libraries.values())
    what = f"{path}: {counted(count, 'behavior')}"
    if bundle.arms:
        return f"{what} and the arm {bundle.arms[0].name!r}; {PROGRAM} run {path} runs it"
    return f"{what}; its parameters are open, so nothing runs it by itself"
