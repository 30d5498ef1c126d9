"""What the graph panel draws of the document: graphs and arrangements, kept while nothing they are made of changes."""

from collections.abc import Collection, Mapping

from ...core.automaton import Automaton
from ...core.remembered import Remembered
from ...core.tree import Tree
from ...export.graph import AutomatonGraph, Edge, edges_from, graph_with
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
        self._leaving: Remembered[tuple[BehaviorKey, str], tuple[Edge, ...]] = Remembered()
        self._last: dict[BehaviorKey, Mapping[str, Point]] = {}

    def forget(self) -> None:
        """Another project is open."""
        self._graphs.keep(())
        self._leaving.keep(())
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
        key, library = BehaviorKey(type_name, automaton.id), self._document.project.library(type_name)
        edges = [edge for state in automaton.states for edge in self._edges(key, automaton, state.id)]
        held = (library.automata.get(held) for held in automaton.nested())
        made_of = automaton.name, automaton.states, *edges, *held
        return self._graphs.of(key, made_of, lambda: graph_with(automaton, library, edges))

    def _edges(self, key: BehaviorKey, automaton: Automaton, source: str) -> tuple[Edge, ...]:
        """Those that leave a state: made of all that they show, not of what other states learned, nor of a note."""
        model = automaton.learned.get(source)
        treeless = model is not None and not isinstance(model, Tree)  # see `edges_from`
        examples = self._document.project.examples_of(key.type, key.id) if treeless else ()
        parts = automaton.states, automaton.features, automaton.rules, automaton.prunes, automaton.settings
        scenario = self._document.scenario
        return self._leaving.of(
            (key, source),
            (*parts, model, examples, scenario),
            lambda: tuple(edges_from(source, automaton, scenario.vocabulary, examples)),
        )

    def _arranged(self, key: BehaviorKey, request: Request) -> tuple[Arrangement, bool]:
        known = self._laying_out.known(request)
        if known is not None:
            self._last[key] = known.places
            return known, True
        self._laying_out.ask(request)
        return at_once(request, self._last.get(key)), False
