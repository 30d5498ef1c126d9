"""One automaton as it is shown, with those that are open in its states: what is drawn, apart from how."""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass

from ...core.automaton import Automaton
from ...core.project import Positions
from ...export.graph import AutomatonGraph, Edge
from .arrangement import (
    Arrangement,
    Point,
    Request,
    Run,
    Size,
    Taken,
    clear_of,
    extent,
    loop_clear_of,
    loop_of,
    middle_of,
    run_around,
    shifted,
    spread,
)
from .edge_item import label_size
from .labels import Label, label_of
from .state_item import HEADER, HEIGHT, PADDING, Path, closed_size

#: What stands at edges, by source and target.
Labels = Mapping[tuple[str, str], Label]
#: With more edges than this, labels are shown only where the pointer is.
MOST_LABELED = 30
#: Two places are the same if they are no farther apart.
SAME = 1.5


@dataclass(frozen=True, slots=True)
class Drawn:
    """An automaton as it is to be drawn.

    Attributes:
        path: State ids from the automaton that is shown down to the state that holds this one; none for itself.
        sizes: Of the states, open ones with what is inside.
        base: Where states stand while all are closed.
        places: Where they stand now.
        inner: What is open, by state.
        corners: Of the least box around all of it.
        is_settled: Its arrangement is the one that Graphviz found, not a makeshift.
    """

    path: Path
    type: str
    automaton: Automaton
    graph: AutomatonGraph
    labels: Labels
    request: Request
    sizes: Mapping[str, Size]
    base: Mapping[str, Point]
    places: Mapping[str, Point]
    runs: Mapping[tuple[str, str], Run]
    inner: Mapping[str, "Drawn"]
    corners: tuple[Point, Point]
    is_settled: bool
    is_labeled: bool

    @property
    def edges(self) -> Mapping[tuple[str, str], Edge]:
        """Its edges by source and target."""
        return {(edge.source, edge.target): edge for edge in self.graph.edges}

    def looks_like(self, other: "Drawn") -> bool:
        """Whether all that is drawn of another one is the same; what it was worked out from may differ."""
        if self.graph is not other.graph or self.inner.keys() != other.inner.keys():
            return False
        return self.look == other.look and all(
            drawn.looks_like(other.inner[state]) for state, drawn in self.inner.items()
        )

    @property
    def look(self) -> tuple[object, ...]:
        """What is drawn of the automaton itself, apart from its graph."""
        return self.path, self.type, self.sizes, self.places, self.runs, self.is_labeled

    def offset(self, state: str) -> Point:
        """Where (0, 0) of what is open in a state lies, from the middle of that state."""
        (left, top), (right, bottom) = self.inner[state].corners
        return -(left + right) / 2, -(top + bottom) / 2 + HEADER / 2

    def rerouted(self, places: Mapping[str, Point], state: str) -> dict[tuple[str, str], Run]:
        """How the edges of one state run while it is dragged."""
        touching = [edge for edge in self.graph.edges if state in (edge.source, edge.target)]
        states = _in_the_way(self.graph, places, self.sizes)
        return {
            (e.source, e.target): _own_run(e, self.graph.edges, self.sizes, places, self.labels, states)
            for e in touching
        }


@dataclass(frozen=True, slots=True)
class Drafting:
    """Where what is drawn comes from.

    Attributes:
        automaton: An automaton of the type by id, if it is there.
        graph: The graph of an automaton.
        layout: Where the user put states of an automaton.
        arrange: The arrangement of a request, and whether it is settled.
        open: Paths of the states that are open.
    """

    type: str
    automaton: Callable[[str], Automaton | None]
    graph: Callable[[Automaton], AutomatonGraph]
    layout: Callable[[str], Positions]
    arrange: Callable[[str, Request], tuple[Arrangement, bool]]
    open: Collection[Path]

    def drawn(self, automaton: Automaton, path: Path = ()) -> Drawn:
        """An automaton with all that is open in it."""
        graph = self.graph(automaton)
        inner = {}
        for state in graph.states:
            here = (*path, state.id)
            held = self.automaton(state.nested) if state.nested and here in self.open else None
            if held is not None:
                inner[state.id] = self.drawn(held, here)
        return self._placed(automaton, path, graph, inner)

    def _placed(
        self, automaton: Automaton, path: Path, graph: AutomatonGraph, inner: Mapping[str, Drawn]
    ) -> Drawn:
        closed = {state.id: closed_size(state) for state in graph.states}
        labels = {(edge.source, edge.target): label_of(edge) for edge in graph.edges}
        labeled = len(graph.edges) <= MOST_LABELED
        request = request_for(graph, closed, labels, labeled=labeled)
        arrangement, settled = self.arrange(automaton.id, request)
        layout = self.layout(automaton.id)
        base = {state: layout.get(state, at) for state, at in arrangement.places.items()}
        grown = {state: _open_size(drawn, closed[state]) for state, drawn in inner.items()}
        sizes = {**closed, **grown}
        places = spread(base, closed, grown)
        runs = _runs(graph, arrangement, sizes, places, labels)
        runs = _apart(runs, labels, [(places[state], sizes[state]) for state in places]) if labeled else runs
        points = [point for run in runs.values() for point in run.points]
        if labeled:
            points += [corner for key, run in runs.items() for corner in _corners(run.label, labels[key])]
        corners = extent(places, sizes, points)
        return Drawn(
            path,
            self.type,
            automaton,
            graph,
            labels,
            request,
            sizes,
            base,
            places,
            runs,
            inner,
            corners,
            settled,
            labeled,
        )


def request_for(
    graph: AutomatonGraph,
    sizes: Mapping[str, Size],
    labels: Labels,
    *,
    labeled: bool,
) -> Request:
    """What is to be arranged of a graph."""

    def size(edge: Edge) -> Size:
        width, height = label_size(labels[edge.source, edge.target]) if labeled else (0.0, 0.0)
        return round(width, 1), round(height, 1)

    return Request(
        tuple((state.id, *sizes[state.id]) for state in graph.states),
        tuple((edge.source, edge.target, *size(edge)) for edge in graph.edges),
    )


def _open_size(inner: Drawn, closed: Size) -> Size:
    (left, top), (right, bottom) = inner.corners
    width, height = right - left + 2 * PADDING, bottom - top + 2 * PADDING + HEADER
    return max(closed[0], width), max(HEIGHT, height)


def _corners(middle: Point, label: Label) -> tuple[Point, Point]:
    width, height = label_size(label)
    x, y = middle
    return (x - width / 2, y - height / 2), (x + width / 2, y + height / 2)


def _runs(
    graph: AutomatonGraph,
    arrangement: Arrangement,
    sizes: Mapping[str, Size],
    places: Mapping[str, Point],
    labels: Labels,
) -> dict[tuple[str, str], Run]:
    """Graphviz's runs where both ends moved alike since then, our own elsewhere."""
    found, states = {}, _in_the_way(graph, places, sizes)
    for edge in graph.edges:
        key = edge.source, edge.target
        run = arrangement.runs.get(key)
        moved = [_moved(arrangement.places[end], places[end]) for end in key]
        as_arranged = all(sizes[end][1] == HEIGHT for end in key)
        if run is not None and as_arranged and _same(*moved):
            found[key] = shifted(run, moved[0])
        else:
            found[key] = _own_run(edge, graph.edges, sizes, places, labels, states)
    return found


def _in_the_way(graph: AutomatonGraph, places: Mapping[str, Point], sizes: Mapping[str, Size]) -> Taken:
    """Where states stand that edges go around; so many edges that none has words run straight, which takes no time."""
    around = places if len(graph.edges) <= MOST_LABELED else {}
    return Taken((at, sizes[state]) for state, at in around.items())


def _apart(
    runs: Mapping[tuple[str, str], Run], labels: Labels, states: Sequence[tuple[Point, Size]]
) -> dict[tuple[str, str], Run]:
    """Labels cover neither states nor each other, as far as there is room; of Graphviz's, only those of loops are moved."""
    taken, found = Taken(states), {}
    for key, run in runs.items():
        size = label_size(labels[key])
        straight = len(run.points) == 4 and run.label == middle_of(run.points)
        found[key] = clear_of(run, size, taken) if straight else run
        taken.add(found[key].label, size)
    return {
        key: run if key[0] != key[1] else _loop_apart(key, found, labels, states)
        for key, run in found.items()
    }


def _loop_apart(
    loop: tuple[str, str],
    runs: Mapping[tuple[str, str], Run],
    labels: Labels,
    states: Sequence[tuple[Point, Size]],
) -> Run:
    """A loop with its label beside what else goes to its state or comes from it: Graphviz leaves these out of account."""
    others = {key: run for key, run in runs.items() if key != loop}
    taken = Taken([*states, *((run.label, label_size(labels[key])) for key, run in others.items())])
    at_its_state = [run for key, run in others.items() if loop[0] in key]
    return loop_clear_of(runs[loop], label_size(labels[loop]), at_its_state, taken)


def _moved(before: Point, after: Point) -> Point:
    return after[0] - before[0], after[1] - before[1]


def _same(a: Point, b: Point) -> bool:
    return abs(a[0] - b[0]) <= SAME and abs(a[1] - b[1]) <= SAME


def _own_run(
    edge: Edge,
    edges: Collection[Edge],
    sizes: Mapping[str, Size],
    places: Mapping[str, Point],
    labels: Labels,
    states: Taken,
) -> Run:
    source, target = edge.source, edge.target
    if source == target:
        return loop_of(places[source], sizes[source], label_size(labels[source, target])[0])
    back = any(other.source == target and other.target == source for other in edges)
    return run_around(places[source], sizes[source], places[target], sizes[target], states, bowed=back)
