"""Looking at this machine: what is installed, and whether it starts. Nothing here judges or prints."""

import json
import os
import re
import subprocess
import sys
from collections.abc import Mapping
from importlib.metadata import PackageNotFoundError, requires, version
from importlib.util import find_spec
from pathlib import Path

#: The version asked for where no lock says one.
ANY = "any"
#: Seconds that a program gets to show that it starts.
PATIENCE = 60.0

#: Prints Qt's version and how many families of fonts it finds.
_QT = """
import json
from PySide6.QtCore import qVersion
from PySide6.QtGui import QFontDatabase, QGuiApplication
application = QGuiApplication(["understudy"])
print(json.dumps({"version": qVersion(), "fonts": len(QFontDatabase.families())}))
"""
#: Lays the smallest graph out.
_GRAPHVIZ = """
import pygraphviz
graph = pygraphviz.AGraph("digraph { a -> b }")
graph.layout("dot")
print("ok" if "pos=" in graph.to_string() else "")
"""
_PIN = re.compile(r"^([A-Za-z0-9._-]+)==([^ ;\\]+)", re.MULTILINE)
_ENTRY = re.compile(r'^\s*"([^"|]+)\|([^"|]+)"', re.MULTILINE)


def ended(code: str, **environment: str) -> tuple[str, str]:
    """What *code* prints in a Python of its own, and why it failed; one of the two is empty."""
    try:
        done = subprocess.run(
            [sys.executable, "-c", code],
            capture_output=True,
            text=True,
            timeout=PATIENCE,
            env={**os.environ, **environment},
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        return "", str(error)
    if done.returncode == 0:
        return done.stdout.strip(), ""
    said = done.stderr.strip().splitlines() or [f"it ended with code {done.returncode}"]
    return "", said[-1]


def qt() -> tuple[Mapping[str, object], str]:
    """Qt's version and number of font families on the off-screen platform, or why it does not start."""
    said, problem = ended(_QT, QT_QPA_PLATFORM="offscreen")
    return (json.loads(said) if said else {}), problem


def graphviz() -> str:
    """Why Graphviz does not lay a graph out; empty if it does."""
    said, problem = ended(_GRAPHVIZ)
    return problem or ("" if said == "ok" else "it gave a graph without positions")


def missing_libraries(files: tuple[str, ...]) -> list[str]:
    """The system libraries that files of PySide6 load and that are not there, e.g. ``libEGL.so.1``."""
    found = find_spec("PySide6")
    if found is None or not found.submodule_search_locations or sys.platform != "linux":
        return []
    root = Path(found.submodule_search_locations[0])
    missing: dict[str, None] = {}
    for file in files:
        for line in _ldd(root / file):
            if "not found" in line and "=>" in line:
                missing[line.split("=>")[0].strip()] = None
    return list(missing)


def _ldd(path: Path) -> list[str]:
    try:
        done = subprocess.run(
            ["ldd", str(path)],
            capture_output=True,
            text=True,
            timeout=PATIENCE,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired):
        return []
    return done.stdout.splitlines()


def debian_packages(clone: Path) -> Mapping[str, str]:
    """System library -> Debian package, as the set-up of a clone knows them; nothing without a clone."""
    try:
        text = (clone / ".ci" / "setup.sh").read_text(encoding="utf-8")
    except OSError:
        return {}
    return dict(_ENTRY.findall(text))


def locked(clone: Path) -> Mapping[str, str]:
    """Package -> version in the clone's lock; where there is no clone, `ANY` of what the installed package asks for."""
    try:
        return dict(_PIN.findall((clone / "requirements.lock").read_text(encoding="utf-8")))
    except OSError:
        return {re.split(r"[^A-Za-z0-9._-]", name)[0]: ANY for name in _required() if "extra ==" not in name}


def _required() -> list[str]:
    try:
        return requires("understudy") or []
    except PackageNotFoundError:
        return []


def installed(package: str) -> str:
    """The version of a package; empty if it is not there."""
    try:
        return version(package)
    except PackageNotFoundError:
        return ""


def writable(folder: Path) -> bool:
    """Whether files can be made in *folder*, or in what it would be made in."""
    there = next((place for place in (folder, *folder.parents) if place.exists()), folder)
    return there.is_dir() and os.access(there, os.W_OK | os.X_OK)
