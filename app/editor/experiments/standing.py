"""How far an experiment is, in words."""

from __future__ import annotations

from ...core.amounts import counted, lasting
from ...engine.experiments.laboratory import Look, Stage
from ...engine.experiments.lengths import other_lengths
from .study import Kept, Study


def words_of(look: Look, study: Study) -> str:
    """How far an experiment is, in a sentence."""
    if look.stage is Stage.FAILED or look.notice:
        return look.notice
    progress = look.progress
    if look.stage is Stage.BEGINNING and progress is None:
        return f"beginning: {counted(study.total, 'run')} are to be there"
    done = 0 if progress is None else progress.done
    runs = f"{done:,} of {counted(study.total, 'run')}"
    match look.stage:
        case Stage.PAUSED:
            return f"paused at {runs}"
        case Stage.CANCELLED:
            return f"cancelled; {runs} are kept, and Run goes on with the others"
        case Stage.FINISHED:
            return f"finished: {counted(study.total, 'run')}"
    left = None if progress is None else progress.seconds_left
    return runs if left is None else f"{runs}, {lasting(left)} left"


def standing(kept: Kept | None, study: Study) -> str:
    """What there is of an experiment that does not run."""
    if kept is None or not kept.rows:
        asked = f"not run yet: {counted(study.total, 'run')} of {counted(study.experiment.ticks, 'tick')}"
        others = [f"{ticks:,}" for ticks in other_lengths(study.declared.name, study.path.parent)]
        return f"{asked}; there are runs of {' and '.join(others)} ticks" if others else asked
    if len(kept.rows) == study.total:
        return f"finished: {counted(study.total, 'run')}"
    return f"{len(kept.rows):,} of {counted(study.total, 'run')} are there; Run makes the others"
