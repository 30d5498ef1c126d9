"""The counterpart of a hierarchy of behaviors: one flat automaton, taught by the same demonstrations.

A person who taught without decomposition would have picked basic behaviors: go ahead, turn, grab, let go. So the
demonstrations of all behaviors that an arm is made of are played again, and every change of basic behavior of a node in
training mode becomes a pick of the flat automaton, with the examples that the teaching session records for a pick:
<B, f, B'>, and <B', f, B'> unless B' runs once. What this flatters and what it does not:

* The changes that trained parts of the hierarchy make by themselves while the person teaches what is built on them count
  as picks, too. The flat learner is given more, and more consistent, picks than the person made.
* Its features are all that any of those behaviors looks at, a parameter bound to each target that it is bound to
  anywhere, and the ticks since the basic behavior changed. Flags of sub-behaviors do not exist here.
* Basic behaviors that only raise a flag for a behavior above (Done) are left out: they do nothing in the world. One that
  also acts (ReleaseBoxAndFinish) is kept; as always, the automaton begins anew in Start after it.
* The demonstrations of parts are not one journey: that of going to the deposit says so although no box is held.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, replace
from functools import wraps
from typing import Any

from ...core.automaton import START, Automaton, Basic, Nested, State
from ...core.errors import ParameterError
from ...core.examples import Example
from ...core.features import Bindings, FeatureUse, Ground, Sense, TicksInState, declaration, describe
from ...core.library import Library
from ...core.naming import slug
from ...core.project import Arm, Demonstration, Project
from ...core.vocabulary import NO_ENTITY, BasicBehavior
from ...sim.scenario import Scenario, World
from ...sim.sensing import WorldSenses
from ..demonstrations import recreate
from .learning import behaviors_in_use

#: What the flat automaton is called.
NAME = "Flat"
TICKS = FeatureUse("ticks", TicksInState())
#: Place of the tick in a world's clock.
NOW = 2


@dataclass(frozen=True, slots=True)
class Flat:
    """The flat automaton, which has learned nothing yet, and the examples to learn from."""

    automaton: Automaton
    examples: tuple[Example, ...]


@dataclass(frozen=True, slots=True)
class Pulse:
    """A node in training mode did a basic behavior, and what it saw when that tick began."""

    demonstration: str
    node: str
    tick: int
    behavior: str
    values: Mapping[str, float]


def refuse_controllers(arm: Arm) -> None:
    """Raise a `ParameterError` if the arm has controllers: a flat automaton is one of agents."""
    if arm.forest().controllers():
        raise ParameterError(
            f"'learner.flat' is for arms of agents on their own, but arm {arm.name!r} has controllers"
        )


def with_flat(project: Project, arm: Arm, flat: Flat) -> tuple[Project, Arm]:
    """*project* with the flat automaton in the library of the arm's agents, and the arm with it at the top."""
    type_name, automaton = arm.forest().roots[0].type, flat.automaton
    library = Library({**project.library(type_name).automata, automaton.id: automaton})
    examples = {**project.examples.get(type_name, {}), automaton.id: flat.examples}
    project = replace(
        project,
        libraries={**project.libraries, type_name: library},
        examples={**project.examples, type_name: examples},
    )
    return project, replace(arm, top=automaton.name)


def flat_of(project: Project, scenario: Scenario, arm: Arm) -> Flat:
    """The flat automaton that the demonstrations of an arm's behaviors teach."""
    keys = behaviors_in_use(project, scenario.vocabulary, arm)
    automata = [project.library(type_name).get(automaton_id) for type_name, automaton_id in keys]
    features = (*senses_of(automata), TICKS)
    pulses = _watched(project, scenario, keys, features[:-1])
    vocabulary = project.types_with(scenario.vocabulary).vocabulary(arm.forest().roots[0].type)
    basics = {name: basic for name, basic in vocabulary.behaviors.items() if not _only_tells(basic, scenario)}
    used = [name for name in basics if any(pulse.behavior == name for pulse in pulses)]
    states = tuple(State(slug(name), Basic(name)) for name in used)
    automaton = Automaton(slug(NAME), NAME, features=features)
    automaton = replace(automaton, states=(*automaton.states, *states))
    return Flat(automaton, tuple(examples_of(pulses, {name: basics[name] for name in used})))


def senses_of(automata: Sequence[Automaton]) -> tuple[FeatureUse, ...]:
    """All that any of the automata senses, slots that are parameters bound to every target that they are bound to."""
    targets = dict.fromkeys(
        binding.target
        for automaton in automata
        for state in automaton.states
        if isinstance(state.content, Nested)
        for binding in state.content.bindings.values()
        if isinstance(binding, Ground)
    )
    found: dict[str, FeatureUse] = {}
    for automaton in automata:
        for use in automaton.features:
            if isinstance(use.source, Sense):
                for bindings in _grounded(use.source.bindings, list(targets)):
                    sense = Sense(use.source.feature, bindings)
                    found[describe(sense)] = FeatureUse(slug(describe(sense)), sense)
    return tuple(found[name] for name in sorted(found))


def _grounded(bindings: Bindings, targets: Sequence[str]) -> Iterator[Bindings]:
    """The bindings with each parameter in turn replaced by each target."""
    open_slot = next((slot for slot, b in bindings.items() if not isinstance(b, Ground)), None)
    if open_slot is None:
        yield bindings
        return
    for target in targets:
        yield from _grounded({**bindings, open_slot: Ground(target)}, targets)


# ------------------------------------------------------------------------------------------------------ watching


def _watched(
    project: Project, scenario: Scenario, keys: Sequence[tuple[str, str]], features: Sequence[FeatureUse]
) -> list[Pulse]:
    """Every pulse of a basic behavior by a node in training mode, in all demonstrations of these behaviors."""
    shown = {d.id: d for d in project.demonstrations}
    pulses: list[Pulse] = []
    playing: list[Demonstration] = []

    def begins(_share: float, what: str) -> None:
        playing[:] = [shown[word] for word in what.split()[-1:] if word in shown]

    def pulsed(world: World, me: int, behavior: str) -> None:
        demonstration = playing[0]
        node = project.arm(demonstration.arm).forest().agents()[me].id
        tick = int(world.clock[NOW])
        if node in _taught(demonstration, tick):
            pulses.append(Pulse(demonstration.id, node, tick, behavior, _seen(scenario, world, me, features)))

    recreate(project, _overheard(scenario, pulsed), keys, begins)
    return pulses


def _overheard(scenario: Scenario, pulsed: Callable[[World, int, str], None]) -> Scenario:
    """The same scenario, telling of every pulse before it takes effect."""

    def telling(name: str, function: Callable[..., None]) -> Callable[..., None]:
        @wraps(function)
        def told(world: World, me: int, *targets: Any) -> None:
            pulsed(world, me, name)
            function(world, me, *targets)

        return told

    twin = copy(scenario)
    twin.behaviors = {name: telling(name, function) for name, function in scenario.behaviors.items()}
    return twin


def _taught(demonstration: Demonstration, tick: int) -> set[str]:
    """The nodes that do just what the person picks: those of the demonstration; after a test, those picked for since."""
    taught = set() if any(act.act == "teach" for act in demonstration.picks) else _picked(demonstration)
    for act in demonstration.picks:
        if act.tick <= tick:
            taught = set() if act.act == "test" else taught | {act.node}
    return taught


def _picked(demonstration: Demonstration) -> set[str]:
    return {act.node for act in demonstration.picks if act.node}


def _seen(scenario: Scenario, world: World, me: int, features: Sequence[FeatureUse]) -> dict[str, float]:
    """What an agent sees; basic behaviors change nothing that is sensed before all have acted."""
    senses, seen = WorldSenses(scenario, world), dict[str, float]()
    for use in features:
        assert isinstance(use.source, Sense)
        declared = declaration(use.source, scenario.vocabulary)
        bound = [use.source.bindings[slot] for slot in declared.parameters]
        targets = tuple(
            senses.target(b.target, range(me, me + 1), me) for b in bound if isinstance(b, Ground)
        )
        seen[use.id] = (
            declared.default if NO_ENTITY in targets else senses.feature(declared.name, me, targets)
        )
    return seen


def _only_tells(basic: BasicBehavior, scenario: Scenario) -> bool:
    """Whether a basic behavior does nothing in the world: its function has no more than a docstring."""
    return basic.raises is not None and scenario.behaviors[basic.name].__code__.co_names == ()


# ------------------------------------------------------------------------------------------------------ examples


def examples_of(pulses: Sequence[Pulse], basics: Mapping[str, BasicBehavior]) -> Iterator[Example]:
    """What the changes of basic behavior teach; pulses of behaviors that are not among *basics* are passed over."""
    current: dict[tuple[str, str], tuple[str, int]] = {}
    number = pick = 0
    for pulse in pulses:
        who = pulse.demonstration, pulse.node
        state, since = current.get(who, (START, pulse.tick))
        basic = basics.get(pulse.behavior)
        if basic is None or slug(basic.name) == state:
            continue
        pick += 1
        label = slug(basic.name)
        current[who] = (START, pulse.tick + 1) if basic.raises else (label, pulse.tick)
        triples = [(state, float(pulse.tick - since), False)]
        triples += [] if basic.runs_once else [(label, 0.0, True)]
        for source, ticks, continuation in triples:
            number += 1
            values = {**pulse.values, TICKS.id: ticks}
            yield Example(
                str(number),
                source,
                label,
                values,
                continuation,
                demonstration=pulse.demonstration,
                tick=pulse.tick,
                node=pulse.node,
                pick=pick,
            )
