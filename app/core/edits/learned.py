"""Edits of what an automaton learned: models from the trainer, and prunes that survive retraining."""

from collections.abc import Collection, Iterator, Mapping

from ..automaton import Automaton, Model, Prune
from ..conditions import Guard
from ..errors import EditError
from ..naming import next_number
from ..project import Project
from ..tree import Tree
from .place import change, find_automaton, find_index, replaced
from .rules import leaves, refuse_guard
from .states import refuse_states
from .words import says


@says("Learn {automaton_id}")
def set_learned(
    project: Project, type_name: str, automaton_id: str, models: Mapping[str, Model], learned_from: str
) -> Project:
    """Put in what was learned, by state id, with the fingerprint of what it was learned from."""
    automaton = find_automaton(project, type_name, automaton_id)
    refuse_states(automaton, models)
    return change(project, type_name, automaton_id, learned=dict(models), learned_from=learned_from)


@says("Prune state {source} of {automaton_id}")
def add_prune(
    project: Project,
    type_name: str,
    automaton_id: str,
    source: str,
    forbidden: Collection[str],
    guard: Guard = (),
) -> tuple[Project, str]:
    """Forbid the model of *source* some labels where *guard* is met; also returns the prune's id."""
    automaton = find_automaton(project, type_name, automaton_id)
    prune = Prune(str(next_number(p.id for p in automaton.prunes)), source, guard, frozenset(forbidden))
    _refuse_prune(automaton, prune)
    return change(project, type_name, automaton_id, prunes=(*automaton.prunes, prune)), prune.id


@says("Change prune {prune_id} of {automaton_id}")
def replace_prune(
    project: Project,
    type_name: str,
    automaton_id: str,
    prune_id: str,
    *,
    forbidden: Collection[str] | None = None,
    guard: Guard | None = None,
) -> Project:
    """Other labels or another guard for a prune; what is None stays."""
    automaton = find_automaton(project, type_name, automaton_id)
    index = _prune_index(automaton, prune_id)
    old = automaton.prunes[index]
    labels = old.forbidden if forbidden is None else frozenset(forbidden)
    new = Prune(prune_id, old.source, old.guard if guard is None else guard, labels)
    _refuse_prune(automaton, new)
    prunes = replaced(automaton.prunes, index, new)
    return change(project, type_name, automaton_id, prunes=prunes)


@says("Take back prune {prune_id} of {automaton_id}")
def remove_prune(project: Project, type_name: str, automaton_id: str, prune_id: str) -> Project:
    """No such prune any more."""
    automaton = find_automaton(project, type_name, automaton_id)
    index = _prune_index(automaton, prune_id)
    prunes = replaced(automaton.prunes, index)
    return change(project, type_name, automaton_id, prunes=prunes)


@says("Prune transitions of {automaton_id} with less support than {support}")
def prune_weak(project: Project, type_name: str, automaton_id: str, support: float) -> Project:
    """Forbid, at every leaf of every tree, the transitions that fewer than *support* examples speak for."""
    automaton = find_automaton(project, type_name, automaton_id)
    number = next_number(prune.id for prune in automaton.prunes)
    there = {(prune.source, prune.guard, prune.forbidden) for prune in automaton.prunes}
    new = [weak for weak in _weak(automaton, support) if weak not in there]
    made = tuple(Prune(str(number + i), *weak) for i, weak in enumerate(new))
    return change(project, type_name, automaton_id, prunes=(*automaton.prunes, *made))


def _weak(automaton: Automaton, support: float) -> Iterator[tuple[str, Guard, frozenset[str]]]:
    for source, model in automaton.learned.items():
        if isinstance(model, Tree):
            for path, counts in leaves(model.root):
                labels = zip(model.labels, counts, strict=True)
                forbidden = frozenset(label for label, n in labels if 0.0 < n < support and label != source)
                if forbidden:
                    yield source, path, forbidden


def _refuse_prune(automaton: Automaton, prune: Prune) -> None:
    refuse_states(automaton, (prune.source, *sorted(prune.forbidden)))
    refuse_guard(automaton, prune.guard)
    if not prune.forbidden:
        raise EditError(f"prune {prune.id!r} of {automaton.name} forbids nothing; name at least one state")


def _prune_index(automaton: Automaton, prune_id: str) -> int:
    return find_index([prune.id for prune in automaton.prunes], prune_id, "prune", automaton.name)
