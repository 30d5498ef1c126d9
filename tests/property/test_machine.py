"""Properties of the machine over random libraries, forests and worlds."""

import json
from collections.abc import Mapping
from random import Random
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st

from app.core.actor import Actor, Run
from app.core.features import FeatureUse, FlagUp, Statistic, summarize
from app.core.machine import Action, Machine, Senses, stored_classifiers
from app.core.machine_state import MachineState, freeze, rebase, thaw
from app.core.vocabulary import FINISHED
from tests.random_automata import FLAGS, NoisySenses, random_forest, random_machine, random_types

SEEDS = st.integers(0, 1 << 32)
EXAMPLES = 60


class PatientMachine(Machine):
    """Reads all flags from a copy that it made when the tick began: what the machine must agree with."""

    def begin(self) -> None:
        """Copy all flags."""
        self._shown = {
            actor.node.id: {f for f in (*FLAGS, FINISHED) if actor.shows(f)} for actor in self.actors.values()
        }
        self._up = {id(run): set(run.flags) for actor in self.actors.values() for run in _runs(actor.run)}
        self._kept = [run for actor in self.actors.values() for run in _runs(actor.run)]

    def value(self, actor: Actor, run: Run, use: FeatureUse, senses: Senses) -> float:
        match use.source:
            case FlagUp(flag):
                return float(run.child is not None and flag in self._up.get(id(run.child), ()))
            case Statistic(operation, FlagUp(flag), _) as statistic:
                below = self.below(actor, statistic)
                return summarize(operation, [float(flag in self._shown[node.node.id]) for node in below], 0.0)
        return super().value(actor, run, use, senses)


def _runs(run: Run | None) -> list[Run]:
    return [] if run is None else [run, *_runs(run.child)]


def play(machine: Machine, senses: NoisySenses, ticks: int) -> list[tuple[list[Action], MachineState]]:
    """Pass ticks; what was done in each and what all nodes do after it."""
    passed = []
    for _ in range(ticks):
        senses.now = machine.now
        if isinstance(machine, PatientMachine):
            machine.begin()
        actions = machine.tick(senses, machine.now)
        passed.append((actions, freeze(machine)))
    return passed


def pair(seed: int, other: type[Machine]) -> tuple[Machine, Machine]:
    """A machine and one of another make in the same world."""
    random = Random(seed)
    types, forest = random_types(random), random_forest(random)
    return random_machine(Random(seed), forest, types), random_machine(Random(seed), forest, types, other)


@settings(max_examples=2 * EXAMPLES)
@given(SEEDS)
def test_features_read_the_flags_as_they_were_when_the_tick_began(seed: int) -> None:
    machine, patient = pair(seed, PatientMachine)
    assert play(machine, NoisySenses(seed), 25) == play(patient, NoisySenses(seed), 25)


@settings(max_examples=EXAMPLES)
@given(SEEDS)
def test_the_order_of_nodes_of_a_level_does_not_matter(seed: int) -> None:
    machine, other = pair(seed, Machine)
    shuffled = sorted(other.actors.values(), key=lambda actor: (-actor.node.level, -actor.number))
    other.actors = {actor.node.id: actor for actor in shuffled}
    for (actions, state), (others, states) in zip(
        play(machine, NoisySenses(seed), 20), play(other, NoisySenses(seed), 20), strict=True
    ):
        assert actions == sorted(others, key=lambda action: action.agent)
        assert state == states


@settings(max_examples=EXAMPLES)
@given(SEEDS, st.integers(0, 15))
def test_thawing_goes_back_and_the_same_ticks_give_the_same(seed: int, before: int) -> None:
    machine, _ = pair(seed, Machine)
    senses = NoisySenses(seed)
    play(machine, senses, before)
    kept = json.loads(json.dumps(freeze(machine)))
    first = play(machine, senses, 15)
    thaw(machine, kept)
    assert json.loads(json.dumps(freeze(machine))) == kept
    assert play(machine, senses, 15) == first


@settings(max_examples=EXAMPLES)
@given(SEEDS, st.integers(0, 15))
def test_another_machine_goes_on_from_a_frozen_state(seed: int, before: int) -> None:
    machine, other = pair(seed, Machine)
    play(machine, NoisySenses(seed), before)
    thaw(other, freeze(machine))
    assert play(other, NoisySenses(seed), 10) == play(machine, NoisySenses(seed), 10)


@settings(max_examples=EXAMPLES)
@given(SEEDS, st.integers(0, 15))
def test_rebasing_on_equal_libraries_changes_nothing(seed: int, before: int) -> None:
    machine, other = pair(seed, Machine)
    play(machine, NoisySenses(seed), before)
    play(other, NoisySenses(seed), before)
    rebase(other, random_types(Random(seed)), stored_classifiers)
    assert play(other, NoisySenses(seed), 10) == play(machine, NoisySenses(seed), 10)


@settings(max_examples=2 * EXAMPLES)
@given(SEEDS, SEEDS, st.integers(0, 15))
def test_going_on_with_other_libraries_is_freezing_and_thawing_under_them(
    seed: int, edited: int, before: int
) -> None:
    machine, other = pair(seed, Machine)
    play(machine, NoisySenses(seed), before)
    play(other, NoisySenses(seed), before)
    did, types = freeze(other), random_types(Random(edited))
    lost = rebase(machine, types, stored_classifiers)
    other.use(types, stored_classifiers)
    thaw(other, did)
    now = freeze(other)
    assert freeze(machine) == now
    elsewhere = {
        node_id: was
        for node_id, was in did["nodes"].items()
        if path(was["run"]) != path(now["nodes"][node_id]["run"])
    }
    assert lost == {"now": did["now"], "nodes": elsewhere}


def path(run: Mapping[str, Any] | None) -> list[tuple[str, str]] | None:
    """The automata that a frozen run is, with their states; None of a node that idles."""
    if run is None:
        return None
    below = [] if run["child"] is None else path(run["child"]) or []
    return below if run["automaton"] is None else [(run["automaton"], run["state"]), *below]


@settings(max_examples=EXAMPLES)
@given(SEEDS, SEEDS)
def test_going_on_with_any_other_libraries_never_fails(seed: int, edited: int) -> None:
    machine, _ = pair(seed, Machine)
    play(machine, NoisySenses(seed), 10)
    rebase(machine, random_types(Random(edited)), stored_classifiers)
    play(machine, NoisySenses(seed), 10)


@settings(max_examples=EXAMPLES)
@given(SEEDS)
def test_each_agent_does_one_thing_a_tick_at_most(seed: int) -> None:
    machine, _ = pair(seed, Machine)
    for actions, _ in play(machine, NoisySenses(seed), 20):
        agents = [action.agent for action in actions]
        assert agents == sorted(set(agents))
