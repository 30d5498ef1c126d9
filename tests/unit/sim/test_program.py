"""Lowering: what a forest can come to run, as flat tables; what has no flat form is refused with its reason."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from app.core.actor import actors
from app.core.automaton import START, Automaton, Basic, Rule, State
from app.core.conditions import AtMost, Condition
from app.core.errors import ProgramError
from app.core.features import FeatureUse, FlagUp, Parameter, Sense
from app.core.library import Library, Types
from app.core.machine import Machine, stored_classifiers
from app.core.tree import Branch, Forest, Leaf, Tree
from app.sim.program import Needs, Program, lower, needs_of
from app.sim.program.tables import NO_KEY, NOWHERE
from app.sim.scenarios.foraging import scenario as foraging
from tests import foragers
from tests.samples import AGENT

Change = Callable[[Automaton], Automaton]


def program_of(name: str, types: Types | None = None) -> Program:
    """The program of one of the paper's structures as it begins."""
    forest, top = foragers.STRUCTURES[name]
    types = types or foragers.types()
    machine = Machine(forest, types, key=1)
    for root in forest.roots:
        machine.direct(root.id, top)
    return lower(machine.actors.values(), types, foraging, stored_classifiers, needs_of(machine))


def with_wander(change: Change, extra: tuple[Automaton, ...] = ()) -> Types:
    """The foragers' types with another Wander, and more automata."""
    automata = {a.id: a for a in (*foragers.libraries()[AGENT].automata.values(), *extra)}
    automata["Wander"] = change(automata["Wander"])
    return foragers.types(made={**foragers.libraries(), AGENT: Library(automata)})


def test_only_what_can_be_reached_is_lowered() -> None:
    names = [row.automaton.name for row in program_of("independent").automata]
    assert sorted(names) == ["Forage", "Goto", "ReturnWithBox", "Wander"]


def test_what_controllers_can_direct_is_lowered_with_them() -> None:
    lowered = {(row.type, row.automaton.name) for row in program_of("two levels").automata}
    assert {("squad", "ControlForage2"), ("group", "ControlForage"), ("agent", "Release")} <= lowered


def test_a_thousand_unused_behaviors_leave_the_program_as_it_is() -> None:
    unused = tuple(replace(foragers.wander(), id=f"unused {k}", name=f"Unused {k}") for k in range(1000))
    plain, full = program_of("independent"), program_of("independent", with_wander(lambda a: a, unused))
    assert {n: c.tolist() for n, c in plain.columns.items()} == {
        n: c.tolist() for n, c in full.columns.items()
    }


def test_columns_cannot_be_written_to() -> None:
    with pytest.raises(ValueError, match="read-only"):
        program_of("independent").columns["goal"][0] = 1


def test_unused_states_are_trimmed() -> None:
    def change(automaton: Automaton) -> Automaton:
        return replace(automaton, states=(*automaton.states, State("unused", Basic("Forward"))))

    program = program_of("independent", with_wander(change))
    assert "unused" not in [state.id for state in program.states]


def test_a_state_that_a_node_is_in_is_kept_though_nothing_leads_there() -> None:
    types = with_wander(lambda a: replace(a, states=(*a.states, State("unused", Basic("Forward")))))
    needs = Needs(frozenset({(AGENT, "Wander")}), states=frozenset({(AGENT, "Wander", "unused")}))
    program = lower(actors(foragers.alone()).values(), types, foraging, stored_classifiers, needs)
    assert "unused" in [state.id for state in program.states]


def test_rules_to_states_that_cannot_be_entered_lead_nowhere() -> None:
    def change(automaton: Automaton) -> Automaton:
        never = Rule("never", "left", (), "unused", 0.0)
        states = (*automaton.states, State("unused", Basic("Forward")))
        return replace(automaton, states=states, rules=(never, *automaton.rules))

    program = program_of("independent", with_wander(change))
    assert program.columns["goal"].tolist().count(NOWHERE) > 0


def test_needs_cover_what_they_hold() -> None:
    small, large = Needs(flags=frozenset({"a"})), Needs(flags=frozenset({"a", "b"}))
    assert large.covers(small)
    assert not small.covers(large)
    assert (small | large) == large


def _learned(model: Tree | Forest) -> Change:
    return lambda automaton: replace(automaton, learned={"forward": model})


def _rule(**fields: Any) -> Change:
    rule = Rule("bad", START, (), "forward", 0.5)
    return lambda automaton: replace(automaton, rules=(replace(rule, **fields), *automaton.rules))


def _open(automaton: Automaton) -> Automaton:
    use = FeatureUse("far", Sense("DistanceTo", {"target": Parameter("who")}))
    guarded = Rule("bad", START, (Condition(AtMost("far", 1.0)),), "forward", 0.5)
    return replace(automaton, features=(use,), rules=(guarded, *automaton.rules))


def _many_rules(automaton: Automaton) -> Automaton:
    rules = tuple(Rule(f"r{k}", START, (), "forward", 0.01) for k in range(61))
    return replace(automaton, rules=(*rules, *automaton.rules))


def _many_flags(automaton: Automaton) -> Automaton:
    uses = tuple(FeatureUse(f"f{k}", FlagUp(f"flag {k}")) for k in range(61))
    guard = tuple(Condition(AtMost(use.id, 2.0)) for use in uses)
    return replace(automaton, features=uses, rules=(Rule("f", START, guard, "forward"), *automaton.rules))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (_learned(Forest(("left",), ())), "a forest without trees"),
        (_rule(target="nowhere"), "a state 'nowhere' that it does not have"),
        (_rule(guard=(Condition(AtMost("no such", 1.0)),)), "no such"),
        (_open, "'target' is open"),
        (_many_rules, "62 rules"),
        (_many_flags, "more than 60 flags"),
    ],
)
def test_what_has_no_flat_form_is_refused_with_its_reason(change: Change, message: str) -> None:
    with pytest.raises(ProgramError, match=message):
        program_of("independent", with_wander(change))


def test_what_decided_can_be_read_back() -> None:
    leaves = Leaf((1.0, 0.0)), Leaf((1.0, 1.0))
    far = AtMost("far", 3.0)
    tree = Tree(("left", "right"), Branch(far, *leaves, (2.0, 1.0)))
    use = FeatureUse("far", Sense("ICanSeeABox"))
    program = program_of(
        "independent",
        with_wander(lambda a: replace(a, features=(use,), rules=a.rules[:1], learned={"forward": tree})),
    )
    state = next(k for k, row in enumerate(program.states) if row.labels)
    for key in (None, ((3,), (True, False)), ((2,), (True, True))):
        words = program.key_words(state, key)
        assert program.key(state, words) == key
    assert program.key_words(state, None) == [NO_KEY]
    assert program.key_words(state, ((5,), (True, True))) == [-2]
    assert program.key_words(state, ("gone",)) == [-2]


def test_a_flag_that_nodes_show_is_known_though_no_behavior_raises_it() -> None:
    machine = Machine(foragers.alone(), foragers.types(), key=1)
    machine.direct("agent-1", "Wander")
    run = machine.actors["agent-1"].run
    assert run is not None
    run.flags.add("strange")
    program = lower(
        machine.actors.values(), foragers.types(), foraging, stored_classifiers, needs_of(machine)
    )
    assert "strange" in program.flags


def test_a_behavior_that_its_library_has_in_another_version_is_refused() -> None:
    machine = Machine(foragers.alone(), foragers.types(), key=1)
    machine.direct("agent-1", "Wander")
    machine.use(with_wander(lambda a: replace(a, note="newer")), stored_classifiers)
    with pytest.raises(ProgramError, match="version"):
        needs_of(machine)
