"""How fast behaviors are learned from examples."""

from collections.abc import Iterator, Mapping
from functools import partial
from math import pi, sin
from random import Random

from ...core.automaton import Automaton, Basic, State
from ...core.examples import Example
from ...core.features import FeatureUse, Ground, Sense
from ...core.library import Library
from ...core.project import Project
from ...learner.trainer import learn
from .subject import Subject
from .timing import least

TYPE, TAUGHT = "agent", "taught"
BOX, DEPOSIT = {"target": Ground("nearest visible box")}, {"target": Ground("deposit")}
#: Two of them are angles.
FEATURES = {
    "ahead": Sense("DirectionTo", BOX),
    "home": Sense("DirectionTo", DEPOSIT),
    "near": Sense("DistanceTo", BOX),
    "far": Sense("DistanceTo", DEPOSIT),
    "sees": Sense("ICanSeeABox"),
    "attached": Sense("IAmAttachedToABox"),
}
LABELS: Mapping[str, str] = {"forward": "Forward", "left": "RotateLeft", "right": "RotateRight"}
#: The share of examples with a label by chance: hands err, and errors make trees deep.
NOISE = 0.05


def seconds_to_learn(of: Subject, examples: int, rounds: int) -> float:
    """Seconds that learning one state from so many examples takes, from the project to its trees."""
    project = taught(of.project, of.much(examples))
    work = partial(learn, project, of.scenario.vocabulary)
    return least(lambda: work, of.much(rounds), of.clock)


def milliseconds_to_learn(of: Subject, examples: int, rounds: int) -> float:
    """The same in milliseconds."""
    return 1000.0 * seconds_to_learn(of, examples, rounds)


def taught(project: Project, count: int) -> Project:
    """A project in which one automaton has so many examples, all of one state."""
    states = tuple(State(label, Basic(behavior)) for label, behavior in LABELS.items())
    features = tuple(FeatureUse(name, source) for name, source in FEATURES.items())
    automaton = Automaton(TAUGHT, "Taught", states=(*Automaton("", "").states, *states), features=features)
    return Project(
        "Lesson",
        project.scenario,
        libraries={TYPE: Library({TAUGHT: automaton})},
        examples={TYPE: {TAUGHT: tuple(examples_of(count))}},
    )


def examples_of(count: int) -> Iterator[Example]:
    """Examples that follow a rule in all but a few cases."""
    random = Random(1)
    for number in range(count):
        values = {
            "ahead": random.uniform(-pi, pi),
            "home": random.uniform(-pi, pi),
            "near": random.uniform(0.0, 100.0),
            "far": random.uniform(0.0, 100.0),
            "sees": float(random.random() < 0.5),
            "attached": float(random.random() < 0.5),
        }
        label = "forward" if values["near"] < 40.0 else "right"
        if abs(values["ahead"] + 0.3 * sin(values["home"])) < 0.7:
            label = "left"
        if random.random() < NOISE:
            label = random.choice(tuple(LABELS))
        yield Example(str(number), "forward", label, values, pick=number + 1)
