"""All features read the flags as they were when the tick began, whoever ticks first."""

from app.core.automaton import START, Automaton
from app.core.features import FeatureUse, FlagUp, Operation, Over, Sense, Statistic
from app.core.hierarchy import Hierarchy
from app.core.vocabulary import DONE, FINISHED
from tests.fakes import SEES, TICKS, Play, agents, at_least, inner, no, rules, types_of, yes
from tests.samples import GROUP, SQUAD, automaton, flag, nested, state

ANY_DONE = FeatureUse("any done", Statistic(Operation.ANY, FlagUp(DONE)))
ANY_FINISHED = FeatureUse("any finished", Statistic(Operation.ANY, FlagUp(FINISHED)))
SUB_DONE = FeatureUse("sub done", Statistic(Operation.ANY, FlagUp(DONE), Over.SUBSIDIARIES))
HELP = FeatureUse("help", Sense("SomeoneNeedsHelp"))

#: Walks until it sees a box, then lets go and has finished.
JOB = automaton(
    "job",
    state("walk", "Forward"),
    state("end", "ReleaseBoxAndFinish"),
    features=(SEES,),
    rules=rules((START, (), "walk"), ("walk", yes("sees"), "end")),
)
#: Turns left if an agent shows `done` when it starts, right if none does.
ASK = automaton(
    "ask",
    state("left", "RotateLeft"),
    state("right", "RotateRight"),
    features=(ANY_DONE,),
    rules=rules((START, yes("any done"), "left"), (START, (), "right")),
)


def one_group(*group: Automaton) -> Play:
    """A group ``g`` of ``a`` and ``b``, whose agent ``a`` finishes its job in tick 1 and starts it again."""
    play = Play(Hierarchy((inner("g", GROUP, *agents("a", "b")),)), types_of(JOB, group=group))
    play.direct("g", group[0].name)
    play.senses.feature_is("SeesABox", 1.0, agent=0, since=1)
    play.senses.feature_is("SeesABox", 0.0, agent=0, since=2)
    return play


def test_a_flag_that_an_agent_raises_is_not_seen_by_its_controller_within_the_tick() -> None:
    watch = automaton(
        "watch",
        state("job", "job"),
        state("left", "RotateLeft"),
        features=(ANY_FINISHED,),
        rules=rules((START, (), "job"), ("job", yes("any finished"), "left")),
    )
    play = one_group(watch)
    assert play.trace("g", 3) == ["job", "job", "left"]


def test_an_automaton_that_starts_as_its_controller_leaves_a_direction_still_sees_the_flags_of_that_direction() -> (
    None
):
    leave = automaton(
        "leave",
        state("job", "job"),
        nested("ask", "ask"),
        features=(HELP,),
        rules=rules((START, (), "job"), ("job", yes("help"), "ask")),
    )
    play = one_group(leave, ASK)
    play.senses.group_is("SomeoneNeedsHelp", 1.0, since=3)
    assert play.trace("g", 4) == ["job", "job", "job", "ask/left"]


def test_flags_of_a_direction_that_was_left_are_gone_in_the_next_tick() -> None:
    slow = automaton("slow", nested("ask", "ask"), features=(HELP,), rules=rules((START, no("help"), "ask")))
    leave = automaton(
        "leave",
        state("job", "job"),
        nested("slow", "slow"),
        features=(HELP,),
        rules=rules((START, (), "job"), ("job", yes("help"), "slow")),
    )
    play = one_group(leave, slow, ASK)
    play.senses.group_is("SomeoneNeedsHelp", 1.0, since=3)
    play.senses.group_is("SomeoneNeedsHelp", 0.0, since=4)
    assert play.trace("g", 5) == ["job", "job", "job", "slow/start", "slow/ask/right"]


def one_squad(command: Automaton, *group: Automaton) -> Play:
    """A squad ``s`` of the groups ``g`` (``a``, ``b``) and ``h`` (``c``); ``a`` finishes its job in tick 1."""
    forest = Hierarchy(
        (inner("s", SQUAD, inner("g", GROUP, *agents("a", "b")), inner("h", GROUP, *agents("c"))),)
    )
    play = Play(forest, types_of(JOB, group=group, squad=(command,)))
    play.direct("s", command.name)
    play.senses.feature_is("SeesABox", 1.0, agent=0, since=1)
    play.senses.feature_is("SeesABox", 0.0, agent=0, since=2)
    return play


WORK = automaton("work", state("job", "job"), rules=rules((START, (), "job")))


def test_a_controller_that_is_directed_anew_sees_the_flags_of_its_agents_as_when_the_tick_began() -> None:
    command = automaton(
        "command",
        state("work", "work"),
        state("ask", "ask"),
        features=(ANY_FINISHED,),
        rules=rules((START, (), "work"), ("work", yes("any finished"), "ask")),
    )
    play = one_squad(command, WORK, ASK)
    play.trace("s", 3)
    assert play.states("s") == "ask"
    assert (play.states("g"), play.states("h")) == ("left", "right")


def test_flags_of_a_direction_whose_controller_is_directed_anew_are_gone_in_the_next_tick() -> None:
    late = automaton(
        "late", nested("ask", "ask"), features=(TICKS,), rules=rules((START, at_least("ticks", 1), "ask"))
    )
    command = automaton(
        "command",
        state("work", "work"),
        state("late", "late"),
        features=(ANY_FINISHED,),
        rules=rules((START, (), "work"), ("work", yes("any finished"), "late")),
    )
    play = one_squad(command, WORK, late, ASK)
    assert play.trace("g", 4) == ["job", "job", START, "ask/right"]
    assert play.shown("a") == set()


def test_flags_that_fall_as_a_direction_passes_through_a_controller_were_seen_above_in_the_same_tick() -> (
    None
):
    command = automaton(
        "command",
        state("work", "work"),
        state("walk", "Forward"),
        features=(ANY_FINISHED,),
        rules=rules((START, (), "work"), ("work", yes("any finished"), "walk")),
    )
    play = one_squad(command, WORK)
    assert play.trace("s", 3) == ["work", "work", "walk"]
    assert [play.shown(node) for node in "abc"] == [set(), set(), set()]
    assert play.sees("s", ANY_FINISHED.source) == 0.0


def test_groups_side_by_side_do_not_see_each_others_flags() -> None:
    watch = automaton(
        "watch",
        state("job", "job"),
        state("left", "RotateLeft"),
        features=(ANY_FINISHED,),
        rules=rules((START, (), "job"), ("job", yes("any finished"), "left")),
    )
    command = automaton("command", state("watch", "watch"), rules=rules((START, (), "watch")))
    play = one_squad(command, watch)
    play.trace("s", 4)
    assert (play.states("g"), play.states("h")) == ("left", "job")


def test_a_flag_that_a_controller_raises_is_seen_by_nobody_within_the_tick() -> None:
    report = automaton(
        "report",
        state("job", "job"),
        flag("done"),
        features=(ANY_FINISHED,),
        rules=rules((START, (), "job"), ("job", yes("any finished"), "done")),
    )
    command = automaton(
        "command",
        state("report", "report"),
        state("walk", "Forward"),
        features=(SUB_DONE,),
        rules=rules((START, (), "report"), ("report", yes("sub done"), "walk")),
    )
    play = one_squad(command, report)
    # tick 1: the agent has finished; 2: its group sees that, and is done; 3: the squad sees that
    assert play.trace("s", 4) == ["report", "report", "report", "walk"]
