"""Behaviors that were taught more, or edited, since they were last learned."""

from ..core.project import Project
from ..learner.trainer import is_stale
from .console import say
from .opening import Opened


def stale_behaviors(project: Project) -> list[str]:
    """Their names, with the type's: "agent/Goto"."""
    return [
        f"{node_type.name}/{automaton.name}"
        for node_type in project.types
        for automaton in project.library(node_type.name).automata.values()
        if is_stale(project, node_type.name, automaton.id)
    ]


def warn_of_stale(opened: Opened) -> None:
    """Tell the user that what runs is not what was taught."""
    if stale := stale_behaviors(opened.project):
        what = "was" if len(stale) == 1 else "were"
        mends = (
            f"`understudy train {opened.folder}` learns again"
            if opened.file is None
            else f"learn again where {opened.file} was exported from, and export anew"
        )
        say(f"{', '.join(stale)} {what} changed since last learned; {mends}")
