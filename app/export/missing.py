"""What behaviors need that a project cannot offer: basic behaviors, features and targets, by name."""

from collections.abc import Iterable, Iterator

from ..core.automaton import Automaton, Basic, Nested
from ..core.edits.place import find_automaton, listed
from ..core.errors import EditError
from ..core.features import Bindings, FlagUp, Ground, Sense, Source, Statistic, TicksInState
from ..core.library import Types
from ..core.project import Project
from ..sim.scenario import Scenario

#: What is missing: a kind of thing, and its name.
Lack = tuple[str, str]


def refuse_missing(
    project: Project, scenario: Scenario, source: Project, keys: Iterable[tuple[str, str]]
) -> None:
    """Raise an `EditError` that names all that these automata, which came from *source*, lack in *project*."""
    types = project.types_with(scenario.vocabulary)
    lacks = dict.fromkeys(
        lack for key in keys for lack in _lacks(types, key[0], find_automaton(project, *key))
    )
    if not lacks:
        return
    kinds = dict.fromkeys(kind for kind, _ in lacks)
    words = "; ".join(f"{kind}: {listed(name for of, name in lacks if of == kind)}" for kind in kinds)
    if source.scenario == project.scenario:
        raise EditError(f"this project lacks what the file needs: {words}")
    raise EditError(
        f"the file is of the scenario {source.scenario!r}; this project's, {scenario.name!r}, lacks what it needs: {words}"
    )


def _lacks(types: Types, type_name: str, automaton: Automaton) -> Iterator[Lack]:
    vocabulary = types.vocabulary(type_name)
    for state in automaton.states:
        match state.content:
            case Basic(name, bindings):
                if name not in vocabulary.behaviors:
                    yield _behaviors_of(type_name, vocabulary.level), name
                yield from _targets(bindings, types, type_name)
            case Nested(_, bindings):
                yield from _targets(bindings, types, type_name)
    for use in automaton.features:
        yield from _unseen(use.source, types, type_name)


def _behaviors_of(type_name: str, level: int) -> str:
    return "basic behaviors" if level == 0 else f"behaviors that all below {type_name!r} have"


def _unseen(source: Source, types: Types, type_name: str) -> Iterator[Lack]:
    match source:
        case Sense(name, bindings):
            if name not in types.vocabulary(type_name).features:
                yield "features", name
            yield from _targets(bindings, types, type_name)
        case Statistic(_, Sense(name, bindings), _):
            if name not in types.agent_features().features:
                yield "features", name
            yield from _targets(bindings, types, type_name)
        case Statistic() | FlagUp() | TicksInState():
            return


def _targets(bindings: Bindings, types: Types, type_name: str) -> Iterator[Lack]:
    known = types.vocabulary(type_name).targets
    for binding in bindings.values():
        if isinstance(binding, Ground) and binding.target not in known:
            yield "targets", binding.target
