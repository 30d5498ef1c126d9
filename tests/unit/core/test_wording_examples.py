"""Values, states, rules and examples in words, and every sentence of the shipped project."""

from collections.abc import Iterator
from math import inf, nan, pi
from pathlib import Path

import pytest

from app.core.automaton import START, Automaton, Rule
from app.core.examples import Example
from app.core.features import FeatureUse, Sense
from app.core.hierarchy import Node
from app.core.library import Library
from app.core.project import Project
from app.core.storage import load
from app.core.tree import Branch, Leaf, Tree
from app.core.wording import (
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
from tests import samples
from tests.foragers import no, yes
from tests.samples import automaton, nested, state
from tests.unit.core.all_features import DEPOSIT, EXPLAINED, FORAGER, FORAGING

# ------------------------------------------------------------------------------------------------- values


@pytest.mark.parametrize(
    ("feature", "value", "words", "reading"),
    [
        ("sees", 1.0, "yes", "sees a box"),
        ("sees", 0.0, "no", "sees no box"),
        ("away", 12.34567, "12.3 units", "12.3 units from deposit"),
        ("away", 1000.0, "1,000 units", "there is no deposit"),
        ("away", 12345.6, "12,346 units", "12,346 units from deposit"),
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
