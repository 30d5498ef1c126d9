"""Properties of trees over random ones."""

from random import Random

from hypothesis import given, settings
from hypothesis import strategies as st

from app.core.conditions import guard_met
from app.core.features import FeatureUse, FlagUp, Sense, TicksInState
from app.core.library import Types
from app.core.tree import Branch, Forest, Tree, flatten, unflatten
from tests.random_automata import TYPES, Author
from tests.samples import AGENT, vocabulary

SEEDS = st.integers(0, 1 << 32)
USES = (
    FeatureUse("d", Sense("DistanceTo")),
    FeatureUse("angle", Sense("DirectionTo")),
    FeatureUse("ground", Sense("Ground")),
    FeatureUse("done", FlagUp("done")),
    FeatureUse("ticks", TicksInState()),
)


def a_tree(seed: int) -> Tree:
    author = Author(Random(seed), Types(TYPES, {}, vocabulary()), AGENT, reach=100.0)
    return author.tree(("go", "stop", "turn"), USES, depth=6)


def some_values(seed: int) -> dict[str, float]:
    random = Random(seed)
    return {
        "d": random.uniform(0.0, 100.0),
        "angle": random.uniform(-3.2, 3.2),
        "ground": float(random.randrange(3)),
        "done": float(random.randrange(2)),
        "ticks": float(random.randrange(5)),
    }


@settings(max_examples=100)
@given(SEEDS)
def test_unflattening_gives_the_same_tree_back(seed: int) -> None:
    tree = a_tree(seed)
    flat = flatten(tree)
    assert unflatten(flat) == tree
    assert flatten(unflatten(flat)) == flat


@settings(max_examples=100)
@given(SEEDS, SEEDS)
def test_a_walk_through_the_flat_form_ends_where_the_tree_decides(seed: int, at: int) -> None:
    tree, values = a_tree(seed), some_values(at)
    flat, node = flatten(tree), 0
    nodes = list(tree.nodes())
    while flat.slot[node] >= 0:
        branch = nodes[node]
        assert isinstance(branch, Branch)
        node = flat.yes[node] if branch.test.holds(values[flat.features[flat.slot[node]]]) else flat.no[node]
    decided = tree.decide(values.__getitem__)
    assert nodes[node].counts == flat.counts[node]
    assert sum(flat.counts[node]) == 0.0 or decided.probabilities == tuple(
        count / sum(flat.counts[node]) for count in flat.counts[node]
    )


@settings(max_examples=100)
@given(SEEDS, SEEDS)
def test_an_explanation_is_met_and_as_long_as_the_key(seed: int, at: int) -> None:
    tree, values = a_tree(seed), some_values(at)
    why = tree.explain(values.__getitem__)
    assert guard_met(why, values.__getitem__)
    assert [condition.wanted for condition in why] == [
        digit == "1" for digit in f"{tree.decide(values.__getitem__).key[0]:b}"[1:]
    ]


@settings(max_examples=50)
@given(st.lists(SEEDS, min_size=1, max_size=4), SEEDS)
def test_a_forest_stays_within_what_its_trees_say(seeds: list[int], at: int) -> None:
    trees, values = tuple(a_tree(seed) for seed in seeds), some_values(at)
    mean = Forest(trees[0].labels, trees).decide(values.__getitem__).probabilities
    said = [tree.decide(values.__getitem__).probabilities for tree in trees]
    for k, p in enumerate(mean):
        assert min(one[k] for one in said) - 1e-12 <= p <= max(one[k] for one in said) + 1e-12
