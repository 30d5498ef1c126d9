"""Teaching, as far as it concerns the machine: picks, taught nodes, and nodes that stand still."""

from dataclasses import replace

import pytest

from app.core.automaton import START
from app.core.errors import SessionError
from app.core.features import FlagUp
from app.core.hierarchy import Hierarchy
from app.core.vocabulary import DONE, FINISHED
from tests.fakes import TICKS, Play, agents, at_least, inner, one_agent, rules, types_of
from tests.samples import GROUP, SQUAD, automaton, flag, nested, state

INSIDE = automaton(
    "inside",
    state("walk", "Forward"),
    state("left", "RotateLeft"),
    features=(TICKS,),
    rules=rules((START, (), "walk"), ("walk", at_least("ticks", 2), "left")),
)
#: What is taught: it has rules of its own, which must not act meanwhile.
LESSON = automaton(
    "lesson",
    state("walk", "Forward"),
    state("grab", "GrabBox"),
    state("release", "ReleaseBoxAndFinish"),
    nested("inside", "inside"),
    flag("over"),
    rules=rules((START, (), "walk"), ("walk", (), "inside")),
)


def taught_agent() -> Play:
    return one_agent(INSIDE, LESSON, top="lesson")


def lesson(play: Play, *picks: str | None) -> list[str]:
    """Teach agent ``a`` with one pick (or none) a tick; what it performed."""
    did = []
    for pick in picks:
        actions = play.tick({} if pick is None else {"a": pick}, taught=["a"])
        did.append(actions[0].behavior if actions else "")
    return did


def test_a_taught_node_stays_in_start_until_a_pick() -> None:
    play = taught_agent()
    assert lesson(play, None, None) == ["", ""]
    assert play.states("a") == START


def test_a_taught_node_does_just_what_is_picked_until_the_next_pick() -> None:
    play = taught_agent()
    assert lesson(play, "walk", None, None, "grab", "walk") == [
        "Forward",
        "Forward",
        "Forward",
        "GrabBox",
        "Forward",
    ]


def test_what_a_taught_node_holds_runs_by_itself() -> None:
    play = taught_agent()
    assert lesson(play, "inside", None, None) == ["Forward", "Forward", "RotateLeft"]
    assert play.states("a") == "inside/left"


def test_picking_the_current_one_shot_again_runs_it_again() -> None:
    play = taught_agent()
    assert lesson(play, "grab", None, "grab", None) == ["GrabBox", "", "GrabBox", ""]


def test_picking_the_current_behavior_again_lets_it_go_on() -> None:
    play = taught_agent()
    assert lesson(play, "inside", None, "inside") == ["Forward", "Forward", "RotateLeft"]
    assert play.sees("a", TICKS.source) == 3.0


def test_after_a_picked_flag_the_taught_node_is_in_start() -> None:
    play = taught_agent()
    assert lesson(play, "over") == [""]
    assert (play.states("a"), play.shown("a")) == (START, {DONE})
    assert lesson(play, "release", None) == ["ReleaseBoxAndFinish", ""]
    assert play.states("a") == START


def test_a_node_that_is_picked_for_takes_the_pick_even_if_it_is_not_taught_yet() -> None:
    play = taught_agent()
    play.tick()
    play.tick({"a": "grab"})
    assert play.states("a") == "grab"


def test_nodes_that_stand_still_do_nothing_and_keep_their_place() -> None:
    play = one_agent(INSIDE, top="inside")
    play.tick()
    assert [play.tick(still=["a"]) for _ in range(3)] == [[], [], []]
    assert play.states("a") == "walk"


def test_ticks_in_state_are_ticks_of_the_world_even_while_a_node_stands_still() -> None:
    play = one_agent(INSIDE, top="inside")
    play.tick()
    play.tick(still=["a"])
    assert play.trace("a", 1) == ["left"]


def squad() -> Play:
    """A squad ``s`` of the groups ``g`` (``a``, ``b``) and ``h`` (``c``), all with something to run."""
    lead = automaton(
        "lead", state("inside", "inside"), state("walk", "Forward"), rules=rules((START, (), "inside"))
    )
    command = automaton("command", state("lead", "lead"), rules=rules((START, (), "lead")))
    forest = Hierarchy(
        (inner("s", SQUAD, inner("g", GROUP, *agents("a", "b")), inner("h", GROUP, *agents("c"))),)
    )
    play = Play(forest, types_of(INSIDE, LESSON, group=(lead,), squad=(command,)))
    play.direct("s", "command")
    play.tick()
    return play


def test_ancestors_of_a_taught_node_do_not_tick_while_the_others_may_run() -> None:
    play = squad()
    play.direct("a", "lesson")
    play.tick({"a": "grab"}, taught=["a"], still=["g", "s"])
    for _ in range(3):
        actions = play.tick(taught=["a"], still=["g", "s"])
    assert [(action.agent, action.behavior) for action in actions] == [(1, "RotateLeft"), (2, "RotateLeft")]
    assert play.states("a") == "grab"


def test_a_taught_agent_whose_controller_stands_still_lowers_its_flags_one_tick_later() -> None:
    play = squad()
    play.direct("a", "lesson")
    play.tick({"a": "release"}, taught=["a"], still=["g", "s"])
    assert play.shown("a") == {DONE, FINISHED}
    play.tick(taught=["a"], still=["g", "s"])
    assert play.shown("a") == set()


def test_a_taught_controller_directs_its_agents_at_each_pick() -> None:
    play = squad()
    play.direct("g", "lead")
    picked = [play.tick({"g": "walk"}, taught=["g"], still=["s", "h", "c"])]
    picked += [play.tick(taught=["g"], still=["s", "h", "c"])]
    picked += [play.tick({"g": "inside"}, taught=["g"], still=["s", "h", "c"])]
    assert [[a.behavior for a in actions] for actions in picked] == [["Forward", "Forward"]] * 3
    assert [play.states(node) for node in "gab"] == ["inside", "walk", "walk"]


def test_picking_a_controllers_current_one_shot_again_directs_again() -> None:
    grab = automaton("lead", state("grab", "GrabBox"))
    play = Play(Hierarchy((inner("g", GROUP, *agents("a")),)), types_of(group=(grab,)))
    play.direct("g", "lead")
    done = [
        play.tick({"g": "grab"}, taught=["g"]),
        play.tick(taught=["g"]),
        play.tick({"g": "grab"}, taught=["g"]),
    ]
    assert [len(actions) for actions in done] == [1, 0, 1]


def test_flags_of_a_sub_behavior_are_seen_while_teaching() -> None:
    top = replace(LESSON, id="top", name="top", states=(*LESSON.states, nested("flagged", "flagged")))
    flagged = automaton("flagged", flag("up"), rules=rules((START, (), "up")))
    play = one_agent(INSIDE, flagged, top, top="top")
    lesson(play, "flagged")
    assert play.sees("a", FlagUp(DONE)) == 1.0
    lesson(play, "flagged")
    assert play.sees("a", FlagUp(DONE)) == 1.0
    lesson(play, "walk")
    assert play.sees("a", FlagUp(DONE)) == 0.0


@pytest.mark.parametrize(
    ("node", "pick", "message"),
    [
        ("a", "fly", r"'fly' cannot be picked for 'a': the states of 'lesson' are: start, walk, grab"),
        ("z", "walk", "there is no node 'z' to pick 'walk' for"),
        ("b", "walk", "'b' runs no automaton now, so 'walk' cannot be picked for it"),
        ("c", "walk", "'c' runs no automaton now"),
        ("d", "walk", "'d' runs no automaton now"),
    ],
)
def test_a_pick_that_cannot_be_obeyed_is_refused_and_changes_nothing(
    node: str, pick: str, message: str
) -> None:
    play = Play(Hierarchy(agents("a", "b", "c", "d")), types_of(INSIDE, LESSON))
    for agent, behavior in (("a", "lesson"), ("b", "Forward"), ("d", "lesson")):
        play.direct(agent, behavior)
    with pytest.raises(SessionError, match=message):
        play.tick({"a": "walk", node: pick}, taught=["a"], still=["d"])
    assert play.states("a") == START
