"""Who left which state by itself, remembered during a test so that it can be mended afterwards."""

from collections.abc import Callable
from dataclasses import dataclass

from ..core.automaton import START
from ..core.examples import Moment
from .recording import Values

#: Moments are kept until they describe this many nodes altogether, at some 2 kB a node.
MOST_NODES = 20_000


@dataclass(frozen=True, slots=True)
class Departure:
    """A node left a state by itself: when, and what it saw."""

    state: str
    values: Values
    tick: int


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
        self._last: dict[str, Departure] = {}
        self._moments: dict[int, Moment] = {}  # by tick, in order

    def note(self, node_id: str, departure: Departure) -> None:
        """A node is about to leave a state. The moment is taken once a tick, when the first node leaves."""
        if departure.state == START:
            return
        self._last[node_id] = departure
        if departure.tick not in self._moments:
            if len(self._moments) >= self._most:
                self._tidy()
            self._moments[departure.tick] = self._take()

    def _tidy(self) -> None:
        """Forget moments that nobody's last departure refers to, and the oldest of too many."""
        used = {departure.tick for departure in self._last.values()}
        kept = [(tick, moment) for tick, moment in self._moments.items() if tick in used]
        self._moments = dict(kept[-(self._most // 2) :] if self._most > 1 else ())

    def last(self, node_id: str) -> Departure | None:
        """The last departure of a node, unless it was mended."""
        return self._last.get(node_id)

    def moment(self, departure: Departure) -> Moment | None:
        """The moment of a departure; None if it was long ago, among too many nodes to keep it."""
        return self._moments.get(departure.tick)

    def mended(self, node_id: str) -> None:
        """The last departure of a node has been mended."""
        self._last.pop(node_id, None)

    def restore(self, node_id: str, departure: Departure) -> None:
        """The departure has not been mended after all."""
        self._last[node_id] = departure
