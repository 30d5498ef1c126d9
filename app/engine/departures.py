"""Who left which state by itself, remembered during a test so that it can be mended afterwards."""

from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

from ..core.automaton import START
from ..core.examples import Moment
from .recording import Values

#: Moments are kept until they describe this many nodes altogether, at some 2 kB a node.
MOST_NODES = 20_000
#: Ticks that nobody has asked about are kept until they describe this many, at some 600 bytes a node.
MOST_UNASKED = 100_000


@dataclass(frozen=True, slots=True)
class Departure:
    """A node left a state by itself: when, and what it saw."""

    state: str
    values: Values
    tick: int


class Unasked(Protocol):
    """A tick in which nodes left states, of which what they saw is found out when somebody asks.

    Attributes:
        nodes: Those nodes, in the order in which they left.
    """

    tick: int
    nodes: Sequence[str]

    def departure(self, node_id: str) -> Departure:
        """What a node left, and what it saw."""

    def moment(self) -> Moment:
        """The moment in which the first of them left."""


class Departures:
    """The state that each node left by itself last, and the moments in which that happened.

    Start is not remembered: no example leads to it, so nobody could have been to stay there.
    """

    def __init__(self, take: Callable[[], Moment], nodes: int) -> None:
        """Remember nothing yet.

        Args:
            take: Gives the moment that is now.
            nodes: How many nodes a moment describes.
        """
        self._take = take
        self._most = max(1, min(2 * nodes, MOST_NODES // nodes))
        self._most_unasked = max(1, MOST_UNASKED // nodes)
        self._last: dict[str, Departure | Unasked] = {}
        self._moments: dict[int, Moment | Unasked] = {}  # by tick, in order
        self._unasked: deque[Unasked] = deque()

    def note(self, node_id: str, departure: Departure) -> None:
        """A node is about to leave a state. The moment is taken once a tick, when the first node leaves."""
        if departure.state == START:
            return
        self._last[node_id] = departure
        if departure.tick not in self._moments:
            self._make_room()
            self._moments[departure.tick] = self._take()

    def note_unasked(self, past: Unasked) -> None:
        """Nodes have left states other than Start in a tick that has passed."""
        for node_id in past.nodes:
            self._last[node_id] = past
            if past.tick not in self._moments:
                self._make_room()
                self._moments[past.tick] = past
        self._unasked.append(past)
        if len(self._unasked) > self._most_unasked:
            self._ask(self._unasked.popleft())

    def _make_room(self) -> None:
        if len(self._moments) >= self._most:
            self._tidy()

    def _tidy(self) -> None:
        """Forget moments that nobody's last departure refers to, and the oldest of too many."""
        used = {departure.tick for departure in self._last.values()}
        kept = [(tick, moment) for tick, moment in self._moments.items() if tick in used]
        self._moments = dict(kept[-(self._most // 2) :] if self._most > 1 else ())

    def _ask(self, past: Unasked) -> None:
        """Keep what nodes saw in a tick instead of the tick."""
        for node_id in past.nodes:
            if self._last.get(node_id) is past:
                self._last[node_id] = past.departure(node_id)

    def last(self, node_id: str) -> Departure | None:
        """The last departure of a node, unless it was mended."""
        found = self._last.get(node_id)
        if found is None or isinstance(found, Departure):
            return found
        departure = self._last[node_id] = found.departure(node_id)
        return departure

    def moment(self, departure: Departure) -> Moment | None:
        """The moment of a departure; None if it was long ago, among too many nodes to keep it."""
        found = self._moments.get(departure.tick)
        if found is None or isinstance(found, Moment):
            return found
        moment = self._moments[departure.tick] = found.moment()
        return moment

    def mended(self, node_id: str) -> None:
        """The last departure of a node has been mended."""
        self._last.pop(node_id, None)

    def restore(self, node_id: str, departure: Departure) -> None:
        """The departure has not been mended after all."""
        self._last[node_id] = departure
