"""What is in a project's folder, and projects of which one automaton is another."""

from dataclasses import replace
from pathlib import Path

from app.core.automaton import Automaton
from app.core.library import Library
from app.core.project import Project

AGENT = "agent"


def files(folder: Path) -> dict[str, bytes]:
    """Everything under *folder*, folders included."""
    return {
        path.relative_to(folder).as_posix(): b"" if path.is_dir() else path.read_bytes()
        for path in folder.rglob("*")
    }


def contents(folder: Path) -> dict[str, bytes]:
    """The same without folders."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()
    }


def changed(project: Project, automaton: Automaton) -> Project:
    automata = {**project.library(AGENT).automata, automaton.id: automaton}
    return replace(project, libraries={**project.libraries, AGENT: Library(automata)})


def without(project: Project, automaton_id: str) -> Project:
    automata = {key: a for key, a in project.library(AGENT).automata.items() if key != automaton_id}
    return replace(project, libraries={**project.libraries, AGENT: Library(automata)})
