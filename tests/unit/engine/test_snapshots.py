"""What a snapshot shows: columns, what all nodes do as arrays, where that is, and what watched nodes are about to decide."""

from dataclasses import replace

import pytest

from app.core.project import Arm, LevelTable, Project, Value
from app.core.vocabulary import NO_ENTITY
from app.engine.commands import MoveEntities, Pick, Reset, Teach, UseArm, Watch
from app.engine.session import Session
from app.engine.snapshots import BehaviorRef, Snapshot, StateRef
from app.sim.scenarios.foraging import scenario as foraging
from tests import foragers
from tests.corridor import corridor, project
from tests.driver import UNCOMPILED, Driver
from tests.samples import AGENT, GROUP, TYPES

ENGINES = pytest.mark.parametrize("engine", ["reference", "compiled"])


def paper(top: str) -> Project:
    """The paper's foragers, alone and in groups."""
    return Project(
        "Foragers",
        "foraging",
        TYPES,
        libraries=foragers.libraries(),
        arms=(
            Arm("alone", LevelTable((4,), (AGENT,)), "Forage"),
            Arm("groups", LevelTable((2, 3), (GROUP, AGENT)), top),
        ),
    )


def session(engine: str, arm: str = "groups", top: str = "ControlForage", **settings: Value) -> Session:
    world = {f"world.{name}": value for name, value in foragers.BUSY.items()}
    return Session(paper(top), foraging, arm, 3, settings={**world, "engine": engine, **settings})


# ------------------------------------------------------------------------------------------------- columns, place


@ENGINES
def test_columns_have_an_entry_an_entity_and_cannot_be_written(engine: str) -> None:
    snapshot = session(engine).advance(30)
    spans = snapshot.place.spans
    assert spans == {"agent": range(6), "box": range(6, 12), "deposit": range(12, 13)}
    assert len(snapshot.columns["x"]) == 13
    assert snapshot.columns["x"][12] == 20.0
    assert snapshot.columns["held"].dtype.kind == "i"
    with pytest.raises(ValueError, match="read-only"):
        snapshot.columns["x"][0] = 1.0
    assert snapshot.world == {name: tuple(column.tolist()) for name, column in snapshot.columns.items()}


@ENGINES
def test_a_snapshot_stays_as_it_was(engine: str) -> None:
    running = session(engine)
    snapshot = running.advance(1)
    x, behavior = snapshot.columns["x"].copy(), snapshot.doing.behavior.copy()
    running.advance(200)
    assert (snapshot.columns["x"] == x).all()
    assert snapshot.doing.behavior.tolist() == behavior.tolist()


def test_a_place_stays_the_same_while_its_world_lives() -> None:
    running = session("reference")
    place = running.snapshot().place
    running.send(Teach(AGENT, "Forage", ("agent-1",)))
    running.send(Pick("agent-1", "wander"))
    running.send(MoveEntities({0: (3.0, 4.0)}))
    assert running.advance(3).place is place
    running.send(Reset())
    again = running.advance(0).place
    assert again is not place
    running.send(UseArm("alone"))
    assert running.advance(0).place is not again


def test_a_place_tells_where_it_is() -> None:
    place = session("reference", physics="rigid").snapshot().place
    assert (place.scenario, place.arm, place.physics) == ("foraging", "groups", "rigid")
    assert place.ids == ("group-1", "group-2", *place.agents)
    assert place.agents == tuple(f"agent-{k}" for k in range(1, 7))
    assert place.parameters["width"] == 40.0
    assert place.look.width == 40.0


def test_snapshots_are_equal_if_the_same_can_be_read_from_them() -> None:
    one, other = session("reference"), session("compiled")
    assert one.advance(40) == other.advance(40)
    assert one.advance(1) != other.advance(2)
    assert one.snapshot() != "a snapshot"


# --------------------------------------------------------------------------------------------------------- doing


@ENGINES
def test_rows_say_what_each_node_does_outermost_first(engine: str) -> None:
    running = session(engine)
    doing = running.advance(1).doing
    assert [doing.row(node) for node in ("group-1", "group-2", "agent-1")] == [0, 1, 2]
    group, agent = path(running.snapshot(), "group-1"), path(running.snapshot(), "agent-1")
    assert group[0] == (
        BehaviorRef(GROUP, "ControlForage", "ControlForage"),
        StateRef(GROUP, "ControlForage", "search"),
    )
    assert group[1] == (BehaviorRef(GROUP, "", "Forage"), None)
    assert agent[0] == (BehaviorRef(AGENT, "Forage", "Forage"), StateRef(AGENT, "Forage", "wander"))
    assert agent[1][0] == BehaviorRef(AGENT, "Wander", "Wander")


def path(snapshot: Snapshot, node: str) -> list[tuple[BehaviorRef, StateRef | None]]:
    doing, row = snapshot.doing, snapshot.doing.row(node)
    pairs = zip(doing.behavior[row].tolist(), doing.state[row].tolist(), strict=True)
    return [(doing.behaviors[b], doing.states[s] if s >= 0 else None) for b, s in pairs if b >= 0]


@ENGINES
def test_a_single_node_is_told_as_all_of_them_are(engine: str) -> None:
    snapshot = session(engine).advance(40)
    assert {node_id: snapshot.node(node_id) for node_id in snapshot.nodes} == snapshot.nodes


@ENGINES
def test_a_node_shows_the_automaton_that_it_runs_in_its_outermost_one(engine: str) -> None:
    running = session(engine, "alone")
    assert shown(running.advance(1)) == ["Wander"] * 4
    for _ in range(40):  # some see a box by then
        snapshot = running.advance(10)
        assert set(shown(snapshot)) <= {"Wander", "ReturnWithBox", "Forage"}
        if "ReturnWithBox" in shown(snapshot):
            return
    raise AssertionError("nobody ever saw a box")


def shown(snapshot: Snapshot) -> list[str]:
    doing = snapshot.doing
    return ["" if what < 0 else doing.behaviors[what].name for what in doing.shown.tolist()]


@ENGINES
@pytest.mark.parametrize("top", ["Wander", "Forward"])
def test_a_directed_node_shows_what_it_was_directed_to_do(engine: str, top: str) -> None:
    snapshot = session(engine, top=top).advance(3)
    assert shown(snapshot)[2:] == [top] * 6
    ref = BehaviorRef(AGENT, "Wander" if top == "Wander" else "", top)
    assert snapshot.doing.counts() == {ref: 6}  # controllers do not count


@ENGINES
def test_nodes_are_counted_in_their_states_at_any_depth(engine: str) -> None:
    snapshot = session(engine).advance(1)
    assert snapshot.doing.in_states(GROUP, "ControlForage") == {"search": 2}
    assert sum(snapshot.doing.in_states(AGENT, "Forage").values()) == 6
    wandering = snapshot.doing.in_states(AGENT, "Forage").get("wander", 0)
    assert sum(snapshot.doing.in_states(AGENT, "Wander").values()) == wandering
    assert snapshot.doing.in_states(GROUP, "Wander") == {}


def test_nodes_that_all_idle_show_nothing() -> None:
    idle = replace(project(), arms=(replace(project().arm("alone"), top=""),))
    doing = Session(idle, corridor, "alone", settings=UNCOMPILED).snapshot().doing
    assert doing.behavior.tolist() == [[-1], [-1]]
    assert doing.shown.tolist() == [-1, -1]
    assert (doing.counts(), doing.in_states(AGENT, "Stroll")) == ({}, {})


# ----------------------------------------------------------------------------------------------------- watching


@ENGINES
def test_a_watched_node_shows_what_it_is_about_to_decide(engine: str) -> None:
    running = session(engine, "alone")
    running.send(Watch(("agent-2", "agent-99")))
    snapshot = running.advance(1)
    assert list(snapshot.watched) == ["agent-2"]
    seen = snapshot.watched["agent-2"]
    forage, wander = seen.levels
    assert (forage.automaton, forage.state, forage.type) == ("Forage", "wander", AGENT)
    assert dict(forage.values)["attached"] == 0.0
    assert set(forage.values) == {"sees", "attached", "done", "failed"}
    assert (wander.automaton, wander.ticks) == ("Wander", 1)
    assert sum(probability for _, probability in wander.outcome) == pytest.approx(1.0)
    assert seen.targets["deposit"] == snapshot.place.spans["deposit"].start
    assert "closest attached agent" not in seen.targets  # only controllers bind that


@ENGINES
def test_what_is_foreseen_happens(engine: str) -> None:
    running = session(engine, "alone")
    nodes = running.snapshot().place.agents
    running.send(Watch(nodes))
    before, certain = running.advance(1), 0
    for _ in range(300):
        after = running.advance(1)
        for node in nodes:
            level = before.watched[node].levels[0]
            possible = {state for state, _ in level.outcome}
            now = after.nodes[node].path[0][1]
            assert now in possible or now == "start"
            certain += len(possible) == 1 and level.state not in possible
        before = after
    assert certain > 0


@ENGINES
def test_arguments_are_told_with_who_bound_them_and_whom_they_mean(engine: str) -> None:
    running = session(engine)
    agents = running.snapshot().place.agents
    running.send(Watch(agents))
    for _ in range(100):
        snapshot = running.advance(1)
        outer = {node: snapshot.watched[node].levels[0] for node in agents}
        if gathering := [node for node in agents if outer[node].automaton == "Goto"]:
            break
    found = {node: outer[node].arguments["target"] for node in gathering}
    assert {(target, owner) for target, owner, _ in found.values()} <= {
        ("closest attached agent", "group-1"),
        ("closest attached agent", "group-2"),
    }
    for node, (_, _, entity) in found.items():
        attached = snapshot.columns["held"][agents.index(node)] >= 0
        assert attached if entity == NO_ENTITY else snapshot.columns["held"][entity] >= 0
    assert any(entity != NO_ENTITY for _, _, entity in found.values())


@ENGINES
def test_a_controllers_target_is_told_if_it_is_the_same_to_its_agents(engine: str) -> None:
    running = session(engine)
    running.send(Watch(("group-1",)))
    seen = running.advance(1).watched["group-1"]
    assert seen.targets["deposit"] == 12
    assert seen.targets["closest attached agent"] == NO_ENTITY  # nobody is attached yet
    assert seen.levels[0].values["called"] == 0.0


def test_watching_outlives_resets_and_arms() -> None:
    running = session("reference")
    running.send(Watch(("group-1", "agent-1")))
    assert set(running.advance(1).watched) == {"group-1", "agent-1"}
    running.send(UseArm("alone"))
    assert set(running.advance(1).watched) == {"agent-1"}
    running.send(Reset(4))
    assert set(running.advance(1).watched) == {"agent-1"}
    running.send(UseArm("groups"))
    assert set(running.advance(1).watched) == {"group-1", "agent-1"}
    running.send(Watch())
    assert running.advance(1).watched == {}


def test_a_pupil_is_watched_while_it_is_taught() -> None:
    driver = Driver().teach("agent-1", "Shuttle").pick("up").advance(2)
    driver.session.send(Watch(("agent-1",)))
    (level,) = driver.snapshot.watched["agent-1"].levels
    assert (level.state, level.ticks) == ("up", 2)
    assert level.outcome == (("up", 1.0),)  # nothing was learned yet: it stays
