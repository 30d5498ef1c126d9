"""Whatever the hand does in a lesson, its demonstration records the same when it is played, or it is said that it would not."""

from contextlib import suppress
from random import Random

from hypothesis import given, settings
from hypothesis import strategies as st

from app.core.automaton import Basic
from app.core.edits import replace_examples, set_learned
from app.core.errors import UnderstudyError
from app.core.features import Ground
from app.core.project import Project
from app.engine.demonstrations import play
from app.learner.trainer import apply, learn
from tests.corridor import corridor
from tests.driver import Driver
from tests.samples import AGENT

SHUTTLE = (AGENT, "Shuttle")
NODES = "agent-1", "agent-2"
STATES = "up", "down", "jump", Basic("Toward", {"target": Ground("lamp")})
ACTS = (
    ("pick",) * 5
    + ("advance",) * 4
    + ("undo",) * 3
    + ("redo",) * 3
    + ("learn", "stale", "test", "mend", "teach")
)
EXAMPLES = 60


def act(driver: Driver, rng: Random, what: str) -> None:
    match what:
        case "pick":
            driver.pick(rng.choice(STATES), rng.choice(NODES))
        case "advance":
            driver.advance(rng.randint(1, 4))
        case "learn":
            driver.edit(learned)
        case "stale":  # as undo in the window brings it back
            before = driver.project.library(AGENT).get("Shuttle")
            driver.edit(set_learned, *SHUTTLE, dict(list(before.learned.items())[1:]), "of before")
        case "mend":
            driver.should_not_have_left(rng.choice(NODES))
        case "teach":
            driver.teach(NODES, "Shuttle", demonstration="shuttle-1")
        case _:
            getattr(driver, what)()


def learned(project: Project) -> Project:
    return apply(project, learn(project, corridor.vocabulary, [SHUTTLE]))


@settings(max_examples=EXAMPLES)
@given(st.integers(0, 1 << 32), st.booleans())
def test_a_lesson_is_played_again_as_it_was_or_it_is_said_why_not(
    seed: int,
    is_tested: bool,
) -> None:
    rng = Random(seed)
    driver = Driver().teach(NODES, "Shuttle", demonstration="shuttle-1")
    begin = ("pick", "advance", "pick", "test") if is_tested else ()
    for what in (*begin, *rng.choices(ACTS, k=rng.randint(4, 14))):
        with suppress(AssertionError, UnderstudyError):  # what is refused changes nothing
            act(driver, rng, what)
    driver.advance()
    if driver.demonstration is None or driver.obstacle:
        return
    untaught = set_learned(replace_examples(driver.project, *SHUTTLE, (), {}), *SHUTTLE, {}, "")
    again = play(untaught, corridor, driver.demonstration)
    assert again.examples_of(*SHUTTLE) == driver.project.examples_of(*SHUTTLE)
    assert again.moments == driver.project.moments
