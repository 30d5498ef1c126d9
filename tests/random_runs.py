"""Random runs of the playground, for engines that must agree on every one."""

from dataclasses import replace
from random import Random

from app.core.actor import Actor, Run
from app.core.automaton import START, Automaton, Basic, Rule, Sampling, State
from app.core.automaton import Start as StartContent
from app.core.conditions import AtMost, Condition
from app.core.features import (
    Bindings,
    FeatureUse,
    Ground,
    Operation,
    Over,
    Parameter,
    Sense,
    Source,
    Statistic,
)
from app.core.hierarchy import from_table
from app.core.library import Library, NodeType, Types
from app.core.machine import Senses
from app.core.machine_state import freeze
from app.core.vocabulary import FINISHED, Vocabulary
from app.sim.engine import Engine, Start
from app.sim.reference import ReferenceEngine
from tests.playground import scenario as playground
from tests.random_automata import FLAGS, direct_roots, random_forest, random_types

TYPES = (
    NodeType("child"),
    NodeType("group", 1, ("child",)),
    NodeType("school", 2, ("group", "child")),
)


def harmless() -> Vocabulary:
    """What can be done and seen in the playground, without what is there to go wrong."""
    full = playground.vocabulary
    return Vocabulary(
        0,
        {name: b for name, b in full.behaviors.items() if name != "Swing"},
        {name: f for name, f in full.features.items() if name != "Doubt"},
        {name: t for name, t in full.targets.items() if name != "somebody"},
    )


def playing_types(random: Random) -> Types:
    """Libraries of automata up to three levels deep for children, groups and schools."""
    return random_types(random, harmless(), TYPES, reach=8.0)


def random_start(seed: int) -> Start:
    """A run that is ready to begin; the roots idle."""
    random = Random(seed)
    parameters = {
        "stones": random.randrange(5),
        "slippery": random.random() < 0.5,
        "ground": random.choice(("flat", "hilly")),
    }
    types, forest = playing_types(random), random_forest(random, TYPES)
    return Start(playground, playground.settle(parameters), forest, types, random.randrange(1 << 62))


def two_owners() -> Start:
    """A school and a group both bind "last" for the same child, which looks at both: who means whom matters."""
    slots = {"a": Parameter("goal"), "b": Parameter("other")}
    gap = FeatureUse("gap", Sense("Gap", slots))
    child = Automaton(
        "child 2",
        "child 2",
        ("goal", "other"),
        (State(START, StartContent()), State("near", Basic("Between", slots)), State("far", Basic("Take"))),
        (gap,),
        tuple(
            Rule(f"{source}-{goal}", source, (Condition(AtMost("gap", 2.0), wanted),), goal)
            for source in (START, "near", "far")
            for goal, wanted in (("near", True), ("far", False))
        ),
    )
    group = _passes_on("group 2", "child 2", ("goal",), {"goal": Parameter("goal"), "other": Ground("last")})
    school = _passes_on("school 2", "group 2", (), {"goal": Ground("last")})
    made = {name: Library({a.id: a}) for name, a in (("child", child), ("group", group), ("school", school))}
    schools = replace(TYPES[2], subsidiaries=("group",))
    types = Types((*TYPES[:2], schools), made, playground.vocabulary)
    forest = from_table((1, 2, 3), ("school", "group", "child"))
    return Start(playground, playground.settle({}), forest, types, 1, top="school 2")


def _passes_on(name: str, behavior: str, parameters: tuple[str, ...], bindings: Bindings) -> Automaton:
    """A controller's automaton that directs one thing for good."""
    states = (State(START, StartContent()), State("go", Basic(behavior, bindings)))
    return Automaton(name, name, parameters, states, rules=(Rule("1", START, (), "go"),))


def begin(engine: Engine, seed: int) -> None:
    """Let every root do something, the same in each engine."""
    direct_roots(engine.machine, Random(seed))


# -------------------------------------------------------------------------------------------- comparing


def difference(found: Engine, wanted: Engine) -> str:
    """The first quantity in which two engines differ, or nothing."""
    world, right = found.frozen_world(), wanted.frozen_world()
    for name, column in right.items():
        for entity, value in enumerate(column):
            if repr(world[name][entity]) != repr(value):
                return f"{name} of entity {entity} is {world[name][entity]!r}, not {value!r}"
    nodes, rightly = freeze(found.machine)["nodes"], freeze(wanted.machine)["nodes"]
    for node, does in rightly.items():
        for what, value in does.items():
            if nodes[node][what] != value:
                return f"{what} of node {node} is {nodes[node][what]!r}, not {value!r}"
    return ""


def compare(found: Engine, wanted: ReferenceEngine, ticks: int) -> None:
    """Pass ticks in both engines; they must agree after each."""
    assert difference(found, wanted) == ""
    for _ in range(ticks):
        tick = wanted.tick
        found.step()
        wanted.step()
        differs = difference(found, wanted)
        assert not differs, f"after tick {tick}: {differs}"


# --------------------------------------------------------------------------------------- what was reached


class Witness:
    """Notes what happens in a reference engine's runs.

    Attributes:
        reached: Words for what happened at least once.
    """

    def __init__(self) -> None:
        self.reached: set[str] = set()

    def watch(self, engine: ReferenceEngine) -> None:
        """Note what is sensed from now on."""
        machine = engine.machine
        plain = machine.value

        def noted(actor: Actor, run: Run, use: FeatureUse, senses: Senses) -> float:
            value = plain(actor, run, use, senses)
            self.reached.add(f"{_sort(use.source)} {'zero' if value == 0.0 else 'not zero'}")
            if isinstance(use.source, Sense | Statistic):
                self.reached.add(_name(use.source))
            return value

        machine.value = noted  # type: ignore[method-assign]  # to listen in

    def look(self, engine: ReferenceEngine) -> None:
        """Note what the nodes do and hold after a tick."""
        for actor in engine.machine.actors.values():
            level = actor.node.level
            self.reached |= {f"{flag} on level {level}" for flag in actor.flags}
            run, depth = actor.run, 0
            while run is not None:
                self.reached |= {f"{flag} on level {level}" for flag in run.flags}
                if isinstance(run.behavior, Automaton):
                    if run.entered == engine.tick - 1 and run.child is not None:
                        self.reached.add(f"transition of depth {depth} on level {level}")
                    if run.key is not None:
                        self.reached.add(f"{run.behavior.settings.sampling.value} on level {level}")
                run, depth = run.child, depth + 1
        if any(holds >= 0 for holds in engine.world.holds):
            self.reached.add("a child holds a stone")
        if engine.world.dropped[0] > 0:
            self.reached.add("a stone is in the pit")


def _sort(source: Source) -> str:
    if isinstance(source, Statistic):
        return f"{source.operation.value} {_sort(source.of)}"
    return type(source).__name__


def _name(source: Sense | Statistic) -> str:
    if isinstance(source, Statistic):
        return f"{source.over.value}: {_name(source.of) if isinstance(source.of, Sense) else source.of.flag}"
    return source.feature


def everything() -> set[str]:
    """What runs have to reach so that comparing them means something."""
    sources = {"Sense", "FlagUp", "TicksInState"}
    sources |= {f"{operation.value} {of}" for operation in Operation for of in ("Sense", "FlagUp")}
    wanted = {f"{source} {value}" for source in sources for value in ("zero", "not zero")}
    wanted |= set(harmless().features)
    agent = [name for name, f in harmless().features.items() if f.whose == "agent"]
    wanted |= {f"{over.value}: {of}" for over in Over for of in (*agent, *FLAGS, FINISHED)}
    wanted |= {f"{flag} on level {level}" for flag in FLAGS for level in range(3)}
    wanted |= {f"transition of depth {depth} on level {level}" for depth in range(3) for level in range(3)}
    wanted |= {f"{sampling.value} on level {level}" for sampling in Sampling for level in range(3)}
    return wanted | {"finished on level 0", "a child holds a stone", "a stone is in the pit"}
