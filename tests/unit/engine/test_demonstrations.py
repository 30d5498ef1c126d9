"""Demonstrations are literal lists of acts: the same hand records the same examples, byte for byte."""

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from app.core.automaton import START, Basic
from app.core.edits import add_state, delete_automaton, disable_examples, relabel_examples
from app.core.errors import SessionError
from app.core.examples import Example
from app.core.project import Arm, Demonstration, LevelTable, Pick, Project
from app.core.storage import save
from app.engine.demonstrations import commands, play, recreate
from app.learner.trainer import apply, is_stale, learn
from tests.corridor import corridor, project
from tests.samples import AGENT, GROUP

ROOT = Path(__file__).parents[3]


def shuttle(*picks: Pick, ticks: int = 20, **fields: Any) -> Demonstration:
    made = Demonstration("shuttle-1", AGENT, "Shuttle", "alone", 1, picks, ticks)
    return replace(made, **fields)


def taught(made: Project, automaton: str = "Shuttle", type_name: str = AGENT) -> list[str]:
    return [f"{e.source}>{e.label}" + "+" * e.continuation for e in made.examples_of(type_name, automaton)]


def played(*picks: Pick) -> list[str]:
    return taught(play(project(), corridor, shuttle(*picks)))


UP, DOWN = Pick(0, "agent-1", "up"), Pick(5, "agent-1", "down")


# ------------------------------------------------------------------------------------------------------ the acts


def test_a_pick_is_made_before_its_tick() -> None:
    made = play(project(), corridor, shuttle(UP, DOWN))
    assert taught(made) == ["start>up", "up>up+", "up>down", "down>down+"]
    assert [(e.tick, e.values["place"]) for e in made.examples_of(AGENT, "Shuttle")][2] == (5, 5.0)


def test_an_undo_takes_the_last_pick_back() -> None:
    assert played(UP, DOWN, Pick(7, "", act="undo"), Pick(9, "agent-1", "jump")) == [
        "start>up",
        "up>up+",
        "up>jump",
    ]


def test_a_test_learns_and_lets_all_run_it() -> None:
    made = play(project(), corridor, shuttle(UP, DOWN, Pick(6, "", act="test"), Pick(9, "agent-2", "jump")))
    assert set(made.library(AGENT).get("Shuttle").learned) == {START, "up", "down"}
    assert [(e.node, e.label) for e in made.examples_of(AGENT, "Shuttle")][-1] == ("agent-2", "jump")


def test_should_not_have_left_mends_the_last_departure() -> None:
    acts = (UP, DOWN, Pick(6, "", act="test"), Pick(12, "agent-1", act="should not have left"))
    assert played(*acts)[-1] in {"up>up", "down>down"}


def test_nodes_are_taught_from_the_tick_of_their_teach_on() -> None:
    acts = (Pick(3, "agent-1", act="teach"), Pick(3, "agent-2", act="teach"), Pick(4, "agent-2", "up"))
    made = play(project(), corridor, shuttle(*acts))
    assert [e.values["place"] for e in made.examples_of(AGENT, "Shuttle")] == [13.0, 13.0]


def test_without_a_teach_the_nodes_that_are_picked_for_are_taught_from_the_beginning() -> None:
    sent = commands(shuttle(UP, Pick(2, "agent-2", "up"), Pick(3, "", act="undo")))
    assert [type(command).__name__ for _, command in sent] == ["Teach", "Pick", "Pick", "UndoPick"]
    assert getattr(sent[0][1], "nodes") == ("agent-1", "agent-2")  # noqa: B009 - one of several commands


def test_nodes_that_begin_in_the_same_tick_are_taught_together() -> None:
    acts = [Pick(t, n, act="teach") for t, n in ((1, "agent-1"), (1, "agent-2"), (4, "agent-1"))]
    assert [(t, getattr(c, "nodes")) for t, c in commands(shuttle(*acts))] == [  # noqa: B009
        (1, ("agent-1", "agent-2")),
        (4, ("agent-1",)),
    ]


def test_a_demonstration_brings_its_world_its_arguments_and_what_the_others_do() -> None:
    seek = shuttle(
        Pick(0, "agent-2", "up"),
        Pick(10, "agent-2", "up"),
        automaton="Seek",
        parameters={"lamp": 33.0},
        arguments={"target": "lamp"},
        others="run",
    )
    held, _ = add_state(project(), AGENT, "Seek", Basic("Up"))
    made = play(held, corridor, seek)
    assert [e.values["distance"] for e in made.examples_of(AGENT, "Seek")] == [23.0, 23.0, 13.0]
    moment = made.moments[made.examples_of(AGENT, "Seek")[-1].snapshot]
    assert moment.world["x"][0] == 10.0  # the other one strolled on


# -------------------------------------------------------------------------------------------- what cannot be played


@pytest.mark.parametrize(
    ("demonstration", "message"),
    [
        (
            shuttle(UP, Pick(7, "agent-1", "fly")),
            "demonstration 'shuttle-1', tick 7: Shuttle has no state 'fly'; there are: ",
        ),
        (
            shuttle(UP, Pick(4, "agent-9", "up")),
            "demonstration 'shuttle-1', tick 0: there is no node 'agent-9' in this world; there are: ",
        ),
        (
            shuttle(Pick(1, "agent-1", act="teach"), Pick(4, "agent-2", "up")),
            "demonstration 'shuttle-1', tick 4: 'agent-2' is not taught or tested now",
        ),
        (shuttle(Pick(5, "agent-1", "up"), UP), "demonstration 'shuttle-1': tick 0 comes after tick 5"),
        (shuttle(UP, DOWN, ticks=3), "demonstration 'shuttle-1': tick 3 comes after tick 5"),
        (
            shuttle(UP, Pick(3, "agent-1", act="shout")),
            "'shuttle-1', tick 3: 'shout' is no act; allowed: pick",
        ),
        (shuttle(UP, others="sleep"), "'shuttle-1': others cannot be 'sleep'; allowed: idle, run"),
        (shuttle(UP, arm="desert"), "demonstration 'shuttle-1': there is no arm 'desert'"),
        (shuttle(UP, seed=-4), "demonstration 'shuttle-1': a seed is a whole number from 0"),
        (shuttle(UP, parameters={"depth": 3}), "demonstration 'shuttle-1': "),
        (
            shuttle(UP, parameters={"breaks": 3}),
            "demonstration 'shuttle-1', tick 3: scenario 'corridor', after",
        ),
        (shuttle(UP, automaton="Dance"), "'shuttle-1', tick 0: there is no behavior with the id 'Dance'"),
        (shuttle(Pick(3, "", act="undo")), "demonstration 'shuttle-1', tick 3: nothing is being taught"),
        (shuttle(Pick(0, "agent-1", act="teach"), Pick(3, "", act="undo")), "tick 3: there is no pick left"),
        (
            shuttle(Pick(0, "agent-1", act="teach"), Pick(3, "", act="test")),
            "demonstration 'shuttle-1', tick 3: behavior 'Shuttle' has no examples to learn from",
        ),
    ],
)
def test_what_cannot_be_played_is_told_with_demonstration_and_tick(
    demonstration: Demonstration, message: str
) -> None:
    with pytest.raises(SessionError) as raised:
        play(project(), corridor, demonstration)
    assert message in str(raised.value)


# ------------------------------------------------------------------------------------------------- recreating


def chain() -> Project:
    """Demonstrations of three behaviors; later ones run earlier ones, and the first is shown twice."""
    held, _ = add_state(project(), AGENT, "Seek", Basic("Up"))
    held, _ = add_state(held, AGENT, "Seek", Basic("Down"))
    arms = (*held.arms, Arm("seekers", LevelTable((2,), (AGENT,)), "Shuttle"))
    lead = Demonstration(
        "lead-1",
        GROUP,
        "Lead",
        "groups",
        3,
        (Pick(0, "group-1", "signal"), Pick(6, "group-1", "down")),
        12,
    )
    seek = shuttle(
        Pick(0, "agent-1", "up"),
        Pick(8, "agent-1", "down"),
        id="seek-1",
        automaton="Seek",
        arguments={"target": "lamp"},
    )
    again = replace(seek, id="seek-2", picks=(Pick(0, "agent-2", "up"), Pick(3, "agent-2", "down")))
    late = shuttle(
        Pick(6, "agent-2", act="teach"), Pick(6, "agent-2", "up"), Pick(9, "agent-2", "jump"), arm="seekers"
    )
    demonstrations = (seek, shuttle(UP, DOWN, id="shuttle-0"), again, lead, replace(late, id="shuttle-2"))
    return replace(held, arms=arms, demonstrations=demonstrations)


def test_recreating_records_and_learns_all_that_has_demonstrations() -> None:
    made = recreate(chain(), corridor)
    assert taught(made, "Seek") == ["start>up", "up>up+", "up>down", "down>down+"] * 2
    assert taught(made)[:4] == ["start>up", "up>up+", "up>down", "down>down+"]
    assert taught(made, "Lead", GROUP) == ["start>signal", "signal>signal+", "signal>down", "down>down+"]
    for where in ((AGENT, "Seek"), (AGENT, "Shuttle"), (GROUP, "Lead")):
        assert not is_stale(made, *where)


def test_recreating_twice_gives_the_same_project() -> None:
    once = recreate(chain(), corridor)
    assert recreate(chain(), corridor) == once
    assert recreate(once, corridor) == once


def test_recreating_needs_nothing_but_the_lists() -> None:
    once = recreate(chain(), corridor)
    examples = {kind: dict[str, tuple[Example, ...]]() for kind in once.examples}
    libraries = {
        kind: replace(
            library,
            automata={i: replace(a, learned={}, learned_from="") for i, a in library.automata.items()},
        )
        for kind, library in once.libraries.items()
    }
    stripped = replace(once, examples=examples, libraries=libraries, moments={})
    assert recreate(stripped, corridor) == once


def test_what_later_demonstrations_taught_does_not_influence_earlier_ones() -> None:
    once = recreate(chain(), corridor)
    wrong = relabel_examples(once, AGENT, "Shuttle", ["1", "3"], "down")
    wrong = apply(wrong, learn(wrong, corridor.vocabulary, [(AGENT, "Shuttle")]))
    assert recreate(wrong, corridor) == once


def test_recreating_some_gives_what_recreating_all_gives() -> None:
    once = recreate(chain(), corridor)
    for only in ([(AGENT, "Seek")], [(AGENT, "Shuttle")], [(GROUP, "Lead"), (AGENT, "Seek")]):
        assert recreate(once, corridor, only) == once


def test_recreating_some_leaves_the_others_alone() -> None:
    once = recreate(chain(), corridor)
    edited = disable_examples(once, AGENT, "Shuttle", ["1"])
    made = recreate(edited, corridor, [(AGENT, "Seek")])
    assert made.examples_of(AGENT, "Shuttle") == edited.examples_of(AGENT, "Shuttle")
    assert made.library(AGENT).get("Shuttle") == edited.library(AGENT).get("Shuttle")


def test_recreating_nothing_changes_nothing() -> None:
    assert recreate(chain(), corridor, []) == chain()
    assert recreate(project(), corridor) == project()


def test_recreating_drops_what_was_taught_by_other_means() -> None:
    once = recreate(chain(), corridor)
    assert recreate(disable_examples(once, AGENT, "Shuttle", ["1", "2"]), corridor) == once


def test_a_demonstration_of_a_behavior_that_is_gone_is_told_by_name() -> None:
    lost = replace(delete_automaton(chain(), AGENT, "Seek"), demonstrations=chain().demonstrations)
    with pytest.raises(SessionError, match=r"demonstration 'seek-1'.*no behavior with the id 'Seek'"):
        recreate(lost, corridor)


def test_progress_is_told_from_0_to_1() -> None:
    told: list[tuple[float, str]] = []
    recreate(chain(), corridor, progress=lambda share, what: told.append((share, what)))
    shares = [share for share, _ in told]
    assert shares == sorted(shares)
    assert (told[0], told[-1]) == ((0.0, "playing seek-1"), (1.0, "done"))
    assert {what for _, what in told} >= {"playing lead-1", "playing shuttle-2"}


@pytest.mark.parametrize("after", [0, 3, 7])
def test_it_can_be_cancelled_at_any_time(after: int) -> None:
    asked = []

    def cancelled() -> bool:
        asked.append(1)
        return len(asked) > after

    with pytest.raises(SessionError, match="cancelled; nothing was changed"):
        recreate(chain(), corridor, cancelled=cancelled)


def test_another_process_with_other_hashes_records_the_same_bytes(tmp_path: Path) -> None:
    save(recreate(chain(), corridor), tmp_path / "here")
    code = (
        "from pathlib import Path; import sys; from app.core.storage import save;"
        "from app.engine.demonstrations import recreate; from tests.corridor import corridor;"
        "from tests.unit.engine.test_demonstrations import chain;"
        "save(recreate(chain(), corridor), Path(sys.argv[1]))"
    )
    for number in ("1", "2"):
        there = tmp_path / number
        subprocess.run(
            [sys.executable, "-c", code, str(there)],
            cwd=ROOT,
            env={**os.environ, "PYTHONHASHSEED": number, "PYTHONPATH": str(ROOT)},
            check=True,
        )
        assert _bytes(there) == _bytes(tmp_path / "here")


def _bytes(folder: Path) -> dict[str, bytes]:
    return {str(f.relative_to(folder)): f.read_bytes() for f in folder.rglob("*") if f.is_file()}
