"""One tick of one automaton: traces worked out by hand."""

from app.core.automaton import START
from app.core.conditions import AtMost
from app.core.features import Ground
from app.core.tree import Leaf, Tree
from tests.fakes import HOLDS, SEES, TICKS, at_least, no, one_agent, rules, yes
from tests.samples import automaton, flag, nested, state, when

ONWARD = automaton("onward", state("forward", "Forward"), rules=rules((START, (), "forward")))
TURN_WHEN_SEEING = automaton(
    "turn",
    state("forward", "Forward"),
    state("left", "RotateLeft"),
    features=(SEES,),
    rules=rules((START, (), "forward"), ("forward", yes("sees"), "left"), ("left", no("sees"), "forward")),
)


def test_start_idles() -> None:
    play = one_agent(automaton("still"), top="still")
    assert play.does(3) == ["", "", ""]
    assert play.states("a") == START


def test_the_new_state_is_pulsed_in_the_tick_in_which_it_is_entered() -> None:
    play = one_agent(TURN_WHEN_SEEING, top="turn")
    play.senses.feature_is("SeesABox", 1.0, since=2)
    play.senses.feature_is("SeesABox", 0.0, since=4)
    assert play.does(5) == ["Forward", "Forward", "RotateLeft", "RotateLeft", "Forward"]


def test_one_tick_makes_one_transition_of_an_automaton() -> None:
    chain = automaton(
        "chain",
        state("1", "Forward"),
        state("2", "RotateLeft"),
        rules=rules((START, (), "1"), ("1", (), "2"), ("2", (), "1")),
    )
    assert one_agent(chain, top="chain").trace("a", 4) == ["1", "2", "1", "2"]


def test_nested_starts_are_evaluated_within_the_same_tick() -> None:
    middle = automaton("middle", nested("low", "onward"), rules=rules((START, (), "low")))
    outer = automaton("outer", nested("mid", "middle"), rules=rules((START, (), "mid")))
    play = one_agent(ONWARD, middle, outer, top="outer")
    assert play.does() == ["Forward"]
    assert play.states("a") == "mid/low/forward"


def test_the_outermost_automaton_decides_first_and_what_it_leaves_is_not_evaluated() -> None:
    outer = automaton(
        "outer",
        nested("turn", "turn"),
        state("grab", "GrabBox"),
        features=(HOLDS,),
        rules=rules((START, (), "turn"), ("turn", yes("holds"), "grab")),
    )
    play = one_agent(TURN_WHEN_SEEING, outer, top="outer")
    play.senses.feature_is("SeesABox", 1.0, since=2)
    play.senses.feature_is("IsAttached", 1.0, since=2)
    assert play.trace("a", 2) == ["turn/forward", "turn/forward"]
    play.senses.asked.clear()
    assert play.trace("a", 1) == ["grab"]
    assert play.senses.asked == [("IsAttached", 0, ())]


def test_starting_an_automaton_puts_it_in_start() -> None:
    slow = automaton(
        "slow",
        state("1", "Forward"),
        state("2", "RotateLeft"),
        features=(TICKS,),
        rules=rules((START, (), "1"), ("1", at_least("ticks", 2), "2")),
    )
    outer = automaton(
        "outer",
        nested("slow", "slow"),
        state("right", "RotateRight"),
        features=(SEES,),
        rules=rules((START, (), "slow"), ("slow", yes("sees"), "right"), ("right", no("sees"), "slow")),
    )
    play = one_agent(slow, outer, top="outer")
    play.senses.feature_is("SeesABox", 1.0, since=3)
    play.senses.feature_is("SeesABox", 0.0, since=4)
    assert play.trace("a", 6) == ["slow/1", "slow/1", "slow/2", "right", "slow/1", "slow/1"]


def test_a_one_shot_is_pulsed_on_entry_only_and_idles_while_its_state_stays_current() -> None:
    grab = automaton(
        "grab",
        state("grab", "GrabBox"),
        state("forward", "Forward"),
        features=(SEES,),
        rules=rules((START, (), "grab"), ("grab", no("sees"), "forward"), ("forward", yes("sees"), "grab")),
    )
    play = one_agent(grab, top="grab")
    play.senses.feature_is("SeesABox", 1.0)
    play.senses.feature_is("SeesABox", 0.0, since=3)
    play.senses.feature_is("SeesABox", 1.0, since=4)
    assert play.does(6) == ["GrabBox", "", "", "Forward", "GrabBox", ""]


def test_a_flag_state_raises_its_flag_and_puts_its_automaton_in_start_within_the_same_tick() -> None:
    up = automaton("up", flag("enough", "enough"), rules=rules((START, (), "enough")))
    outer = automaton("outer", nested("up", "up"), rules=rules((START, (), "up")))
    play = one_agent(up, outer, top="outer")
    assert play.does() == [""]
    child = play.run("a").child
    assert child is not None
    assert (child.state, child.flags) == (START, {"enough"})


def test_a_behavior_that_raises_a_flag_runs_once_and_puts_its_automaton_in_start() -> None:
    release = automaton(
        "release",
        state("release", "ReleaseBox"),
        features=(SEES,),
        rules=rules((START, no("sees"), "release")),
    )
    outer = automaton("outer", nested("release", "release"), rules=rules((START, (), "release")))
    play = one_agent(release, outer, top="outer")
    play.senses.feature_is("SeesABox", 1.0, since=1)
    assert play.does() == ["ReleaseBox"]
    assert play.states("a") == "release/start"
    child = play.run("a").child
    assert child is not None
    assert child.flags == {"done"}
    assert play.does(2) == ["", ""]


def test_a_flag_of_the_top_automaton_puts_that_one_in_start() -> None:
    play = one_agent(
        automaton("top", state("done", "Done"), state("on", "Forward"), rules=rules((START, (), "done"))),
        top="top",
    )
    assert play.trace("a", 2) == [START, START]


def test_without_data_for_a_state_it_stays() -> None:
    empty = Tree(("left",), Leaf((0.0,)))
    turn = automaton(
        "turn",
        state("forward", "Forward"),
        state("left", "RotateLeft"),
        rules=rules((START, (), "forward")),
        learned={"forward": empty},
    )
    assert one_agent(turn, top="turn").trace("a", 3) == ["forward", "forward", "forward"]


def test_ticks_in_state_are_0_on_entry_and_1_at_the_next_evaluation() -> None:
    walk = automaton(
        "walk",
        state("forward", "Forward"),
        state("left", "RotateLeft"),
        features=(TICKS,),
        rules=rules((START, (), "forward"), ("forward", at_least("ticks", 3), "left")),
    )
    play = one_agent(walk, top="walk")
    assert play.trace("a", 4) == ["forward", "forward", "forward", "left"]


def test_ticks_in_state_are_0_for_a_start_that_is_evaluated_in_the_tick_in_which_it_began() -> None:
    quick = automaton(
        "quick",
        state("forward", "Forward"),
        features=(TICKS,),
        rules=rules((START, when(AtMost("ticks", 0.0)), "forward")),
    )
    outer = automaton("outer", nested("quick", "quick"), rules=rules((START, (), "quick")))
    assert one_agent(quick, outer, top="outer").trace("a", 1) == ["quick/forward"]
    assert one_agent(quick, top="quick").trace("a", 1) == ["forward"]


def test_ticks_in_start_count_from_the_flag_that_led_there() -> None:
    blink = automaton(
        "blink",
        flag("done"),
        features=(TICKS,),
        rules=rules((START, at_least("ticks", 2), "done")),
    )
    outer = automaton("outer", nested("blink", "blink"), rules=rules((START, (), "blink")))
    play = one_agent(blink, outer, top="outer")
    entered = []
    for _ in range(6):
        play.tick()
        child = play.run("a").child
        assert child is not None
        entered.append(child.entered)
    assert entered == [0, 0, 2, 2, 4, 4]


def test_two_states_may_hold_the_same_behavior_with_different_bindings() -> None:
    face = automaton(
        "face",
        state("box", "Face", {"target": Ground("nearest-box")}),
        state("home", "Face", {"target": Ground("deposit")}),
        features=(HOLDS,),
        rules=rules((START, (), "box"), ("box", yes("holds"), "home")),
    )
    play = one_agent(face, top="face")
    play.senses.target_is("nearest-box", 7)
    play.senses.target_is("deposit", 9)
    play.senses.feature_is("IsAttached", 1.0, since=1)
    assert [play.tick()[0].targets for _ in range(2)] == [(7,), (9,)]


def test_an_agent_can_run_a_basic_behavior_without_any_automaton() -> None:
    assert one_agent(top="Forward").does(2) == ["Forward", "Forward"]
    assert one_agent(top="GrabBox").does(2) == ["GrabBox", ""]


def test_a_node_without_a_behavior_idles() -> None:
    play = one_agent(top="Forward")
    play.actor("a").run = None
    assert play.tick() == []
