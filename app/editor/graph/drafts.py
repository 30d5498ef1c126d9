"""What the graph panel draws of the document: graphs and arrangements, kept while nothing they are made of changes."""

from collections.abc import Collection, Mapping

from ...core.automaton import Automaton
from ...core.remembered import Remembered
from ...core.tree import Tree
from ...export.graph import AutomatonGraph, graph_of
from ..document import Document
from ..selection import BehaviorKey
from .arrangement import Arrangement, Point, Request, at_once
from .laying_out import LayingOut
from .level import Drafting, Drawn
from .state_item import Path


class Drafts:
    """Drafts of automata of the document."""

    def __init__(self, document: Document, laying_out: LayingOut) -> None:
        self._document = document
        self._laying_out = laying_out
        self._graphs: Remembered[BehaviorKey, AutomatonGraph] = Remembered()
        self._last: dict[BehaviorKey, Mapping[str, Point]] = {}

    def forget(self) -> None:
        """Another project is open."""
        self._graphs.keep(())
        self._last.clear()

    def drawn(self, key: BehaviorKey, is_open: Collection[Path]) -> Drawn | None:
        """An automaton as it is to be drawn now; what is not arranged yet is asked for. None if it is gone."""
        automaton = self._document.automaton(key.type, key.id)
        if automaton is None:
            return None
        self._laying_out.forget_waiting()
        drafting = Drafting(
            key.type,
            lambda automaton_id: self._document.automaton(key.type, automaton_id),
            lambda found: self._graph(key.type, found),
            lambda automaton_id: self._document.project.layout_of(key.type, automaton_id),
            lambda automaton_id, request: self._arranged(BehaviorKey(key.type, automaton_id), request),
            is_open,
        )
        return drafting.drawn(automaton)

    def _graph(self, type_name: str, automaton: Automaton) -> AutomatonGraph:
        project = self._document.project
        library = project.library(type_name)
        treeless = any(not isinstance(model, Tree) for model in automaton.learned.values())
        examples = project.examples_of(type_name, automaton.id) if treeless else ()  # see `graph_of`
        held = (library.automata.get(held) for held in automaton.nested())
        made_of = *_drawn(automaton), examples, *held
        return self._graphs.of(
            BehaviorKey(type_name, automaton.id),
            made_of,
            lambda: graph_of(automaton, library, self._document.scenario.vocabulary, examples),
        )

    def _arranged(self, key: BehaviorKey, request: Request) -> tuple[Arrangement, bool]:
        known = self._laying_out.known(request)
        if known is not None:
            self._last[key] = known.places
            return known, True
        self._laying_out.ask(request)
        return at_once(request, self._last.get(key)), False


def _drawn(automaton: Automaton) -> tuple[object, ...]:
    """All of an automaton that its graph is made of: not its note, nor what its models were learned from."""
    return (
        automaton.name,
        automaton.states,
        automaton.features,
        automaton.rules,
        automaton.prunes,
        automaton.learned,
        automaton.settings,
    )
