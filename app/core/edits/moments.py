"""The moments that examples refer to: kept as long as one does.

A project from disk has moments that are made only when they are looked at, so these edits look at none: new moments
come as a layer above the stored ones. Stored ones that nothing refers to any more stay until the project is saved and
loaded, which leaves them out.
"""

from collections import ChainMap
from collections.abc import Mapping
from dataclasses import replace

from ..examples import Moment
from ..project import Project

Moments = Mapping[str, Moment]


def with_moments(project: Project, moments: Moments) -> Project:
    """*project* with these moments besides those it has."""
    new = {key: moment for key, moment in moments.items() if key not in project.moments}
    if not new:
        return project
    above, stored = _layers(project.moments)
    return _layered(project, {**above, **new}, stored)


def without_stray_moments(project: Project) -> Project:
    """*project* without the moments that no example refers to."""
    used = {
        e.snapshot for by_id in project.examples.values() for examples in by_id.values() for e in examples
    }
    above, stored = _layers(project.moments)
    if used.issuperset(above):
        return project
    return _layered(project, {key: moment for key, moment in above.items() if key in used}, stored)


def _layers(moments: Moments) -> tuple[Moments, Moments | None]:
    """What can be copied at no cost, and what cannot."""
    if isinstance(moments, dict):
        return moments, None
    if isinstance(moments, ChainMap):
        return moments.maps[0], moments.maps[1]
    return {}, moments


def _layered(project: Project, above: dict[str, Moment], stored: Moments | None) -> Project:
    moments: Moments = above
    if stored is not None:
        moments = ChainMap(above, stored) if above else stored  # type: ignore[arg-type]  # only read
    return replace(project, moments=moments)
