"""``understudy train``: learn behaviors again from their stored examples."""

from collections.abc import Sequence
from pathlib import Path

from ..core.storage import save
from ..learner.evaluation import BehaviorReport, StateReport, plain
from ..learner.trainer import Learned, apply, learn
from .console import PROGRAM, nothing_changes, progress, say, show, show_json, show_table
from .exits import DONE
from .naming import named_behaviors
from .opening import Opened, open_project
from .wording import counted, percent

COLUMNS = ("behavior", "state", "examples", "nodes", "accuracy", "cross-validated")


def train_project(folder: Path, words: Sequence[str], *, dry_run: bool, trust: bool, as_json: bool) -> int:
    """Learn, keep what was learned, and report per state."""
    opened = open_project(folder, trust=trust)
    learned = learned_from(opened, words)
    after = apply(opened.project, learned)
    if not dry_run:
        save(after, folder, opened.project)
    if as_json:
        show_json(plain(learned.reports))
    elif learned.reports:
        show_table(COLUMNS, [row for report in learned.reports for row in rows(report)], words=2)
        show("\n" + summary(learned.reports, changed=after != opened.project, dry_run=dry_run))
    else:
        show(f"{opened.project.name}: no behavior has examples, so there is nothing to learn")
    for line in (line for report in learned.reports for line in remarks(report)):
        say(line)
    return DONE


def learned_from(opened: Opened, words: Sequence[str]) -> Learned:
    """What the behaviors named by *words*, or all with examples, are learned to do.

    Raises:
        UnderstudyError: A word names no behavior, or one that has nothing to learn from.
    """
    project, vocabulary = opened.project, opened.scenario.vocabulary
    with_examples = {
        (name, automaton)
        for name, by_id in project.examples.items()
        for automaton, examples in by_id.items()
        if examples
    }
    only = named_behaviors(project, words, with_examples) if words else None
    with nothing_changes(), progress("Learning", 1.0) as advance:
        return learn(project, vocabulary, only, lambda done, _: advance(done), cross_validate=True)


# ------------------------------------------------------------------------------------------------------- shaping


def rows(report: BehaviorReport) -> list[list[str]]:
    """A row a state; the behavior's name stands in the first."""
    name = f"{report.type}/{report.name}"
    return [_row(name if index == 0 else "", state) for index, state in enumerate(report.states)] or [[name]]


def _row(name: str, state: StateReport) -> list[str]:
    nodes = str(state.nodes) if state.nodes else "–"
    return [name, state.name, str(state.examples), nodes, percent(state.accuracy), percent(state.cv_accuracy)]


def summary(reports: Sequence[BehaviorReport], *, changed: bool, dry_run: bool) -> str:
    """How much was learned, and what became of it."""
    examples = counted(sum(report.examples for report in reports), "example")
    if not changed:
        outcome = "just as it was"
    else:
        outcome = f"not kept: {PROGRAM} train without --dry-run keeps it" if dry_run else "kept"
    return f"{counted(len(reports), 'behavior')} from {examples}; {outcome}"


def remarks(report: BehaviorReport) -> list[str]:
    """What the user should look at: examples that contradict each other, and those that could not be used."""
    name = f"{report.type}/{report.name}"
    said = [
        f"{name}, state {state.name}: examples {' and '.join(group)} have equal features and different labels"
        for state in report.states
        for group in state.conflicts
    ]
    return said + [f"{name}: example {left.example} is left out: {left.reason}" for left in report.left_out]
