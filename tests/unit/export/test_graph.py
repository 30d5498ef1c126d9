"""The neutral graph says of an automaton what its transition functions do."""

from dataclasses import replace

from app.core.automaton import START, Automaton, Prune, Refit, Rule
from app.core.conditions import AtMost, Condition, Equals
from app.core.examples import Example
from app.core.library import Library
from app.core.tree import Branch, Leaf, Tree
from app.export.graph import MOST_WAYS, Edge, StateKind, WayKind, formal_words, way_words
from tests.graphs import graph_of
from tests.samples import forage, goto, project, vocabulary, wander, when

LIBRARY = project().library("agent")


def edges(automaton: Automaton, examples: tuple[Example, ...] = ()) -> dict[tuple[str, str], Edge]:
    graph = graph_of(automaton, LIBRARY, vocabulary(), examples)
    return {(edge.source, edge.target): edge for edge in graph.edges}


def test_states_say_what_they_hold() -> None:
    graph = graph_of(forage(), LIBRARY, vocabulary())
    assert [(state.id, state.kind, state.nested) for state in graph.states] == [
        (START, StateKind.START, ""),
        ("wander", StateKind.NESTED, "wander"),
        ("approach", StateKind.NESTED, "goto"),
        ("fetch", StateKind.NESTED, "fetch"),
    ]
    assert [state.raises for state in graph_of(goto(), LIBRARY, vocabulary()).states][-1] == "done"


def test_a_learned_way_is_told_by_its_leaf() -> None:
    way = edges(goto())[START, "done"].ways[0]
    assert (way.kind, way.support, way.total, way.probability) == (WayKind.LEAF, 2.0, 2.0, 1.0)
    assert way.guard == when(AtMost("distance", 2.0))
    assert way_words(way).endswith("2 of 2 examples · p 1.0")
    assert formal_words(way.guard[0], goto()) == "DistanceTo(target) ≤ 2.0"


def test_ways_between_the_same_states_share_an_edge() -> None:
    edge = edges(goto())[START, "forward"]
    assert [way.support for way in edge.ways] == [3.0, 1.0]
    assert edge.support == 4.0


def test_rules_come_first_with_their_order_and_probability() -> None:
    way = edges(wander())["forward", "right"].ways[0]
    assert (way.kind, way.order, way.id, way.probability) == (WayKind.RULE, 2, "3", 0.05)
    assert way_words(way) == "rule 2: by chance, 5% · p 0.05"


def test_a_prune_marks_what_it_forbids_and_shares_it_out() -> None:
    found = edges(replace(goto(), prunes=(Prune("1", "left", (), frozenset({"forward"})),)))
    assert found["left", "forward"].is_pruned
    assert not found["left", "forward"].is_open
    assert found[START, "forward"].is_open
    assert {way.probability for way in found["left", "left"].ways} == {1.0}


def test_a_prune_with_a_looser_guard_than_the_leaf_holds_there() -> None:
    near = Prune("1", START, when(AtMost("distance", 3.0)), frozenset({"done"}))
    assert edges(replace(goto(), prunes=(near,)))[START, "done"].is_pruned


def test_what_rules_leave_nothing_is_told() -> None:
    always = Rule("1", START, (), "left")
    found = edges(replace(goto(), rules=(always, Rule("2", START, (), "done"))))
    assert [way.shadowed for way in found[START, "done"].ways] == [True, True]
    assert found[START, "left"].ways[0].is_open


def test_a_model_without_a_table_form_is_told_by_its_examples() -> None:
    refit = replace(goto(), learned={START: Refit("knn")})
    examples = tuple(Example(str(i), START, label, {}) for i, label in enumerate(("done", "done", "left")))
    way = edges(refit, examples)[START, "done"].ways[0]
    assert (way.kind, way.support, way.total) == (WayKind.MODEL, 2.0, 3.0)


def test_a_tree_of_any_depth_gives_its_strongest_ways_and_counts_the_others() -> None:
    node: Leaf | Branch = Leaf((1.0, 0.0, 0.0))
    for number in range(2000):
        node = Branch(AtMost("distance", number), Leaf((0.0, 1.0 + number % 3, 0.0)), node, (1.0, 1.0, 0.0))
    edge = edges(replace(goto(), learned={START: Tree(("forward", "left", "done"), node)}))[START, "left"]
    assert len(edge.ways) == MOST_WAYS
    assert edge.more == 2000 - MOST_WAYS
    assert {way.support for way in edge.ways} == {3.0}


def test_states_that_are_gone_have_no_edges() -> None:
    broken = replace(wander(), rules=(*wander().rules, Rule("9", START, (), "nowhere")))
    assert (START, "nowhere") not in edges(broken)
    assert graph_of(broken, Library(), vocabulary()).name == "wander"


def test_conditions_are_told_with_their_numbers() -> None:
    assert formal_words(Condition(Equals("sees", 1.0), wanted=False), forage()) == "SeesABox ≠ 1"
