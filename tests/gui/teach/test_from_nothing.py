"""From an empty library to foragers, and from foragers to groups of them, by clicks and keys only.

The picks are those of the shipped demonstrations, in worlds of the same seeds; for Forage, the person looks for an agent
that is about to meet a box.
"""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.core.edits import delete_automaton
from app.core.library import NodeType
from app.core.project import Arm, LevelTable, Project
from app.editor.studio import Studio
from app.editor.window.main_window import MainWindow
from app.engine.runs import run, treatment
from app.engine.scenarios import open_scenario
from app.engine.snapshots import Mode
from tests.gui.conftest import PATIENCE
from tests.gui.teach.teacher import Teacher

SEEDS = range(1001, 1021)
LIGHT = "light boxes"
BOX, DEPOSIT = "Goto(nearest visible box)", "Goto(deposit)"


def boxes(project: Project, arm: str, top: str, ticks: int) -> list[float]:
    """What an arm collects, for each seed."""
    of = treatment(project, open_scenario(project), project.arm(arm), top=top)
    return [run(of, seed, ticks, points=1).measures["boxes"] for seed in SEEDS]


def open_in_window(studio: Studio, project: Project, qtbot: QtBot) -> Iterator[Teacher]:
    """A person before a window on an unsaved *project*."""
    studio.open(project, open_scenario(project), None, saved=False)
    qtbot.waitUntil(lambda: studio.snapshot is not None, timeout=PATIENCE)
    window = MainWindow(studio)
    qtbot.addWidget(window)
    window.resize(1440, 900)
    with qtbot.waitExposed(window):
        window.show()
    teacher = Teacher(window, qtbot)
    teacher.settle()
    yield teacher
    window.hide()


@pytest.fixture
def beginner(empty_studio: Studio, qtbot: QtBot) -> Iterator[Teacher]:
    """A person with fifty agents that have learned nothing, and boxes that need five of them, or one."""
    fifty = LevelTable((50,), ("agent",))
    arms = (
        Arm("independent", fifty, "Forward"),
        Arm(LIGHT, fifty, "Forward", parameters={"pullers": 1}),
    )
    yield from open_in_window(
        empty_studio, Project("empty", "foraging", (NodeType("agent"),), arms=arms), qtbot
    )


@pytest.fixture
def leader(empty_studio: Studio, foraging: Project, qtbot: QtBot) -> Iterator[Teacher]:
    """A person with trained foragers in groups whose controllers have learned nothing."""
    project = foraging
    for type_name, automaton in (("squad", "control-forage-2"), ("group", "control-forage")):
        project = untaught(project, type_name, automaton)
    yield from open_in_window(empty_studio, project, qtbot)


def untaught(project: Project, type_name: str, automaton: str) -> Project:
    """*project* without a controller's behavior, and without the arms that run it."""
    name = project.library(type_name).get(automaton).name
    arms = tuple(
        Arm(arm.name, arm.hierarchy, "Forage" if arm.name == "one level" else arm.top, arm.world)
        for arm in project.arms
        if arm.top != name or arm.name == "one level"
    )
    return delete_automaton(replace(project, arms=arms), type_name, automaton)


def test_foragers_taught_from_an_empty_library_collect_what_the_shipped_ones_do(
    beginner: Teacher, foraging: Project
) -> None:
    teach_wander(beginner)
    teach_goto(beginner)
    teach_return_with_box(beginner)
    teach_forage(beginner)
    taught = beginner.studio.document.project
    assert [a.name for a in taught.library("agent").automata.values()] == [
        "Wander",
        "Goto",
        "ReturnWithBox",
        "Forage",
    ]
    ours, shipped = (boxes(p, "independent", "Forage", 20_000) for p in (taught, foraging))
    assert sum(ours) >= 0.8 * sum(shipped), f"{ours} against {shipped}"


def test_a_controller_taught_by_clicks_beats_independent_agents(leader: Teacher, foraging: Project) -> None:
    leader.make(
        "ControlForage",
        "agents' IAmAttachedToABox",
        "subsidiaries' flag finished",
        "subsidiaries' flag done",
        type_name="group",
        sum_up=("somebody", "somebody", "everybody"),
    )
    leader.world(1, "one level")
    leader.studio.selection.select_nodes(("group-1",))
    leader.begin()
    leader.pick("Forage")
    leader.until(170)
    choose_target(leader, "Goto", "closest attached agent")
    leader.until(1239)
    leader.pick("ReturnWithBox")
    leader.until(1929)
    leader.pick("ReleaseBox")
    leader.until(1930)
    leader.pick("Forage")
    leader.until(1951)
    leader.test()
    taught = leader.studio.document.project
    groups = boxes(taught, "one level", "ControlForage", 10_000)
    alone = boxes(foraging, "independent", "Forage", 10_000)
    difference = np.array(groups) - np.array(alone)
    assert difference.mean() > 3 * difference.std(ddof=1) / np.sqrt(len(difference)), (groups, alone)


def teach_wander(person: Teacher) -> None:
    """Ahead, a turn left, ahead, a turn right, ahead."""
    person.make("Wander", "TicksInState")
    person.world(1)
    person.choose_agents("agent-1")
    person.begin()
    turns = ("Forward", 180), ("RotateLeft", 210), ("Forward", 390), ("RotateRight", 430), ("Forward", 451)
    drive(person, "agent-1", *turns)
    person.test()
    person.act(lambda: person.key(Qt.Key.Key_Escape))


def teach_goto(person: Teacher) -> None:
    """To the deposit from either side; then past a box until it is out of sight, and to a box."""
    person.make(
        "Goto", ("DistanceTo(target)", "parameter X"), ("DirectionTo(target)", "parameter X"), parameters=1
    )
    person.world(3)
    person.choose_agents("agent-10", "agent-23")
    person.key(Qt.Key.Key_T)  # X is open: the panel asks for it
    person.wait(
        lambda: person.studio.teaching.choosing.wanted == "X" and person.studio.teaching.choosing.meanings()
    )
    person.click_entity(person.snapshot.place.spans["deposit"].start)
    person.wait(lambda: person.studio.mode is Mode.TEACHING)
    person.settle()
    left, right, ahead = "RotateLeft", "RotateRight", "Forward"
    drive(person, "agent-10", (left, 50), (ahead, 352), (left, 362), (ahead, 394), ("Done", 395))
    drive(person, "agent-23", (right, 455), (ahead, 930), (right, 940), (ahead, 984), ("Done", 990))
    person.act(lambda: person.key(Qt.Key.Key_Escape))
    person.world(5)
    person.choose_agents("agent-5", "agent-31")
    bind_parameter(person, "nearest visible box")
    person.begin()
    drive(person, "agent-5", (left, 30), (ahead, 192), ("Done", 193), ("Done", 194))
    drive(person, "agent-31", (right, 227), (ahead, 286), (right, 297), (ahead, 302), ("Done", 308))
    person.test()
    person.act(lambda: person.key(Qt.Key.Key_Escape))


def teach_return_with_box(person: Teacher) -> None:
    """Boxes that one agent can pull: two grab at once, and one comes too late. Then one that one cannot pull."""
    person.make("ReturnWithBox", "IAmAttachedToABox", ("DistanceTo(target)", "nearest visible box"))
    person.world(199, LIGHT)
    person.choose_agents("agent-6", "agent-18", "agent-8", "agent-40")
    person.begin()
    person.turn_of("agent-6")
    person.pick_at("Goto", target_of(person, "nearest visible box"))
    drive(person, "agent-18", (BOX, 85))
    drive(person, "agent-6", ("GrabBox", 85))
    drive(person, "agent-18", ("GrabBox", 86))
    person.turn_of("agent-6")
    person.pick_at("Goto", person.snapshot.place.spans["deposit"].start)
    person.until(87)
    drive(person, "agent-18", ("Done", 887))
    drive(person, "agent-6", ("ReleaseBoxAndFinish", 888), ("Done", 889))
    drive(person, "agent-8", (BOX, 889))
    drive(person, "agent-40", (BOX, 910), ("GrabBox", 911), (DEPOSIT, 912))
    drive(person, "agent-8", ("Done", 943))
    person.test()
    person.studio.selection.select_nodes(("agent-40",))
    person.pick(DEPOSIT)
    person.until(949)
    person.act(lambda: person.key(Qt.Key.Key_Escape))
    person.world(1, "independent")
    person.choose_agents("agent-4")
    person.begin()
    drive(person, "agent-4", (BOX, 196), ("GrabBox", 197), (DEPOSIT, 238))
    person.test()
    person.pick(DEPOSIT)
    person.until(244)
    person.test()
    person.act(lambda: person.key(Qt.Key.Key_Escape))


def teach_forage(person: Teacher) -> None:
    """With an agent that is about to meet a box, one round."""
    person.make("Forage", "flag done", "ICanSeeABox")
    person.world(6, LIGHT)
    person.choose_agents(about_to_meet_a_box(person))
    person.begin()
    person.pick("Wander")
    while not person.sees("i-can-see-a-box"):
        person.hold(25)
    person.pick("ReturnWithBox")
    person.hold(20)
    while not person.sees("done"):
        person.hold(100)
    person.pick("Wander")
    person.hold(10)
    person.test()
    person.act(lambda: person.key(Qt.Key.Key_Escape))


# ------------------------------------------------------------------------------------------------ ways of a hand


def drive(person: Teacher, node: str, *picks: tuple[str, int]) -> None:
    """It is a node's turn: what is picked for it, and up to which tick that goes on."""
    person.turn_of(node)
    for name, tick in picks:
        person.pick(name)
        person.until(tick)


def choose_target(person: Teacher, name: str, target: str) -> None:
    """Pick a behavior with a slot, and choose from the menu what that is."""
    choice = next(c for c in person.page.choices if c.name == name and c.slots)
    person.key(Qt.Key(ord(choice.key)))
    person.act(lambda: person.choose_target(person.page.targets, choice.slots[0], target))


def bind_parameter(person: Teacher, target: str) -> None:
    """Choose from the menu what X is, before a lesson."""
    person.choose_target(person.panel.idle.targets, "X", target)


def target_of(person: Teacher, name: str) -> int:
    """What a target is to the node now."""
    person.wait(lambda: person.studio.teaching.choosing.meanings().get(name, -1) >= 0)
    return person.studio.teaching.choosing.meanings()[name]


def about_to_meet_a_box(person: Teacher) -> str:
    """An agent that sees no box, but heads for one that is near, and near the deposit."""
    columns, spans = person.snapshot.columns, person.snapshot.place.spans
    agents, found = spans["agent"], spans["box"]
    x, y = columns["x"][agents.start : agents.stop], columns["y"][agents.start : agents.stop]
    heading = columns["heading"][agents.start : agents.stop]
    best: list[tuple[float, str]] = []
    for box in found:
        dx, dy = columns["x"][box] - x, columns["y"][box] - y
        ahead, aside = (
            dx * np.cos(heading) + dy * np.sin(heading),
            dy * np.cos(heading) - dx * np.sin(heading),
        )
        home = np.hypot(columns["x"][box] - 100.0, columns["y"][box] - 100.0)
        likely = np.flatnonzero((ahead > 11.0) & (ahead < 26.0) & (abs(aside) < 4.0))
        best += [(float(ahead[n] + home), person.snapshot.place.agents[n]) for n in likely]
    return min(best)[1]
