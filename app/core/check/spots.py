"""What a problem is about, by ids: the way from a place in a file to what a window can show."""

import re
from dataclasses import dataclass, replace

from ..automaton import Automaton
from ..project import Project
from .problem import PROJECT_FILE, Problem

_FILE = re.compile(r"(libraries|examples)/(?P<type>.+)/(?P<id>[^/]+)\.json")
_DEMONSTRATION = re.compile(r"demonstrations/(?P<id>.+)\.json")
_ITEM = re.compile(r"(?P<list>\w+)\[(?P<at>\d+)\]")
_LEARNED = re.compile(r"learned(\.(?P<plain>\w+)|\[\"(?P<quoted>[^\"]+)\"\])")
_NODE = re.compile(r", node '(?P<id>.+)'$")


@dataclass(frozen=True, slots=True)
class Spot:
    """What a problem is about; what does not apply is empty.

    Attributes:
        type, automaton: A behavior, by node type and id.
        state, feature, rule, prune, example: Parts of it, by id; of a rule or prune also the state it belongs to.
        arm, node: An arm by name, and a node of it by id.
        node_type: A node type by name.
        demonstration: One by id.
        part: The rest of the place: ``content.bindings``.
    """

    type: str = ""
    automaton: str = ""
    state: str = ""
    feature: str = ""
    rule: str = ""
    prune: str = ""
    example: str = ""
    arm: str = ""
    node: str = ""
    node_type: str = ""
    demonstration: str = ""
    part: str = ""

    @property
    def words(self) -> str:
        """Where that is, in few words, by ids."""
        if self.arm:
            return f"arm {self.arm}"
        if self.demonstration:
            return f"demonstration {self.demonstration}"
        return self.node_type or self.type or "project"


def spot_of(problem: Problem, project: Project) -> Spot:
    """What *problem* of *project* is about, as far as that is there."""
    if found := _FILE.fullmatch(problem.file):
        spot = Spot(type=found["type"], automaton=found["id"])
        automaton = project.library(spot.type).automata.get(spot.automaton)
        return spot if automaton is None else _inside(problem.where, spot, automaton, project)
    if found := _DEMONSTRATION.fullmatch(problem.file):
        return Spot(demonstration=found["id"])
    if problem.file == PROJECT_FILE and (item := _ITEM.match(problem.where)):
        return _of_project(problem.where, item["list"], int(item["at"]), project)
    return Spot()


def _inside(where: str, spot: Spot, automaton: Automaton, project: Project) -> Spot:
    """A part of an automaton or of its examples."""
    if found := _LEARNED.match(where):
        return replace(spot, state=found["plain"] or found["quoted"])
    item = _ITEM.match(where)
    if item is None:
        return replace(spot, part=where)
    at, spot = int(item["at"]), replace(spot, part=where[item.end() :].lstrip("."))
    examples = project.examples_of(spot.type, spot.automaton)
    match item["list"]:
        case "states" if at < len(automaton.states):
            return replace(spot, state=automaton.states[at].id)
        case "features" if at < len(automaton.features):
            return replace(spot, feature=automaton.features[at].id)
        case "rules" if at < len(automaton.rules):
            return replace(spot, rule=automaton.rules[at].id, state=automaton.rules[at].source)
        case "prunes" if at < len(automaton.prunes):
            return replace(spot, prune=automaton.prunes[at].id, state=automaton.prunes[at].source)
        case "examples" if at < len(examples):
            return replace(spot, example=examples[at].id, state=examples[at].source)
    return replace(spot, part=where)


def _of_project(where: str, listed: str, at: int, project: Project) -> Spot:
    if listed == "arms" and at < len(project.arms):
        node = _NODE.search(where)
        part = where.partition("].")[2]
        return Spot(arm=project.arms[at].name, node=node["id"] if node else "", part=part)
    if listed == "types" and at < len(project.types):
        return Spot(node_type=project.types[at].name)
    return Spot()
