"""Tests, values, states and examples in the words that the user reads."""

from collections.abc import Iterator
from math import inf, nan, pi
from pathlib import Path

import pytest

from app.core.automaton import START, Automaton, Rule
from app.core.conditions import AtMost, Condition, Equals, Guard, InArc
from app.core.examples import Example
from app.core.features import (
    FeatureUse,
    FlagUp,
    Ground,
    Operation,
    Over,
    Parameter,
    Sense,
    Source,
    Statistic,
    TicksInState,
)
from app.core.hierarchy import Node
from app.core.library import Library
from app.core.project import Project
from app.core.storage import load
from app.core.tree import Branch, Leaf, Tree
from app.core.vocabulary import DONE, FAILED, FINISHED, Feature, FeatureKind, Phrases, Vocabulary
from app.core.wording import (
    Speech,
    condition_words,
    content_words,
    example_words,
    guard_words,
    held_words,
    node_words,
    reading_words,
    rule_words,
    state_words,
    value_words,
)
from app.engine.deciding import leaves
from app.sim.scenarios.foraging import scenario as foraging
from tests import chase, samples
from tests.samples import automaton, nested, state

FORAGING = foraging.vocabulary
BOX = {"target": Ground("nearest visible box")}
DEPOSIT = {"target": Ground("deposit")}
OPEN = {"target": Parameter("X")}
EXPLAINED = Speech(clause=True, group="Group 3", held="Goto", targets={"X": "deposit"}, detailed=True)

SOURCES: dict[str, Source] = {
    "sees": Sense("ICanSeeABox"),
    "box": Sense("DistanceTo", BOX),
    "away": Sense("DistanceTo", DEPOSIT),
    "x": Sense("DistanceTo", OPEN),
    "toward": Sense("DirectionTo", DEPOSIT),
    "ahead": Sense("DirectionTo", BOX),
    "full": Sense("MyBoxMoves"),
    "help": Sense("SomeoneNeedsHelp"),
    "done": FlagUp(DONE),
    "failed": FlagUp(FAILED),
    "odd": FlagUp("odd"),
    "ticks": TicksInState(),
    "any": Statistic(Operation.ANY, Sense("IAmAttachedToABox")),
    "all": Statistic(Operation.ALL, Sense("IAmAttachedToABox")),
    "full one": Statistic(Operation.ANY, Sense("MyBoxMoves")),
    "count": Statistic(Operation.COUNT, Sense("ICanSeeABox")),
    "direct": Statistic(Operation.ANY, FlagUp(FINISHED), Over.SUBSIDIARIES),
    "all done": Statistic(Operation.ALL, FlagUp(DONE), Over.SUBSIDIARIES),
    "mean": Statistic(Operation.MEAN, Sense("DistanceTo", DEPOSIT)),
    "share": Statistic(Operation.MEAN, Sense("ICanSeeABox")),
    "min": Statistic(Operation.MIN, Sense("DistanceTo", DEPOSIT)),
    "max": Statistic(Operation.MAX, Sense("DistanceTo", DEPOSIT)),
    "gone": Sense("Gone"),
}
FORAGER = Automaton("f", "F", features=tuple(FeatureUse(i, source) for i, source in SOURCES.items()))


def yes(feature: str) -> Condition:
    return Condition(Equals(feature, 1.0))


def no(feature: str) -> Condition:
    return Condition(Equals(feature, 1.0), wanted=False)


def within(feature: str, threshold: float) -> Condition:
    return Condition(AtMost(feature, threshold))


def above(feature: str, threshold: float) -> Condition:
    return Condition(AtMost(feature, threshold), wanted=False)


def arc(feature: str, start: float, end: float, *, wanted: bool = True) -> Condition:
    return Condition(InArc(feature, pi * start / 180.0, pi * end / 180.0), wanted)


# ------------------------------------------------------------------------------------------------ captions


@pytest.mark.parametrize(
    ("guard", "words"),
    [
        ((), "always"),
        ((yes("sees"),), "sees a box"),
        ((no("sees"),), "sees no box"),
        ((Condition(Equals("sees", 0.0)),), "sees no box"),
        ((within("away", 5.0),), "within 5 of deposit"),
        ((above("box", 12.34567),), "farther than 12.3 from nearest visible box"),
        ((above("away", 5.0), within("away", 12.0)), "between 5 and 12 from deposit"),
        ((within("away", 12.0), within("away", 8.0), above("away", 5.0)), "between 5 and 8 from deposit"),
        ((above("away", 5.0001), within("away", 5.0002)), "between 5.0001 and 5.0002 from deposit"),
        ((arc("toward", -180, 2.82e-15),), "deposit lies between -180 and 0 degrees"),
        ((arc("toward", -10, 10),), "deposit lies between -10 and 10 degrees"),
        ((arc("toward", -12.185033067, -12.185033067 + 1e-12),), "deposit lies between -12.2 and -12.2 degrees"),
        ((arc("toward", -10, 10, wanted=False),), "deposit does not lie between -10 and 10 degrees"),
        ((arc("toward", 170, -170),), "deposit does not lie between -170 and 170 degrees"),
        ((arc("toward", 0, -180),), "deposit lies between 0 and 180 degrees"),
        ((arc("toward", -90, 90), arc("toward", 0, 135)), "deposit lies between 0 and 90 degrees"),
        ((yes("done"),), "done"),
        ((no("done"),), "not done"),
        ((above("ticks", 20.5),), "more than 20 ticks in this state"),
        ((within("ticks", 1.0),), "at most 1 tick in this state"),
        ((above("ticks", 180 * (1 - 1e-15)),), "at least 180 ticks in this state"),
        ((within("ticks", 180 * (1 - 1e-15)),), "fewer than 180 ticks in this state"),
        ((above("ticks", 2.5), within("ticks", 9.5)), "more than 2 ticks and at most 9 ticks in this state"),
        ((yes("sees"), no("done")), "sees a box and not done"),
        ((yes("gone"),), "Gone is 1"),
        ((yes("nowhere"),), "nowhere is 1"),
    ],
)  # fmt: skip
def test_tests_of_a_forager(guard: Guard, words: str) -> None:
    assert guard_words(guard, FORAGER, FORAGING) == words


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        (above("box", 999.9999), "there is no nearest visible box"),
        (within("box", 999.9999), "there is a nearest visible box"),
        (above("box", 504.4), "there is no nearest visible box within 504"),
        (within("box", 504.4), "there is a nearest visible box within 504"),
        (above("x", 999.9999), "there is no X"),
        (within("x", 999.9999), "there is an X"),
    ],
)
def test_a_bound_near_the_default_tells_whether_there_is_a_target(condition: Condition, words: str) -> None:
    assert condition_words(condition, FORAGER, FORAGING) == words


def test_a_target_that_is_far_but_there_is_told_without_the_default() -> None:
    guard = (above("box", 4.5), within("box", 999.9999))
    assert guard_words(guard, FORAGER, FORAGING) == "farther than 4.5 from nearest visible box"


def test_where_there_is_no_target_nothing_else_is_told_of_it() -> None:
    guard = (arc("ahead", -10, 10), above("box", 999.9999), yes("sees"))
    assert guard_words(guard, FORAGER, FORAGING) == "there is no nearest visible box and sees a box"


def test_arcs_that_overlap_in_two_are_told_one_by_one() -> None:
    guard = (arc("toward", -100, 100), arc("toward", 90, -90))
    assert guard_words(guard, FORAGER, FORAGING) == (
        "deposit lies between -100 and 100 degrees and deposit does not lie between -90 and 90 degrees"
    )


def test_tests_that_no_value_passes_are_told_one_by_one() -> None:
    guard = (above("away", 9.0), within("away", 5.0), yes("sees"), no("sees"))
    assert guard_words(guard, FORAGER, FORAGING) == (
        "farther than 9 from deposit and within 5 of deposit and sees a box and sees no box"
    )


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        (yes("help"), "someone needs help"),
        (yes("any"), "someone is attached to a box"),
        (no("any"), "nobody is attached to a box"),
        (yes("all"), "everyone is attached to a box"),
        (no("all"), "not everyone is attached to a box"),
        (yes("full one"), "the box of someone is full"),
        (above("count", 2.5), "3 or more agents see a box"),
        (within("count", 1.5), "at most 1 agent sees a box"),
        (above("count", 0.5), "someone sees a box"),
        (within("count", 0.5), "nobody sees a box"),
        (yes("direct"), "a subsidiary has finished"),
        (no("direct"), "no subsidiary has finished"),
        (no("all done"), "not every subsidiary is done"),
        (within("mean", 5.0), "the agents on average are within 5 of deposit"),
        (above("share", 0.5), "more than 50% of the agents see a box"),
        (within("min", 5.0), "someone is within 5 of deposit"),
        (above("min", 5.0), "everyone is farther than 5 from deposit"),
        (within("max", 5.0), "everyone is within 5 of deposit"),
        (above("max", 5.0), "someone is farther than 5 from deposit"),
    ],
)
def test_tests_of_a_controller(condition: Condition, words: str) -> None:
    assert condition_words(condition, FORAGER, FORAGING) == words


@pytest.mark.parametrize(
    ("guard", "words"),
    [
        ((above("count", 1.5), within("count", 4.5)), "2 to 4 agents see a box"),
        ((above("count", 2.5), within("count", 3.5)), "3 agents see a box"),
        (
            (above("min", 2.0), within("min", 5.0)),
            "everyone is farther than 2 from deposit and someone is within 5 of deposit",
        ),
        (
            (above("share", 0.25), within("share", 0.5)),
            "more than 25% and at most 50% of the agents see a box",
        ),
    ],
)
def test_ranges_of_a_controller(guard: Guard, words: str) -> None:
    assert guard_words(guard, FORAGER, FORAGING) == words


# ------------------------------------------------------------------------------------------------- clauses


@pytest.mark.parametrize(
    ("guard", "words"),
    [
        ((no("sees"),), "it sees no box that still needs pullers"),
        ((within("away", 5.0),), "it is within 5 of deposit"),
        ((within("x", 5.0),), "it is within 5 of deposit"),
        ((arc("toward", -10, 10),), "deposit lies between -10 and 10 degrees"),
        ((yes("full"),), "its box is full"),
        ((no("full"),), "its box lacks pullers"),
        ((yes("done"),), "Goto is done"),
        ((no("failed"),), "Goto has not failed"),
        ((yes("odd"),), "Goto has raised odd"),
        ((above("ticks", 20.5),), "it has been in Goto for more than 20 ticks"),
        ((no("any"),), "nobody in Group 3 is attached to a box"),
        ((yes("direct"),), "a subsidiary of Group 3 has finished"),
        ((yes("help"),), "someone needs help"),
    ],
)
def test_clauses_of_an_explanation(guard: Guard, words: str) -> None:
    assert guard_words(guard, FORAGER, FORAGING, EXPLAINED) == words


# ------------------------------------------------------------------------------------------ without phrases


@pytest.mark.parametrize(
    ("source", "condition", "words"),
    [
        (Sense("SeesABox"), yes("f"), "SeesABox"),
        (Sense("SeesABox"), no("f"), "not SeesABox"),
        (Sense("DistanceTo", DEPOSIT), within("f", 2.0), "DistanceTo(deposit) is at most 2"),
        (Sense("DistanceTo", DEPOSIT), above("f", 2.0), "DistanceTo(deposit) is above 2"),
        (Sense("DirectionTo", DEPOSIT), arc("f", -10, 10), "DirectionTo(deposit) is between -10 and 10 degrees"),
        (Sense("Ground"), Condition(Equals("f", 1.0)), "Ground is sand"),
        (Sense("Ground"), Condition(Equals("f", 1.0), wanted=False), "Ground is not sand"),
        (Statistic(Operation.ANY, Sense("SeesABox")), yes("f"), "any SeesABox"),
        (Statistic(Operation.COUNT, Sense("Ground")), above("f", 2.5), "count Ground is above 2.5"),
    ],
)  # fmt: skip
def test_without_phrases_the_features_name_tells(source: Source, condition: Condition, words: str) -> None:
    made = Automaton("a", "A", features=(FeatureUse("f", source),))
    assert condition_words(condition, made, samples.vocabulary()) == words


def test_a_name_that_the_user_gave_is_told() -> None:
    made = Automaton("a", "A", features=(FeatureUse("f", Sense("SeesABox"), "box near"),))
    assert condition_words(no("f"), made, samples.vocabulary()) == "not box near"
    assert condition_words(no("f"), made, samples.vocabulary(), Speech(clause=True)) == "box near is false"


CHASE = Automaton(
    "c",
    "C",
    features=(
        FeatureUse("gap", Sense("Gap", {"a": Ground("home"), "b": Ground("nearest hare")})),
        FeatureUse("third", Sense("Third")),
        FeatureUse("hour", Sense("Clock")),
        FeatureUse("alone", Sense("Alone")),
    ),
)


@pytest.mark.parametrize(
    ("guard", "words", "clause"),
    [
        ((within("gap", 5.0),), "home is within 5 of nearest hare", ""),
        ((yes("third"),), "in the middle", "it is in the middle"),
        ((no("third"),), "not in the middle", "it is not in the middle"),
        ((no("third"), Condition(Equals("third", 0.0), wanted=False)), "in the right", "it is in the right"),
        ((Condition(InArc("hour", -3.0, 2.0)),), "it is between -3 and 2 hours", ""),
        ((Condition(InArc("hour", 4.0, -4.0)),), "Clock is not between -4 and 4 hours", ""),
        ((yes("alone"),), "alone", "it is alone"),
        ((no("alone"),), "in company", "it is in company"),
    ],
)
def test_the_second_scenario(guard: Guard, words: str, clause: str) -> None:
    vocabulary = chase.scenario.vocabulary
    assert guard_words(guard, CHASE, vocabulary) == words
    assert guard_words(guard, CHASE, vocabulary, Speech(clause=True)) == (clause or words)


@pytest.mark.parametrize("phrase", ["{", "{}", "{0}", "{x!r}", "{value.real}", "%s", "near {nobody}", " "])
def test_any_phrase_can_be_told(phrase: str) -> None:
    feature = Feature(
        "F", FeatureKind.CONTINUOUS, phrases=Phrases(phrase, phrase, phrase, phrase, phrase, phrase)
    )
    vocabulary = Vocabulary(features={"F": feature})
    made = Automaton("a", "A", features=(FeatureUse("f", Sense("F")),))
    for condition in (within("f", 2.0), above("f", 2.0), yes("f")):
        for speech in (Speech(), EXPLAINED):
            assert "F is" in condition_words(condition, made, vocabulary, speech)


# ------------------------------------------------------------------------------------------------- values


@pytest.mark.parametrize(
    ("feature", "value", "words", "reading"),
    [
        ("sees", 1.0, "yes", "sees a box"),
        ("sees", 0.0, "no", "sees no box"),
        ("away", 12.34567, "12.3 units", "12.3 units from deposit"),
        ("away", 1000.0, "1000 units", "there is no deposit"),
        ("away", 12345.6, "12346 units", "12346 units from deposit"),
        ("away", 0.000123456, "0.000123 units", "0.000123 units from deposit"),
        ("away", 1e-9, "1e-09 units", "1e-09 units from deposit"),
        ("away", -0.0, "0 units", "0 units from deposit"),
        ("toward", -pi / 18.0, "-10°", "deposit lies at -10 degrees"),
        ("toward", pi / 180.0, "1°", "deposit lies at 1 degree"),
        ("away", 1.0, "1 unit", "1 unit from deposit"),
        ("ticks", 0.0, "0 ticks", "just entered this state"),
        ("ticks", 1.0, "1 tick", "1 tick in this state"),
        ("count", 2.0, "2", "2 agents see a box"),
        ("count", 0.0, "0", "nobody sees a box"),
        ("mean", 4.0, "4 units", "the agents on average are 4 units from deposit"),
        ("min", 4.0, "4 units", "min DistanceTo(deposit) is 4 units"),
        ("away", nan, "nan units", "nan units from deposit"),
        ("away", inf, "inf units", "inf units from deposit"),
    ],
)
def test_values(feature: str, value: float, words: str, reading: str) -> None:
    use = FORAGER.feature(feature)
    assert value_words(use, value, FORAGING) == words
    assert reading_words(use, value, FORAGING) == reading


def test_a_category_is_told_by_name_and_an_unknown_one_by_number() -> None:
    use = FeatureUse("g", Sense("Ground"))
    assert [value_words(use, v, samples.vocabulary()) for v in (1.0, 7.0, 0.5)] == ["sand", "7", "0.5"]


# ------------------------------------------------------------------------------------ states, rules, examples


def test_states_contents_and_nodes() -> None:
    goto = samples.goto()
    library = Library({"goto": goto})
    home = nested("home", "goto", DEPOSIT)
    made = automaton("A", home, state("up", "Forward"))
    assert content_words(home.content, library) == "goto(deposit)"
    assert [state_words(made, i, library) for i in ("home", "up", START, "gone")] == [
        "home",
        "up",
        "Start",
        "gone",
    ]
    assert [held_words(made, i, library) for i in ("home", "up", START)] == ["goto", "Forward", "Start"]
    assert node_words(Node("group-3", "group")) == "Group 3"
    assert node_words(Node("group-3", "group", name="North")) == "North"


def test_rules_tell_when_they_apply() -> None:
    made = Automaton(
        "a",
        "A",
        features=FORAGER.features,
        rules=(
            Rule("1", "s", (yes("sees"),), "t"),
            Rule("2", "s", (no("sees"),), "t", 0.25),
            Rule("3", "s", (), "t", 0.005),
            Rule("4", "s", (), "t"),
            Rule("5", START, (), "t"),
        ),
    )
    assert [rule_words(rule, made, FORAGING) for rule in made.rules] == [
        "sees a box",
        "sees no box, 25%",
        "by chance, 0.5%",
        "otherwise",
        "always",
    ]


def test_an_example_tells_of_what_its_leaf_looked_at() -> None:
    tree = Tree(("a", "b"), Branch(yes("sees").test, Leaf((0.0, 1.0)), Leaf((1.0, 0.0)), (1.0, 1.0)))
    made = automaton(
        "F", state("a", "Forward"), state("b", "Forward"), features=FORAGER.features, learned={"a": tree}
    )
    library = Library({"F": made})
    seen = {"sees": 1.0, "away": 5.0}
    assert example_words(Example("1", "a", "b", seen), made, library, FORAGING) == "a → b when it sees a box"
    assert example_words(Example("1", "a", "a", {"sees": 0.0}), made, library, FORAGING) == (
        "stays in a when it sees no box"
    )
    assert example_words(Example("1", "a", "b", {"away": 5.0}), made, library, FORAGING) == "a → b"
    assert example_words(Example("1", "b", "a", seen), made, library, FORAGING) == (
        "b → a when it sees a box and it is 5 units from deposit"
    )
    assert example_words(Example("1", "gone", "a", {}), made, library, FORAGING) == "gone → a"


# --------------------------------------------------------------------------------- all of the shipped project


def every_sentence(project: Project) -> Iterator[str]:
    """All that can be told of the trees, rules and examples of a project."""
    for node_type in project.types:
        library = project.library(node_type.name)
        for made in library.automata.values():
            yield from _of_automaton(made)
            for example in project.examples_of(node_type.name, made.id):
                yield example_words(example, made, library, FORAGING)


def _of_automaton(made: Automaton) -> Iterator[str]:
    guards = [rule.guard for rule in made.rules]
    for model in made.learned.values():
        assert isinstance(model, Tree)
        guards += [path for path, _ in leaves(model.root)]
    for guard in guards:
        yield guard_words(guard, made, FORAGING)
        yield guard_words(guard, made, FORAGING, EXPLAINED)


def test_every_sentence_of_the_shipped_project_is_one() -> None:
    project = load(Path(__file__).parents[3] / "projects" / "foraging")
    told = set(every_sentence(project))
    assert len(told) > 100
    for sentence in told:
        assert sentence.strip() == sentence != ""
        assert not any(
            wrong in sentence for wrong in ("{", "}", "  ", " a X", "ICanSee", "IAm", "Someone", " is is")
        )
    assert "Wander → ReturnWithBox when it sees a box" in told
    assert "stays in Goto(closest attached agent) when not everyone is done" in told
    assert "it sees no box that still needs pullers" in told
