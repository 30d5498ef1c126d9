"""Libraries: the automata of one node type, a directed acyclic graph, and the vocabulary each type builds on."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from .automaton import Automaton, Basic, RaiseFlag
from .errors import LibraryError
from .vocabulary import FINISHED, STANDARD_FLAGS, BasicBehavior, Vocabulary

if TYPE_CHECKING:
    import networkx as nx

Behavior = BasicBehavior | Automaton


@dataclass(frozen=True, slots=True)
class NodeType:
    """A kind of node with a library of its own: agents (level 0) or controllers.

    Attributes:
        subsidiaries: The types that may stand directly under a controller of this type; none for agents.
    """

    name: str
    level: int = 0
    subsidiaries: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Library:
    """The automata of one node type, by id."""

    automata: Mapping[str, Automaton] = field(default_factory=dict)

    def get(self, automaton_id: str) -> Automaton:
        """The automaton with this id.

        Raises:
            LibraryError: There is none; the message names those there are.
        """
        if automaton_id not in self.automata:
            there = ", ".join(sorted(self.automata)) or "none"
            raise LibraryError(f"there is no behavior with the id {automaton_id!r}; there are: {there}")
        return self.automata[automaton_id]

    def by_name(self, name: str) -> Automaton | None:
        """The automaton called *name*, if there is one."""
        return next((automaton for automaton in self.automata.values() if automaton.name == name), None)

    def graph(self) -> "nx.DiGraph[str]":
        """Automata as nodes, an edge from each to every automaton that it holds."""
        import networkx as nx  # noqa: PLC0415 - it takes 0.1 s, and the window is to be there before

        graph: nx.DiGraph[str] = nx.DiGraph()
        graph.add_nodes_from(self.automata)
        graph.add_edges_from((a.id, held) for a in self.automata.values() for held in a.nested())
        return graph

    def cycle(self) -> tuple[str, ...]:
        """Names of automata that hold each other in a circle, the first again at the end; empty if there is none."""
        import networkx as nx  # noqa: PLC0415 - it takes 0.1 s, and the window is to be there before

        graph = self.graph()
        try:
            edges = nx.find_cycle(graph)
        except nx.NetworkXNoCycle:
            return ()
        ids = [edge[0] for edge in edges] + [edges[0][0]]
        return tuple(self.automata[i].name if i in self.automata else i for i in ids)

    def bottom_up(self) -> tuple[Automaton, ...]:
        """All automata, each after those that it holds; equals in the order of their names.

        Raises:
            LibraryError: The automata form a cycle, which is spelled out, or one that is held is missing.
        """
        import networkx as nx  # noqa: PLC0415 - it takes 0.1 s, and the window is to be there before

        self.refuse_cycle()
        order = nx.lexicographical_topological_sort(self.graph().reverse(), key=lambda i: self.get(i).name)
        return tuple(self.get(i) for i in order)

    def refuse_cycle(self) -> None:
        """Raise a `LibraryError` that spells the cycle out, if there is one."""
        if found := self.cycle():
            raise LibraryError(f"recursion is not permitted, but {' holds '.join(found)}")

    def users(self, automaton_id: str) -> tuple[Automaton, ...]:
        """The automata that hold this one directly."""
        return tuple(a for a in self.automata.values() if automaton_id in a.nested())

    def all_users(self, automaton_id: str) -> frozenset[str]:
        """Ids of all automata that hold this one, directly or not."""
        import networkx as nx  # noqa: PLC0415 - it takes 0.1 s, and the window is to be there before

        graph = self.graph()
        return frozenset(nx.ancestors(graph, automaton_id)) if automaton_id in graph else frozenset()


def raised_flags(automaton: Automaton, vocabulary: Vocabulary) -> tuple[str, ...]:
    """The flags that *automaton* can raise, in the order of its states."""
    return tuple(
        dict.fromkeys(flag for state in automaton.states if (flag := _flag(state.content, vocabulary)))
    )


def _flag(content: object, vocabulary: Vocabulary) -> str | None:
    match content:
        case RaiseFlag(flag):
            return flag
        case Basic(name) if name in vocabulary.behaviors:
            return vocabulary.behaviors[name].raises
    return None


def known_flags(library: Library, vocabulary: Vocabulary) -> tuple[str, ...]:
    """The flags that nodes of a type can show: the standard ones, those its automata raise, and `finished`."""
    named = (flag for automaton in library.automata.values() for flag in raised_flags(automaton, vocabulary))
    return tuple(dict.fromkeys((*STANDARD_FLAGS, *named, FINISHED)))


class Types:
    """The node types of a project with their libraries, and the vocabulary that each can use.

    A controller's basic behaviors are those that all its subsidiaries' types share by name and signature (the names
    of the parameters, in order), derived automatically (paper, section 3.2).
    """

    def __init__(
        self, types: Iterable[NodeType], libraries: Mapping[str, Library], scenario: Vocabulary
    ) -> None:
        self.types = {node_type.name: node_type for node_type in types}
        self._libraries = libraries
        self._scenario = scenario
        self._vocabularies: dict[str, Vocabulary] = {}
        self._repertoires: dict[str, Mapping[str, Behavior]] = {}

    def library(self, type_name: str) -> Library:
        """The library of a type; empty if it has none."""
        return self._libraries.get(type_name, Library())

    def type(self, type_name: str) -> NodeType:
        """The type called *type_name*.

        Raises:
            LibraryError: There is none.
        """
        if type_name not in self.types:
            raise LibraryError(
                f"there is no node type {type_name!r}; there are: {', '.join(self.types) or 'none'}"
            )
        return self.types[type_name]

    def vocabulary(self, type_name: str) -> Vocabulary:
        """What automata of this type are made from."""
        if type_name not in self._vocabularies:
            self._vocabularies[type_name] = self._derive(self.type(type_name))
        return self._vocabularies[type_name]

    def repertoire(self, type_name: str) -> Mapping[str, Behavior]:
        """Everything a node of this type can be directed to do, by name."""
        if type_name not in self._repertoires:
            learned = {a.name: a for a in self.library(type_name).automata.values()}
            # A learned behavior hides a basic one of the same name.
            self._repertoires[type_name] = {**self.vocabulary(type_name).behaviors, **learned}
        return self._repertoires[type_name]

    def agent_features(self) -> Vocabulary:
        """The scenario's own vocabulary, whose agent features statistics are made of."""
        return self._scenario

    def _derive(self, node_type: NodeType) -> Vocabulary:
        targets = {n: t for n, t in self._scenario.targets.items() if t.level <= node_type.level}
        whose = "agent" if node_type.level == 0 else "group"
        features = {n: f for n, f in self._scenario.features.items() if f.whose == whose}
        behaviors = self._scenario.behaviors if node_type.level == 0 else self._shared(node_type)
        return Vocabulary(node_type.level, behaviors, features, targets)

    def _shared(self, node_type: NodeType) -> Mapping[str, BasicBehavior]:
        for name in node_type.subsidiaries:
            if self.type(name).level >= node_type.level:
                raise LibraryError(
                    f"{name!r} has level {self.type(name).level}, but under {node_type.name!r} "
                    f"it must be below {node_type.level}"
                )
        repertoires = [self.repertoire(name) for name in node_type.subsidiaries]
        if not repertoires:
            return {}
        first, *others = repertoires
        return {
            name: _derived(name, [r[name] for r in repertoires])
            for name, behavior in first.items()
            if all(name in r and r[name].parameters == behavior.parameters for r in others)
        }


def _derived(name: str, originals: list[Behavior]) -> BasicBehavior:
    once = any(isinstance(b, BasicBehavior) and b.runs_once for b in originals)
    doc = next((b.doc for b in originals if isinstance(b, BasicBehavior)), "")
    return BasicBehavior(name, originals[0].parameters, one_shot=once, derived=True, doc=doc)


def statistic_vocabulary(types: Types) -> Vocabulary:
    """The vocabulary that the inside of a statistic refers to: agent features of the scenario."""
    scenario = types.agent_features()
    features = {n: f for n, f in scenario.features.items() if f.whose == "agent"}
    return Vocabulary(0, scenario.behaviors, features, scenario.targets)
