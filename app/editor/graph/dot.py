"""Graphviz in a process of its own: one request a line comes in, one arrangement a line goes out.

``python -m ...graph.dot`` serves until its input ends. Nothing of the window is loaded here.
"""

import json
import sys
from typing import Any

#: Graphviz measures in points and, for nodes, in inches of 72 points; a pixel is taken for a point.
INCH = 72.0
#: Room for the words of a transition that is still to be drawn.
ROOM = (72.0, 30.0)
GRAPH = {"rankdir": "TB", "nodesep": 0.2, "ranksep": 0.36, "splines": "true", "outputorder": "nodesfirst"}


def arranged(request: dict[str, Any]) -> dict[str, Any]:
    """Where ``dot`` puts nodes, edges and labels: y downward, the middle of the picture at (0, 0).

    Args:
        request: ``nodes``: [id, width, height]; ``edges``: [source, target, label width, label height].
    """
    import pygraphviz  # noqa: PLC0415 - whoever only wants the module's name need not have it loaded

    graph = pygraphviz.AGraph(directed=True, strict=False, **GRAPH)
    graph.node_attr.update(shape="box", fixedsize="true", label="")
    graph.edge_attr.update(arrowhead="none")
    names = {node[0]: f"n{number}" for number, node in enumerate(request["nodes"])}
    for node_id, width, height in request["nodes"]:
        graph.add_node(names[node_id], width=width / INCH, height=height / INCH)
    for number, edge in enumerate(request["edges"]):
        _add_edge(graph, names, number, edge)
    for number, node in enumerate(not_reached(request)):
        _add_edge(graph, names, -1 - number, [request["nodes"][0][0], node, *ROOM], style="invis")
    graph.layout(prog="dot")
    return _answer(graph, names, request)


def not_reached(request: dict[str, Any]) -> list[str]:
    """Where transitions are still to lead, so that all states can be reached from the first: these stand below it."""
    after: dict[str, list[str]] = {node: [] for node, *_ in request["nodes"]}
    for source, target, *_ in request["edges"]:
        after[source].append(target)
    seen: set[str] = set()
    wanting = []
    for node in after:  # the first one comes first
        if node not in seen:
            wanting.append(node)
        waiting = [node]
        while waiting:
            here = waiting.pop()
            waiting += [] if here in seen else after[here]
            seen.add(here)
    return wanting[1:]


def _add_edge(graph: Any, names: dict[str, str], number: int, edge: list[Any], **attributes: str) -> None:
    source, target, width, height = edge
    if width > 0:
        size = f'FIXEDSIZE="TRUE" WIDTH="{width:.0f}" HEIGHT="{height:.0f}"'
        attributes["label"] = f'<<TABLE BORDER="0" CELLPADDING="0" {size}><TR><TD></TD></TR></TABLE>>'
    graph.add_edge(names[source], names[target], key=f"e{number}", **attributes)


def _answer(graph: Any, names: dict[str, str], request: dict[str, Any]) -> dict[str, Any]:
    left, bottom, right, top = map(float, graph.graph_attr["bb"].split(","))
    middle = (left + right) / 2, (bottom + top) / 2

    def point(text: str) -> list[float]:
        x, y = text.removeprefix("e,").removeprefix("s,").split(",")[:2]
        return [round(float(x) - middle[0], 1), round(middle[1] - float(y), 1)]

    edges = []
    for number, (source, target, *_) in enumerate(request["edges"]):
        attributes = graph.get_edge(names[source], names[target], key=f"e{number}").attr
        label = attributes["lp"]
        points = [point(text) for text in attributes["pos"].split() if "," in text]
        edges.append([points, point(label) if label else None])
    places = {node_id: point(graph.get_node(name).attr["pos"]) for node_id, name in names.items()}
    return {"places": places, "edges": edges}


def serve() -> None:
    """Answer requests, each a JSON object in a line with a ``number``, until there are no more."""
    for line in sys.stdin:
        request = json.loads(line)
        try:
            answer = arranged(request)
        except Exception as error:  # noqa: BLE001 - whatever it is, the window draws without it and says so
            answer = {"problem": f"{type(error).__name__}: {error}"}
        print(json.dumps({"number": request["number"], **answer}), flush=True)  # noqa: T201 - the answer


if __name__ == "__main__":
    serve()
