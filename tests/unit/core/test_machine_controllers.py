"""Directing, joining, and statistics, in forests of several shapes."""

import pytest

from app.core.automaton import START, Automaton
from app.core.errors import ScenarioError, SessionError
from app.core.features import FeatureUse, FlagUp, Ground, Operation, Over, Sense, Statistic
from app.core.hierarchy import Hierarchy, Node
from app.core.library import NodeType
from app.core.vocabulary import DONE, FINISHED
from tests.fakes import DONE_UP, SEES, TICKS, Play, agents, at_least, inner, no, rules, types_of, yes
from tests.samples import AGENT, GROUP, SQUAD, automaton, flag, nested, state

HELP = FeatureUse("help", Sense("SomeoneNeedsHelp"))
#: Walks, and turns left when it sees a box.
LOOK = automaton(
    "look",
    state("walk", "Forward"),
    state("left", "RotateLeft"),
    features=(SEES,),
    rules=rules((START, (), "walk"), ("walk", yes("sees"), "left")),
)
#: Lets its agents look; turns them right when someone needs help.
LEAD = automaton(
    "lead",
    state("look", "look"),
    state("right", "RotateRight"),
    features=(HELP,),
    rules=rules((START, (), "look"), ("look", yes("help"), "right"), ("right", no("help"), "look")),
)
ANY_DONE = FeatureUse("any done", Statistic(Operation.ANY, FlagUp(DONE), Over.SUBSIDIARIES))


def one_group(*automata: Automaton, group: tuple[Automaton, ...] = (LEAD,), top: str = "lead") -> Play:
    """A group ``g`` of ``a`` and ``b``."""
    play = Play(Hierarchy((inner("g", GROUP, *agents("a", "b")),)), types_of(*automata, group=group))
    play.direct("g", top)
    return play


def names(play: Play) -> list[str]:
    """Pass a tick; the basic behaviors performed, by agent."""
    return [action.behavior for action in play.tick()]


# ---------------------------------------------------------------------------------------------- directing


def test_what_a_controller_directs_starts_in_the_same_tick() -> None:
    play = one_group(LOOK)
    assert names(play) == ["Forward", "Forward"]
    assert [play.states(node) for node in "gab"] == ["look", "walk", "walk"]


def test_a_behavior_is_started_once_on_entry_and_then_the_subsidiary_pulses_it_itself() -> None:
    play = one_group(LOOK)
    play.senses.feature_is("SeesABox", 1.0, agent=1, since=1)
    play.tick()
    directed = play.run("b")
    play.trace("g", 3)
    assert play.run("b") is directed
    assert [play.states(node) for node in "gab"] == ["look", "walk", "left"]


def test_a_new_direction_starts_the_subsidiaries_afresh() -> None:
    play = one_group(LOOK)
    play.senses.feature_is("SeesABox", 1.0)
    play.senses.feature_is("SeesABox", 0.0, since=3)
    play.senses.group_is("SomeoneNeedsHelp", 1.0, since=2)
    play.senses.group_is("SomeoneNeedsHelp", 0.0, since=3)
    assert [names(play) for _ in range(4)] == [
        ["Forward", "Forward"],
        ["RotateLeft", "RotateLeft"],
        ["RotateRight", "RotateRight"],
        ["Forward", "Forward"],
    ]


def test_ticks_in_start_are_0_when_a_directed_behavior_is_first_evaluated() -> None:
    late = automaton(
        "late",
        state("walk", "Forward"),
        features=(TICKS,),
        rules=rules((START, at_least("ticks", 1), "walk")),
    )
    lead = automaton("lead", state("late", "late"), rules=rules((START, (), "late")))
    assert one_group(late, group=(lead,)).trace("a", 3) == [START, "walk", "walk"]


def test_a_controller_in_start_leaves_the_last_direction_standing() -> None:
    once = automaton(
        "once",
        state("look", "look"),
        flag("over"),
        features=(HELP,),
        rules=rules((START, no("help"), "look"), ("look", yes("help"), "over")),
    )
    play = one_group(LOOK, group=(once,), top="once")
    play.senses.group_is("SomeoneNeedsHelp", 1.0, since=1)
    assert [names(play) for _ in range(3)] == [["Forward", "Forward"]] * 3
    assert play.states("g") == START


def test_before_its_first_direction_a_controllers_agents_idle() -> None:
    waiting = automaton("waiting", state("look", "look"))
    assert names(one_group(LOOK, group=(waiting,), top="waiting")) == []


def test_a_derived_one_shot_is_directed_once() -> None:
    grab = automaton("grab", state("grab", "GrabBox"), rules=rules((START, (), "grab")))
    play = one_group(group=(grab,), top="grab")
    assert [names(play) for _ in range(3)] == [["GrabBox", "GrabBox"], [], []]


def test_a_controllers_nested_automata_direct_too_from_their_starts_in_the_same_tick() -> None:
    outer = automaton("outer", nested("lead", "lead"), rules=rules((START, (), "lead")))
    play = one_group(LOOK, group=(LEAD, outer), top="outer")
    assert names(play) == ["Forward", "Forward"]
    assert play.states("g") == "lead/look"


def test_a_controller_can_be_started_with_a_derived_behavior_itself() -> None:
    play = one_group(LOOK, top="look")
    assert names(play) == ["Forward", "Forward"]
    assert play.states("g") == ""


def test_directing_what_a_type_cannot_do_names_what_it_can() -> None:
    play = one_group(LOOK)
    with pytest.raises(SessionError, match=r"'a' of type 'agent' has no 'fly'; there are: .*Forward.*look"):
        play.direct("a", "fly")


# ------------------------------------------------------------------------------------------------ joining


def test_a_node_that_joins_starts_what_its_controller_directs_now() -> None:
    play = one_group(LOOK)
    play.senses.feature_is("SeesABox", 1.0)
    play.trace("g", 3)
    play.machine.join("b")
    assert (play.states("a"), play.states("b")) == ("left", START)
    assert play.tick()[1].behavior == "Forward"


def test_a_node_that_joins_takes_the_controllers_bindings() -> None:
    call = automaton(
        "call",
        state("face", "Face", {"target": Ground("closest-attached-agent")}),
        rules=rules((START, (), "face")),
    )
    play = one_group(group=(call,), top="call")
    play.senses.target_is("closest-attached-agent", lambda members, performer: 10 * len(members) + performer)
    play.tick()
    play.actor("b").run = None
    play.machine.join("b")
    assert [action.targets for action in play.tick()] == [(20,), (21,)]


def test_a_node_that_joins_a_controller_that_has_directed_nothing_idles() -> None:
    play = one_group(LOOK, group=(automaton("wait"),), top="wait")
    play.direct("b", "ReleaseBoxAndFinish")
    play.tick()
    play.machine.join("b")
    assert play.actor("b").run is None
    assert play.shown("b") == set()


def test_a_node_that_joins_a_controller_in_start_starts_the_direction_that_still_stands() -> None:
    play = one_group(LOOK)
    play.tick()
    play.machine.enter(play.actor("g"), play.run("g"), START)
    play.machine.join("b")
    assert play.run("b").behavior is LOOK


# ---------------------------------------------------------------------------------------- several levels


def squad_of(*automata: Automaton, groups: tuple[Automaton, ...], squad: tuple[Automaton, ...]) -> Play:
    """A squad ``s`` of the groups ``g`` (``a``, ``b``) and ``h`` (``c``)."""
    forest = Hierarchy(
        (inner("s", SQUAD, inner("g", GROUP, *agents("a", "b")), inner("h", GROUP, *agents("c"))),)
    )
    play = Play(forest, types_of(*automata, group=groups, squad=squad))
    play.direct("s", squad[0].name)
    return play


def test_all_levels_decide_in_one_tick_from_the_top_down() -> None:
    command = automaton("command", state("lead", "lead"), rules=rules((START, (), "lead")))
    play = squad_of(LOOK, groups=(LEAD,), squad=(command,))
    assert names(play) == ["Forward"] * 3
    assert [play.states(node) for node in "sghabc"] == ["lead", "look", "look", "walk", "walk", "walk"]


def test_a_level_2_direction_passes_through_level_1_to_the_agents_in_the_same_tick() -> None:
    command = automaton("command", state("walk", "Forward"), rules=rules((START, (), "walk")))
    play = squad_of(groups=(), squad=(command,))
    assert names(play) == ["Forward"] * 3
    assert play.run("g").behavior.name == "Forward"


def test_each_group_goes_its_own_way_under_the_same_direction() -> None:
    command = automaton("command", state("lead", "lead"), rules=rules((START, (), "lead")))
    play = squad_of(LOOK, groups=(LEAD,), squad=(command,))
    play.senses.group_is("SomeoneNeedsHelp", 1.0, first=2, since=1)
    play.tick()
    assert names(play) == ["Forward", "Forward", "RotateRight"]


def test_level_2_sees_the_flags_of_level_1_in_its_next_tick() -> None:
    report = automaton("report", flag("done"), features=(HELP,), rules=rules((START, yes("help"), "done")))
    command = automaton(
        "command",
        state("report", "report"),
        state("walk", "Forward"),
        features=(ANY_DONE,),
        rules=rules((START, (), "report"), ("report", yes("any done"), "walk")),
    )
    play = squad_of(groups=(report,), squad=(command,))
    play.senses.group_is("SomeoneNeedsHelp", 1.0, first=2, since=1)
    assert [(play.trace("s", 1)[0], play.shown("h")) for _ in range(3)] == [
        ("report", set()),
        ("report", {DONE}),
        ("walk", set()),
    ]


MIXED_TYPES = (
    NodeType(AGENT),
    NodeType(GROUP, 1, (AGENT,)),
    NodeType(SQUAD, 2, (GROUP, AGENT)),
)


def irregular(squad: Automaton, *automata: Automaton, group: tuple[Automaton, ...] = (LEAD,)) -> Play:
    """An agent ``lone``, and a squad ``s`` with an agent ``a`` directly under it and a group ``g`` of ``b``, ``c``."""
    forest = Hierarchy(
        (*agents("lone"), inner("s", SQUAD, *agents("a"), inner("g", GROUP, *agents("b", "c"))))
    )
    play = Play(forest, types_of(*automata, types=MIXED_TYPES, group=group, squad=(squad,)))
    play.direct("s", squad.name)
    return play


def test_an_agent_directly_under_a_level_2_controller_starts_what_that_directs_beside_the_groups() -> None:
    command = automaton("command", state("look", "look"), rules=rules((START, (), "look")))
    play = irregular(command, LOOK)
    play.direct("lone", "RotateLeft")
    assert names(play) == ["RotateLeft", "Forward", "Forward", "Forward"]
    assert play.actor("s").members == range(1, 4)


def test_agents_at_several_depths_count_once_each_in_a_statistic() -> None:
    command = automaton("command", state("look", "look"), rules=rules((START, (), "look")))
    play = irregular(command, LOOK)
    play.senses.feature_is("SeesABox", 1.0)
    assert play.sees("s", Statistic(Operation.COUNT, Sense("SeesABox"))) == 3.0
    assert play.sees("s", Statistic(Operation.COUNT, Sense("SeesABox"), Over.SUBSIDIARIES)) == 1.0


def test_a_controllers_level_follows_from_the_forest_and_decides_who_ticks_first() -> None:
    play = irregular(automaton("command"), LOOK)
    assert list(play.machine.actors) == ["s", "g", "lone", "a", "b", "c"]


# --------------------------------------------------------------------------------------------- statistics


def seen(operation: Operation, of: Sense | FlagUp, over: Over, values: list[float]) -> float:
    """A statistic over a group whose agents sense *values*, or show `done` where the value is 1."""
    forest = Hierarchy((inner("g", GROUP, *(Node(f"a{k}", AGENT) for k in range(len(values)))),))
    play = Play(forest, types_of(group=(automaton("wait"),)))
    play.direct("g", "wait")
    play.senses.target_is("deposit", 99)
    for agent, value in enumerate(values):
        play.senses.feature_is("DistanceTo", value, agent)
        play.senses.feature_is("SeesABox", value, agent)
        if value == 1.0:
            play.direct(f"a{agent}", "Done")
    play.tick()
    return play.sees("g", Statistic(operation, of, over))


@pytest.mark.parametrize(
    ("operation", "values", "expected"),
    [
        (Operation.ANY, [0.0, 0.0, 1.0], 1.0),
        (Operation.ANY, [0.0, 0.0], 0.0),
        (Operation.ALL, [1.0, 1.0], 1.0),
        (Operation.ALL, [1.0, 0.0], 0.0),
        (Operation.COUNT, [1.0, 0.0, 1.0], 2.0),
        (Operation.MEAN, [1.0, 0.0, 0.0, 0.0], 0.25),
        (Operation.MIN, [1.0, 0.0], 0.0),
        (Operation.MAX, [0.0, 1.0, 0.0], 1.0),
    ],
)
@pytest.mark.parametrize("of", [Sense("SeesABox"), FlagUp(DONE)])
@pytest.mark.parametrize("over", list(Over))
def test_statistics_sum_up_features_and_flags_of_agents(
    operation: Operation, of: Sense | FlagUp, over: Over, values: list[float], expected: float
) -> None:
    assert seen(operation, of, over, values) == expected


@pytest.mark.parametrize(
    ("operation", "expected"),
    [(Operation.MEAN, 4.0), (Operation.MIN, -1.5), (Operation.MAX, 11.0), (Operation.COUNT, 3.0)],
)
def test_statistics_of_continuous_features(operation: Operation, expected: float) -> None:
    values = [11.0, -1.5, 2.5]
    assert seen(operation, Sense("SeesABox"), Over.AGENTS, values) == expected


@pytest.mark.parametrize(
    ("operation", "expected"),
    [
        (Operation.ANY, 0.0),
        (Operation.ALL, 1.0),
        (Operation.COUNT, 0.0),
        (Operation.MEAN, 1000.0),
        (Operation.MIN, 1000.0),
        (Operation.MAX, 1000.0),
    ],
)
def test_over_nobody_any_and_count_are_0_all_is_1_and_the_others_the_features_default(
    operation: Operation, expected: float
) -> None:
    command = automaton("command")
    play = squad_of(groups=(), squad=(command,))
    distance = Sense("DistanceTo", {"target": Ground("closest-attached-agent")})
    assert play.sees("s", Statistic(operation, distance, Over.SUBSIDIARIES)) == expected


def test_direct_flags_are_those_of_the_subsidiaries_and_all_the_way_down_those_of_the_agents() -> None:
    report = automaton("report", flag("done"), rules=rules((START, (), "done")))
    command = automaton("command", state("report", "report"), rules=rules((START, (), "report")))
    play = squad_of(groups=(report,), squad=(command,))
    play.tick()
    assert play.sees("s", Statistic(Operation.COUNT, FlagUp(DONE), Over.SUBSIDIARIES)) == 2.0
    assert play.sees("s", Statistic(Operation.COUNT, FlagUp(DONE), Over.AGENTS)) == 0.0
    play.direct("c", "ReleaseBoxAndFinish")
    play.tick()
    assert play.sees("s", Statistic(Operation.COUNT, FlagUp(FINISHED), Over.AGENTS)) == 1.0
    assert play.sees("s", Statistic(Operation.COUNT, FlagUp(FINISHED), Over.SUBSIDIARIES)) == 0.0


def test_a_statistic_of_a_flag_does_not_see_flags_of_automata_deeper_inside_a_node() -> None:
    seek = automaton("seek", flag("done"), rules=rules((START, (), "done")))
    outer = automaton("outer", nested("seek", "seek"), rules=rules((START, (), "seek")))
    play = one_group(seek, outer, group=(automaton("wait"),), top="wait")
    play.direct("a", "outer")
    play.tick()
    assert play.sees("a", FlagUp(DONE)) == 1.0
    assert play.sees("g", Statistic(Operation.ANY, FlagUp(DONE))) == 0.0


def test_a_controllers_flag_feature_is_that_of_its_own_sub_automaton() -> None:
    sub = automaton("sub", flag("done"), rules=rules((START, (), "done")))
    lead = automaton(
        "lead",
        nested("sub", "sub"),
        state("walk", "Forward"),
        features=(DONE_UP,),
        rules=rules((START, (), "sub"), ("sub", yes("done"), "walk")),
    )
    play = one_group(group=(lead, sub))
    assert play.trace("g", 2) == ["sub/start", "walk"]


def test_a_group_feature_of_the_scenario_is_asked_for_the_agents_below() -> None:
    play = squad_of(groups=(LEAD,), squad=(automaton("command"),))
    play.direct("h", "lead")
    play.senses.group_is("SomeoneNeedsHelp", 1.0, first=2)
    assert play.sees("h", HELP.source) == 1.0
    assert play.sees("s", HELP.source) == 0.0


def test_a_controller_has_no_body_to_sense_with() -> None:
    with pytest.raises(ScenarioError, match="no feature 'SeesABox'; there are: SomeoneNeedsHelp"):
        one_group(LOOK).sees("g", SEES.source)


def test_an_agent_has_no_group_features() -> None:
    play = one_group(LOOK)
    play.direct("a", "look")
    with pytest.raises(ScenarioError, match="no feature 'SomeoneNeedsHelp'"):
        play.sees("a", HELP.source)
