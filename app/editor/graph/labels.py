"""What stands at an edge, and what its tool tip says."""

from dataclasses import dataclass
from html import escape

from ...core.automaton import Automaton
from ...core.phrasing import number
from ...export.graph import Edge, Way, WayKind, formal_words, way_words


@dataclass(frozen=True, slots=True)
class Label:
    """Two lines: when, and how sure."""

    when: str
    how: str


def label_of(edge: Edge) -> Label:
    """What stands at an edge: its first way that can be gone, and how many more of these there are; else its first."""
    ways = [way for way in edge.ways if way.is_open] or list(edge.ways)
    untold = 0 if all(way.kind is WayKind.RULE for way in ways) else edge.more  # all of them learned
    first, others = ways[0], len(ways) - 1 + untold
    more = f", or {others} more" if others else ""
    return Label(first.words + more, _how(edge, first, many=others > 0))


def _how(edge: Edge, first: Way, *, many: bool) -> str:
    if first.kind is WayKind.RULE:
        orders = [str(way.order) for way in edge.rules]
        rules = f"rule{'s' if len(orders) > 1 else ''} {', '.join(orders)}"
        learned = f" · {_supporting(edge)}" if edge.support else ""
        return rules + (" · never reached" if first.shadowed else "") + learned
    if first.prunes:
        return "pruned"
    if many:
        return _supporting(edge)
    p = f"{first.probability:.1f}" if first.probability in (0.0, 1.0) else number(first.probability, 2)
    ending = " · rules decide" if first.shadowed else f" · p {p}"
    return f"{number(first.support)} of {number(first.total)}{ending}"


def _supporting(edge: Edge) -> str:
    return f"{number(edge.support)} example{'' if edge.support == 1.0 else 's'}"


#: A space at which no line is broken.
SPACE = "\u00a0"


def tip_of(edge: Edge, automaton: Automaton, names: tuple[str, str]) -> str:
    """All ways of an edge, each with its tests and their numbers."""
    lines = [f"<b>{escape(names[0])} → {escape(names[1])}</b>"]
    for way in edge.ways:
        lines.append(escape(way_words(way)).replace(" · p ", f"{SPACE}· p{SPACE}"))
        tests = " and ".join(formal_words(condition, automaton) for condition in way.guard)
        if tests:
            lines.append(f"<small>{escape(tests)}</small>")
    if edge.more:
        lines.append(f"and {edge.more} more ways that fewer examples speak for")
    return "<br>".join(lines)
