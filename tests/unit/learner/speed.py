"""How long learning takes: ``python -m tests.unit.learner.speed [COUNT...]``, from the repository's root.

The examples have six features (two angles, two distances, a boolean, a category) and three labels that follow a rule;
"noisy" gives one in twenty a label by chance. Times are of the whole of `learn`, without cross-validation.
"""

import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from math import pi, sin
from random import Random

from app.core.examples import Example
from app.core.features import FeatureUse, Ground, Sense
from app.core.library import Library
from app.core.project import Project
from app.core.tree import Tree
from app.learner.trainer import learn
from tests import samples

FEATURES = {
    "ahead": Sense("DirectionTo", {"target": Ground("nearest-box")}),
    "home": Sense("DirectionTo", {"target": Ground("deposit")}),
    "near": Sense("DistanceTo", {"target": Ground("nearest-box")}),
    "far": Sense("DistanceTo", {"target": Ground("deposit")}),
    "sees": Sense("SeesABox"),
    "ground": Sense("Ground"),
}


def examples(count: int, noise: float) -> Iterator[Example]:
    """Examples of one state."""
    random = Random(1)
    for number in range(count):
        values = {
            "ahead": random.uniform(-pi, pi),
            "home": random.uniform(-pi, pi),
            "near": random.uniform(0.0, 100.0),
            "far": random.uniform(0.0, 100.0),
            "sees": float(random.random() < 0.5),
            "ground": float(random.randrange(3)),
        }
        label = "forward" if values["near"] < 40.0 else "right"
        if abs(values["ahead"] + 0.3 * sin(values["home"])) < 0.7:
            label = "left"
        if random.random() < noise:
            label = random.choice(["forward", "left", "right"])
        yield Example(str(number), "forward", label, values, pick=number + 1)


def project(count: int, noise: float = 0.0) -> Project:
    """A project in which one automaton has this many examples, all of one state."""
    automaton = samples.automaton(
        "taught",
        samples.state("forward", "Forward"),
        samples.state("left", "RotateLeft"),
        samples.state("right", "RotateRight"),
        features=tuple(FeatureUse(name, source) for name, source in FEATURES.items()),
    )
    made = {samples.AGENT: {"taught": tuple(examples(count, noise))}}
    return replace(
        samples.project(), libraries={samples.AGENT: Library({"taught": automaton})}, examples=made
    )


def seconds(taught: Project, times: int) -> tuple[float, Tree]:
    """The shortest of several times, and the tree."""
    best = float("inf")
    for _ in range(times):
        began = time.perf_counter()
        learned = learn(taught, samples.vocabulary())
        best = min(best, time.perf_counter() - began)
    tree = learned.automata[samples.AGENT, "taught"].models["forward"]
    assert isinstance(tree, Tree)
    return best, tree


def main(counts: list[int]) -> None:
    for count in counts:
        for name, noise in (("exact", 0.0), ("noisy", 0.05)):
            spent, tree = seconds(project(count, noise), 1 if count > 10_000 else 5)
            nodes = sum(1 for _ in tree.nodes())
            print(
                f"{count:>8} {name}: {1000 * spent:8.1f} ms, {nodes} nodes, depth {tree.depth()}", flush=True
            )


if __name__ == "__main__":
    main([int(word) for word in sys.argv[1:]] or [100, 1000, 100_000])
