"""Checks of transitions: authored rules, learned models, prunes, and what can be reached."""

from collections.abc import Iterator
from dataclasses import replace

from ..automaton import START, Automaton, Basic, Model, RaiseFlag, Refit, Rule, State, reachable, successors
from ..edits import remove_cut, remove_prune, remove_rule
from ..errors import LibraryError
from ..examples import Example, enabled
from ..project import Project
from ..tree import Branch, Forest, Tree
from ..vocabulary import Feature, Vocabulary
from .features import declared, guard_problems, test_problems
from .problem import Problem, allowed, place
from .scope import Subject

Known = dict[str, Feature | None]


def transition_problems(subject: Subject, examples: tuple[Example, ...]) -> Iterator[Problem]:
    """What is wrong with an automaton's transition functions."""
    known = declared(subject)
    states = {state.id: state for state in subject.automaton.states}
    yield from _rule_problems(subject, states, known)
    yield from _prune_problems(subject, states, known)
    yield from _cut_problems(subject, states, known)
    models = [
        problem
        for source, model in subject.automaton.learned.items()
        for problem in _model_problems(subject, source, model, states, known)
    ]
    yield from models
    if not any(problem.severity == "error" for problem in models):  # a broken model leads who knows where
        yield from _graph_problems(subject, examples)


# ----------------------------------------------------------------------------------------------- rules


def _rule_problems(subject: Subject, states: dict[str, State], known: Known) -> Iterator[Problem]:
    settled: dict[str, str] = {}
    for index, rule in enumerate(subject.automaton.rules):
        remove = subject.edit(remove_rule, rule.id)
        for where, message in _broken(index, rule, states, known):
            who = f"rule {rule.id!r} of {subject.automaton.name}"
            yield subject.error(where, f"{who} {message}", LibraryError, "remove the rule", remove)
        if unused := _unused(rule, states, settled, subject.scope.vocabulary):
            message = f"rule {rule.id!r} of {subject.automaton.name} is never used: {unused}"
            yield subject.warning(place("rules", index), message, "remove the rule", remove)
        if not rule.guard and rule.probability >= 1.0:
            settled.setdefault(rule.source, rule.id)


def _broken(index: int, rule: Rule, states: dict[str, State], known: Known) -> Iterator[tuple[str, str]]:
    for end, state_id in (("source", rule.source), ("target", rule.target)):
        if state_id not in states:
            verb = "leaves" if end == "source" else "leads to"
            there = allowed(state_id, states)
            yield place("rules", index, end), f"{verb} state {state_id!r}, which does not exist; {there}"
    for number, message in guard_problems(rule.guard, known):
        yield place("rules", index, "guard", number), f"tests {message}"
    if not 0.0 <= rule.probability <= 1.0:
        yield (
            place("rules", index, "probability"),
            f"has the probability {rule.probability:g}; allowed: 0 to 1",
        )


def _unused(rule: Rule, states: dict[str, State], settled: dict[str, str], vocabulary: Vocabulary) -> str:
    """Why a rule is never tried; empty if it may be."""
    source = states.get(rule.source)
    if source is not None and raises_flag(source, vocabulary):
        return f"state {rule.source!r} raises a flag, so it is left for Start at once"
    if rule.source in settled:
        return f"rule {settled[rule.source]!r} before it always leaves state {rule.source!r}"
    return "its probability is 0" if rule.probability == 0.0 else ""


def raises_flag(state: State, vocabulary: Vocabulary) -> bool:
    """Whether a state raises a flag and is left within the tick in which it is entered."""
    match state.content:
        case RaiseFlag():
            return True
        case Basic(name):
            behavior = vocabulary.behaviors.get(name)
            return behavior is not None and behavior.raises is not None
    return False


# ---------------------------------------------------------------------------------------------- prunes


def _prune_problems(subject: Subject, states: dict[str, State], known: Known) -> Iterator[Problem]:
    for index, prune in enumerate(subject.automaton.prunes):
        who = f"prune {prune.id!r} of {subject.automaton.name}"
        remove = subject.edit(remove_prune, prune.id)
        mentioned = [("source", prune.source), *(("forbidden", label) for label in sorted(prune.forbidden))]
        for end, state_id in mentioned:
            if state_id not in states:
                message = f"{who} names state {state_id!r}, which does not exist; {allowed(state_id, states)}"
                yield subject.error(
                    place("prunes", index, end), message, LibraryError, "remove the prune", remove
                )
        for number, message in guard_problems(prune.guard, known):
            where = place("prunes", index, "guard", number)
            yield subject.error(where, f"{who} tests {message}", LibraryError, "remove the prune", remove)


def _cut_problems(subject: Subject, states: dict[str, State], known: Known) -> Iterator[Problem]:
    for index, cut in enumerate(subject.automaton.cuts):
        who = f"cut {cut.id!r} of {subject.automaton.name}"
        remove = subject.edit(remove_cut, cut.id)
        if cut.source not in states:
            message = f"{who} names state {cut.source!r}, which does not exist; {allowed(cut.source, states)}"
            yield subject.error(
                place("cuts", index, "source"), message, LibraryError, "remove the cut", remove
            )
        for message in test_problems(cut.test, known):
            where = place("cuts", index, "test")
            yield subject.error(where, f"{who} tests {message}", LibraryError, "remove the cut", remove)


# ---------------------------------------------------------------------------------------------- models


def _model_problems(
    subject: Subject, source: str, model: Model, states: dict[str, State], known: Known
) -> Iterator[Problem]:
    where = place("learned", source)
    forget = subject.edit(_without_model, source)
    who = f"what {subject.automaton.name} learned for state {source!r}"
    if source not in states:
        message = f"{who} belongs to no state; {allowed(source, states)}"
        yield subject.error(where, message, LibraryError, "forget it", forget)
        return
    for message in dict.fromkeys(_broken_model(model, states, known)):
        yield subject.error(where, f"{who} {message}", LibraryError, "forget it and learn again", forget)
    if raises_flag(states[source], subject.scope.vocabulary):
        message = f"{who} is never used: the state raises a flag, so it is left for Start at once"
        yield subject.warning(where, message, "forget it", forget)


def _broken_model(model: Model, states: dict[str, State], known: Known) -> Iterator[str]:
    if isinstance(model, Refit):
        return
    trees = model.trees if isinstance(model, Forest) else (model,)
    if not trees:
        yield "is a forest without trees"
    for label in model.labels:
        if label not in states:
            yield f"leads to state {label!r}, which does not exist; {allowed(label, states)}"
    for tree in trees:
        yield from _broken_tree(tree, len(model.labels), known)


def _broken_tree(tree: Tree, labels: int, known: Known) -> Iterator[str]:
    for node in tree.nodes():
        if len(node.counts) != labels:
            yield f"has {len(node.counts)} counts at a node, but {labels} labels"
        if isinstance(node, Branch):
            for message in test_problems(node.test, known):
                yield f"tests {message}"


def _without_model(project: Project, type_name: str, automaton_id: str, source: str) -> Project:
    library = project.library(type_name)
    automaton = library.get(automaton_id)
    kept = {state: model for state, model in automaton.learned.items() if state != source}
    automata = {**library.automata, automaton_id: replace(automaton, learned=kept, learned_from="")}
    return replace(project, libraries={**project.libraries, type_name: replace(library, automata=automata)})


# ----------------------------------------------------------------------------------------------- reach


def _graph_problems(subject: Subject, examples: tuple[Example, ...]) -> Iterator[Problem]:
    """Start that is never left, states that are never entered or never left. Data not learned yet may mend them."""
    automaton = subject.automaton
    usable = {example.source for example in enabled(examples)}
    if not automaton.rules and not automaton.learned:
        if not usable:
            message = f"{automaton.name} never leaves Start: it has no rules, and nothing to learn from"
            yield subject.warning("", message)
        return
    after = {state.id: successors(automaton, state.id) - {state.id} for state in automaton.states}
    if not after.get(START) and START not in usable:
        yield subject.warning(
            place("states", 0), f"{automaton.name} never leaves Start: no transition leads out of it"
        )
    yield from _dead_ends(subject, automaton, after, usable)


def _dead_ends(
    subject: Subject, automaton: Automaton, after: dict[str, set[str]], usable: set[str]
) -> Iterator[Problem]:
    entered = reachable(automaton)
    waiting = usable - automaton.learned.keys()
    for index, state in enumerate(automaton.states):
        name = f"state {subject.state(state.id)} of {automaton.name}"
        if index == 0 or state.id == START:
            continue
        if state.id not in entered:
            if not waiting:
                yield subject.warning(
                    place("states", index), f"{name} is never entered: no transition leads to it"
                )
        elif (
            not after[state.id]
            and state.id not in usable
            and not raises_flag(state, subject.scope.vocabulary)
        ):
            yield subject.warning(
                place("states", index), f"{name} is never left: it has neither rules nor data"
            )
