"""Where states stand and how edges run: pure geometry in pixels, y downward."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from math import hypot
from typing import Any

import numpy as np
from numpy.typing import NDArray

Point = tuple[float, float]
Size = tuple[float, float]
Counts = NDArray[np.int64]
#: Between states that are placed without Graphviz.
GAP = 56.0
#: How far apart two edges between the same states bow, and how far a loop stands out.
BOW, LOOP = 22.0, 26.0
CLOSE = 0.5
#: How much farther an edge may bow to go around states that stand in its way, the best first; how near it may come to them.
AROUND, BESIDE = (0.0, 45.0, -45.0, 90.0, -90.0, 150.0, -150.0, 220.0, -220.0), 6.0
#: Shares of an edge's way at which its words may stand, the best first.
STANDS = (0.5, 0.36, 0.64, 0.22, 0.78)
#: How far from an edge words stand that found no place on it.
ASIDE = 4.0
#: Where words of a loop may stand beside it, the best first: pixels to the right, and heights of them above or below.
RIGHT_OF_LOOP, ABOVE_LOOP = (0.0, 14.0, 28.0), (0.0, -0.5, 0.5, -0.8, 0.8)
#: Shares of a piece of an edge at which it is looked whether it runs through words; words upon words are as bad as so many.
LOOKS, UPON = tuple(k / 5 for k in range(6)), 20


@dataclass(frozen=True, slots=True)
class Request:
    """What is to be arranged.

    Attributes:
        nodes: Id, width and height of each state, Start first.
        edges: Source, target, and width and height of the label; 0 where none is shown.
    """

    nodes: tuple[tuple[str, float, float], ...]
    edges: tuple[tuple[str, str, float, float], ...]


@dataclass(frozen=True, slots=True)
class Run:
    """How an edge runs: cubic Bézier control points, 3n + 1 of them, and the middle of its label."""

    points: tuple[Point, ...]
    label: Point


@dataclass(frozen=True, slots=True)
class Arrangement:
    """Where the middle of each state is, and how edges run by source and target; *runs* may lack any of them."""

    places: Mapping[str, Point]
    runs: Mapping[tuple[str, str], Run] = field(default_factory=dict)


def from_dot(request: Request, answer: Mapping[str, Any]) -> Arrangement:
    """What the process answered, as an arrangement."""
    places = {node: _point(at) for node, at in answer["places"].items()}
    runs = {}
    for (source, target, *_), (points, label) in zip(request.edges, answer["edges"], strict=True):
        found = tuple(_point(at) for at in points)
        if len(found) >= 4 and len(found) % 3 == 1:
            runs[source, target] = Run(found, _point(label) if label else middle_of(found))
    return Arrangement(places, runs)


def _point(at: Sequence[float]) -> Point:
    return float(at[0]), float(at[1])


# ------------------------------------------------------------------------------------------ without Graphviz


def at_once(request: Request, known: Mapping[str, Point] | None = None) -> Arrangement:
    """States in rows by their distance from Start; those whose place is *known* stay there."""
    rows = _rows(request)
    sizes = {node: (width, height) for node, width, height in request.nodes}
    places: dict[str, Point] = {}
    y = 0.0
    for row in rows:
        x = -(sum(sizes[node][0] for node in row) + GAP * (len(row) - 1)) / 2
        for node in row:
            places[node] = x + sizes[node][0] / 2, y
            x += sizes[node][0] + GAP
        y += max(sizes[node][1] for node in row) + GAP
    kept = {node: at for node, at in (known or {}).items() if node in sizes}
    return Arrangement({**_clear(places, kept, sizes), **kept})


def _clear(
    places: Mapping[str, Point], kept: Mapping[str, Point], sizes: Mapping[str, Size]
) -> dict[str, Point]:
    """*places* of what is new, moved down until they cover nothing that is kept."""
    taken = [(at, sizes[node]) for node, at in kept.items()]
    found = {}
    for node, (x, start) in places.items():
        y = start
        if node not in kept:
            while any(_overlap((x, y), sizes[node], at, size) for at, size in taken):
                y += GAP / 2
            taken.append(((x, y), sizes[node]))
        found[node] = x, y
    return found


def _overlap(a: Point, size_a: Size, b: Point, size_b: Size, apart: float = 8.0) -> bool:
    near = [abs(a[i] - b[i]) < (size_a[i] + size_b[i]) / 2 + apart for i in range(2)]
    return all(near)


def _rows(request: Request) -> list[list[str]]:
    """Ids by their distance from the first; what cannot be reached comes last."""
    below: dict[str, list[str]] = {}
    for source, target, *_ in request.edges:
        below.setdefault(source, []).append(target)
    ids = [node for node, *_ in request.nodes]
    seen, rows = set(ids[:1]), [ids[:1]]
    while rows[-1]:
        following = dict.fromkeys(t for node in rows[-1] for t in below.get(node, ()) if t not in seen)
        seen |= following.keys()
        rows.append(list(following))
    rest = [node for node in ids if node not in seen]
    return [row for row in (*rows, rest) if row]


# -------------------------------------------------------------------------------------------- growing in place


def spread(
    places: Mapping[str, Point], sizes: Mapping[str, Size], grown: Mapping[str, Size]
) -> dict[str, Point]:
    """*places* with room for states that have *grown*: others move aside just as far, and none comes to overlap.

    Args:
        sizes: Of all states as they are closed; *grown* those of the open ones.
    """
    found = {node: list(at) for node, at in places.items()}
    for node, size in grown.items():
        for axis in (0, 1):
            extra = max(0.0, size[axis] - sizes[node][axis]) / 2
            for other, at in places.items():
                apart = at[axis] - places[node][axis]
                if other != node and abs(apart) >= (sizes[other][axis] + sizes[node][axis]) / 2 - CLOSE:
                    found[other][axis] += extra if apart > 0 else -extra
    return {node: (x, y) for node, (x, y) in found.items()}


# ------------------------------------------------------------------------------------------------ how edges run


def run_between(
    a: Point, size_a: Size, b: Point, size_b: Size, *, bow: float = 0.0, sideways: bool = False
) -> Run:
    """An edge from the border of one box to that of another, straight or to one side, where it leaves them *sideways*."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = hypot(dx, dy) or 1.0
    side = (-dy / length * bow, dx / length * bow)
    ahead = 0.0 if sideways else 1.0
    start = border(a, size_a, (dx * ahead + side[0] * 2, dy * ahead + side[1] * 2))
    end = border(b, size_b, (side[0] * 2 - dx * ahead, side[1] * 2 - dy * ahead))
    first = start[0] + (end[0] - start[0]) / 3 + side[0], start[1] + (end[1] - start[1]) / 3 + side[1]
    second = start[0] + (end[0] - start[0]) / 1.5 + side[0], start[1] + (end[1] - start[1]) / 1.5 + side[1]
    points = (start, first, second, end)
    return Run(points, middle_of(points))


def run_around(a: Point, size_a: Size, b: Point, size_b: Size, states: "Taken", *, bowed: bool) -> Run:
    """An edge between two boxes, as straight as it can be without running through *states*.

    Args:
        bowed: Another edge comes back: both keep to their sides.
    """
    found: list[tuple[int, Run]] = []
    for more in AROUND:
        if bowed and more < 0.0:
            continue
        bow = more + (BOW if bowed else 0.0)
        run = run_between(a, size_a, b, size_b, bow=bow, sideways=more != 0.0)
        through = int(states.upon(_along(run), (BESIDE, BESIDE)).sum()) if len(states) else 0
        if through == 0:
            return run
        found.append((through, run))
    return min(found, key=lambda each: each[0])[1]


def loop_of(a: Point, size: Size, label_width: float = 0.0) -> Run:
    """An edge from a box to itself, at its right side."""
    x, y = a[0] + size[0] / 2, a[1]
    points = (
        (x, y - 8),
        (x + LOOP * 0.5, y - LOOP),
        (x + LOOP, y - LOOP * 0.7),
        (x + LOOP, y),
        (x + LOOP, y + LOOP * 0.7),
        (x + LOOP * 0.5, y + LOOP),
        (x, y + 8),
    )
    return Run(points, (x + LOOP + 4 + label_width / 2, y))


def border(middle: Point, size: Size, toward: Point) -> Point:
    """Where the way from the middle of a box in a direction leaves it."""
    half_width, half_height = size[0] / 2, size[1] / 2
    shares = [
        half / abs(way)
        for half, way in ((half_width, toward[0]), (half_height, toward[1]))
        if abs(way) > 1e-9
    ]
    share = min(shares, default=0.0)
    return middle[0] + toward[0] * share, middle[1] + toward[1] * share


def middle_of(points: Sequence[Point]) -> Point:
    """The point halfway along a run of cubic pieces."""
    pieces = (len(points) - 1) // 3
    first = 3 * (pieces // 2)
    if pieces % 2 == 0:
        return points[first]
    a, b, c, d = points[first : first + 4]
    return (a[0] + 3 * b[0] + 3 * c[0] + d[0]) / 8, (a[1] + 3 * b[1] + 3 * c[1] + d[1]) / 8


class Taken:
    """What words at edges should not lie upon: middles and sizes."""

    def __init__(self, boxes: Iterable[tuple[Point, Size]] = ()) -> None:
        self._boxes = [(*middle, *size) for middle, size in boxes]

    def __len__(self) -> int:
        return len(self._boxes)

    def add(self, middle: Point, size: Size) -> None:
        """One more."""
        self._boxes.append((*middle, *size))

    def upon(self, stands: Sequence[Point], size: Size) -> Counts:
        """How many of these lie under words of a size, for each place where they may stand."""
        boxes = np.array(self._boxes).reshape(-1, 4)
        apart = np.abs(np.array(stands)[:, None] - boxes[:, :2])
        return (apart < (size + boxes[:, 2:]) / 2).all(axis=2).sum(axis=1)


def clear_of(run: Run, size: Size, taken: Taken) -> Run:
    """An edge of one piece, its label where it covers as little as possible of what is *taken*."""
    way = [_on_the_way(run.points, share) for share in STANDS]
    aside = size[0] / 2 + ASIDE
    stands = [(x + side, y) for side in (0.0, aside, -aside) for x, y in way]
    return Run(run.points, stands[int(taken.upon(stands, size).argmin())])


def loop_clear_of(run: Run, size: Size, others: Collection[Run], taken: Taken) -> Run:
    """A loop, its label where *others* run through as little of it as possible, and least upon what is *taken*."""
    x, y = run.label
    stands = [(x + right, y + share * size[1]) for right in RIGHT_OF_LOOP for share in ABOVE_LOOP]
    ways = Taken((at, (0.0, 0.0)) for other in others for at in _looked_at(other))
    covered = ways.upon(stands, size) + UPON * taken.upon(stands, size)
    return Run(run.points, stands[int(covered.argmin())])


def _looked_at(run: Run) -> list[Point]:
    """Points on the way of an edge."""
    points = np.array(run.points)
    pieces = np.stack([points[k : len(points) - 3 + k : 3] for k in range(4)])
    return [(x, y) for x, y in np.tensordot(_WEIGHTS, pieces, axes=1).reshape(-1, 2).tolist()]


def _along(run: Run) -> list[Point]:
    """Many points on the way of an edge of one piece, but those where it leaves its states."""
    return [(x, y) for x, y in (_WAY @ np.array(run.points)).tolist()]


def _weights(share: float) -> tuple[float, float, float, float]:
    """How much each point of a cubic piece counts at a share of its way."""
    left = 1.0 - share
    return left**3, 3 * left**2 * share, 3 * left * share**2, share**3


#: At all shares that are looked at.
_WEIGHTS = np.array([_weights(share) for share in LOOKS])
_WAY = np.array([_weights(k / 30) for k in range(3, 28)])


def _on_the_way(points: Sequence[Point], share: float) -> Point:
    """The point of a cubic piece at a share of its way."""
    weights = _weights(share)
    x, y = (
        sum(weight * point[axis] for weight, point in zip(weights, points, strict=True)) for axis in (0, 1)
    )
    return x, y


def shifted(run: Run, by: Point) -> Run:
    """*run* elsewhere."""
    points = tuple((x + by[0], y + by[1]) for x, y in run.points)
    return Run(points, (run.label[0] + by[0], run.label[1] + by[1]))


def extent(
    places: Mapping[str, Point], sizes: Mapping[str, Size], more: Iterable[Point] = ()
) -> tuple[Point, Point]:
    """The corners of the least box around states and further points."""
    xs, ys = [p[0] for p in more], [p[1] for p in more]
    for node, (x, y) in places.items():
        width, height = sizes[node]
        xs += [x - width / 2, x + width / 2]
        ys += [y - height / 2, y + height / 2]
    return (min(xs, default=0.0), min(ys, default=0.0)), (max(xs, default=0.0), max(ys, default=0.0))
