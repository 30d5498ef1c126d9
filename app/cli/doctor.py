"""``understudy doctor``: what is installed, what is missing, and the command that mends it."""

import platform
import shlex
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from enum import StrEnum
from pathlib import Path
from typing import Any

import platformdirs

from .. import __version__
from ..engine.cores import cores
from . import probes
from .console import PROGRAM, progress, show, show_json, show_table
from .exits import DONE, FELL_SHORT
from .places import CLONE, ROOT, display

SUPPORTED = ((3, 11), (3, 14))
#: What pictures are drawn with, and what the studio's window needs on top.
DRAWING = ("Qt/lib/libQt6Gui.so.6", "Qt/plugins/platforms/libqoffscreen.so")
WINDOWS = (
    "Qt/lib/libQt6Widgets.so.6",
    "Qt/plugins/platforms/libqxcb.so",
    "Qt/plugins/platforms/libqwayland.so",
)


class State(StrEnum):
    """What is to be thought of a finding: ``note`` is worth knowing, ``missing`` is needed."""

    OK = "ok"
    NOTE = "note"
    MISSING = "missing"


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that was looked at.

    Attributes:
        mend: The command, or the advice, that mends it.
    """

    name: str
    found: str
    state: State = State.OK
    mend: str = ""


def examine(*, as_json: bool) -> int:
    """Look at everything, print it, and exit with 1 if something needed is missing."""
    looks = (_itself, _packages, _qt, _libraries, _graphviz, _machine)
    findings: list[Finding] = []
    with progress("Looking", len(looks)) as advance:
        for done, look in enumerate(looks, 1):
            findings += look()
            advance(done)
    if as_json:
        show_json(document(findings))
    else:
        _show(findings)
    return FELL_SHORT if any(f.state is State.MISSING for f in findings) else DONE


def document(findings: Sequence[Finding]) -> dict[str, Any]:
    """The findings for programs."""
    return {
        "ok": all(finding.state is not State.MISSING for finding in findings),
        "findings": [asdict(finding) for finding in findings],
    }


def _show(findings: Sequence[Finding]) -> None:
    marks = {State.OK: "ok", State.NOTE: "note", State.MISSING: "MISSING"}
    show_table(("", "what", "found"), [(marks[f.state], f.name, f.found) for f in findings], words=3)
    for finding in findings:
        if finding.mend:
            show(f"{finding.name}:\n    {finding.mend}")


# -------------------------------------------------------------------------------------------------------- looking


def _itself() -> Iterable[Finding]:
    yield Finding(PROGRAM, f"{__version__} in {ROOT}")
    yield python_finding(sys.version_info[:2], f"{platform.python_version()} ({sys.executable})")
    yield Finding("system", platform.platform())


def python_finding(running: tuple[int, int], words: str) -> Finding:
    """Whether this Python is one that the locked packages exist for."""
    low, high = SUPPORTED
    if low <= running <= high:
        return Finding("Python", words)
    names = f"{'.'.join(map(str, low))} to {'.'.join(map(str, high))}"
    state = State.MISSING if running < low else State.NOTE
    return Finding(
        "Python", f"{words}; supported: {names}", state, "UNDERSTUDY_PYTHON=/path/to/python3 ./run"
    )


def _packages() -> Iterable[Finding]:
    wanted = probes.locked(CLONE)
    return package_findings(wanted, {name: probes.installed(name) for name in wanted})


def package_findings(wanted: Mapping[str, str], there: Mapping[str, str]) -> list[Finding]:
    """What is missing or not as locked, one by one, and how many are as they should be."""
    missing = [name for name in wanted if not there[name]]
    other = [name for name in wanted if there[name] and wanted[name] not in (probes.ANY, there[name])]
    right = f"{len(wanted) - len(missing) - len(other)} of {len(wanted)}"
    found = [
        Finding(
            "packages", f"{right} there" if set(wanted.values()) == {probes.ANY} else f"{right} as locked"
        )
    ]
    again = "install again: " + shlex.join(_install_command())
    found += [Finding(name, f"not there; locked: {wanted[name]}", State.MISSING, again) for name in missing]
    found += [Finding(name, f"{there[name]}; locked: {wanted[name]}", State.NOTE) for name in other]
    return found


def _install_command() -> list[str]:
    source = (
        ["-r", str(CLONE / "requirements.lock")] if (CLONE / "requirements.lock").is_file() else [PROGRAM]
    )
    return [sys.executable, "-m", "pip", "install", *source]


def _qt() -> Iterable[Finding]:
    facts, problem = probes.qt()
    if problem:
        yield Finding("Qt", f"does not start: {problem}", State.MISSING)
        return
    yield Finding("Qt", f"{facts['version']}, starts off screen")
    fonts = facts["fonts"]
    mend = "" if fonts else apt(["fonts-dejavu-core"])
    yield Finding("fonts", f"{fonts} families", State.OK if fonts else State.MISSING, mend)


def _libraries() -> Iterable[Finding]:
    screen = display()
    yield Finding(
        "display", screen or "none: pictures are drawn all the same", State.OK if screen else State.NOTE
    )
    packages = probes.debian_packages(CLONE)
    drawing = probes.missing_libraries(DRAWING)
    windows = [name for name in probes.missing_libraries(WINDOWS) if name not in drawing]
    yield library_finding("libraries to draw", drawing, packages, needed=True)
    yield library_finding("libraries for windows", windows, packages, needed=bool(screen))


def library_finding(
    name: str, missing: Sequence[str], packages: Mapping[str, str], *, needed: bool
) -> Finding:
    """System libraries that are not there, with the command that installs them."""
    if not missing:
        return Finding(name, "all there")
    wanted = [packages[library] for library in missing if library in packages]
    return Finding(
        name, f"not there: {', '.join(missing)}", State.MISSING if needed else State.NOTE, apt(wanted)
    )


def apt(packages: Sequence[str]) -> str:
    """The command that installs Debian packages; none for none."""
    if not packages:
        return ""
    return f"sudo apt-get update && sudo apt-get install -y --no-install-recommends {' '.join(dict.fromkeys(packages))}"


def _graphviz() -> Iterable[Finding]:
    problem = probes.graphviz()
    if problem:
        yield Finding("Graphviz", f"does not work: {problem}", State.MISSING, shlex.join(_install_command()))
    else:
        yield Finding("Graphviz", "lays graphs out")


def _machine() -> Iterable[Finding]:
    yield Finding("cores", str(cores()))
    yield folder_finding("cache folder", platformdirs.user_cache_path(PROGRAM, appauthor=False))
    yield folder_finding("log folder", platformdirs.user_log_path(PROGRAM, appauthor=False))


def folder_finding(name: str, folder: Path) -> Finding:
    """Whether a folder of ours can be written to."""
    if probes.writable(folder):
        return Finding(name, str(folder))
    return Finding(
        name, f"{folder} cannot be written to", State.NOTE, f"chown -R $USER {shlex.quote(str(folder))}"
    )
