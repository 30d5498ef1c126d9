"""Sensing: what was sensed once in a look at a moment is kept for it."""

from app.engine.watching import watched
from app.sim.kernel import KernelEngine
from app.sim.sensing import KeptSenses
from tests import foragers


class Counting:
    """Senses that tell apart how often they were asked."""

    def __init__(self) -> None:
        self.asked: list[tuple[object, ...]] = []

    def feature(self, name: str, agent: int, targets: tuple[int, ...]) -> float:
        self.asked.append((name, agent, targets))
        return 0.5

    def group_feature(self, name: str, members: range) -> float:
        self.asked.append((name, members))
        return 1.0

    def target(self, name: str, members: range, performer: int) -> int:
        self.asked.append((name, members, performer))
        return 7


def test_what_was_sensed_once_in_a_look_is_not_worked_out_again() -> None:
    senses = Counting()
    kept = KeptSenses(senses)
    for _ in range(3):
        assert kept.feature("DistanceTo", 1, (7,)) == 0.5
        assert kept.feature("DistanceTo", 2, (7,)) == 0.5
        assert kept.group_feature("SomeoneNeedsHelp", range(5)) == 1.0
        assert kept.target("deposit", range(1), 1) == 7
    assert senses.asked == [
        ("DistanceTo", 1, (7,)),
        ("DistanceTo", 2, (7,)),
        ("SomeoneNeedsHelp", range(5)),
        ("deposit", range(1), 1),
    ]


def test_every_look_senses_anew() -> None:
    forest, top = foragers.STRUCTURES["two levels"]
    engine = KernelEngine(foragers.start(forest, top))
    seen = []
    for _ in range(2):
        (told,) = watched(engine, ["agent-1"]).values()
        seen.append(told.levels)
        engine.step(50)
    assert seen[0] != seen[1]
