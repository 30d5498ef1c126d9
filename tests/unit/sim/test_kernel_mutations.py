"""Mistakes put into the kernel's text on purpose: comparing random runs with the reference engine finds each of them.

The mistaken kernels run uncompiled. Were one not found, the comparison could not be trusted to find it in earnest.
"""

from functools import cache

import pytest

from app.sim.engine import Engine
from app.sim.kernel import KernelEngine
from app.sim.reference import ReferenceEngine
from tests.plain_kernel import TEXT, plain_kernel
from tests.random_runs import begin, difference, random_start, two_owners

TICKS = 25
#: The runs that are compared until a mistake shows, those first that show what hardly any other does.
SEEDS = tuple(
    dict.fromkeys((0, 2, 8, 293, 184, 116, 114, 111, 87, 80, 68, 55, 27, 19, 15, 14, 11, *range(60)))
)

#: What is wrong -> the text, and what stands there instead.
MISTAKES = {
    "a test fails at its upper end": ("<= tab.high[at]", "< tab.high[at]"),
    "a test fails at its lower end": ("tab.low[at] <= value", "tab.low[at] < value"),
    "tests have no lower end": ("tab.low[at] <= value", "value"),
    "a rule takes all that is left": ("left = left * (1.0 - probability)", "left = 0.0"),
    "a rule takes its whole probability": ("= left * probability", "= probability"),
    "rules leave nothing to the model": ("left > 0.0 else 0", "left >= 1.0 else 0"),
    "prunes forbid nothing": ("if forbidden >> k & 1:", "if forbidden >> k & 2 and forbidden < 0:"),
    "what prunes leave is not made whole": ("if forbidden != 0 and total > 0.0:", "if forbidden < 0:"),
    "trees of a forest are summed, not averaged": ("runs.total[k] / trees if", "runs.total[k] if"),
    "the last tree of a forest decides": (
        "before = runs.total[k] if tree > 0 else 0.0",
        "before = 0.0",
    ),
    "hold draws at every tick": (
        "if tab.sampling[state] == HOLD and changed == 0:",
        "if tab.sampling[state] == HOLD and changed < 0:",
    ),
    "hold forgets which labels were possible": (
        "changed += changed_word(runs, row * tab.key_words + 1, possible)",
        "changed_word(runs, row * tab.key_words + 1, possible)",
    ),
    "argmax takes the last of equals": (
        "> runs.state_total[best]",
        ">= runs.state_total[best]",
    ),
    "every level draws the same number": ("drawer(tab, node), level)", "drawer(tab, node), 0)"),
    "controllers draw as agents": ("else FIRST_CONTROLLER + node", "else node"),
    "entering keeps the old tick": (
        "    runs.state[row] = new\n    runs.entered[row] = now",
        "    runs.state[row] = new",
    ),
    "a one-shot goes on": ("runs.pulsed[row] == 0 or tab.once[basic] == 0", "runs.pulsed[row] >= 0"),
    "an open target is no reason to idle": ("if entity == -1:\n            found = False", "pass"),
    "a feature without referent is 0": ("return tab.default[use]", "return 0.0"),
    "finished is not raised": ("runs.node_flags[node] |= FINISHED_BIT", "pass"),
    "a flag raised replaces those that are up": ("runs.flags[row] |= flag", "runs.flags[row] = flag"),
    "a flag state does not go back to start": (
        "runs.state[row] = tab.start[runs.what[row]]\n    runs.entered[row] = now",
        "runs.entered[row] = now",
    ),
    "roots keep their flags": ("if tab.parent[node] < 0:", "if tab.parent[node] < -1:"),
    "directed flags never fall": (
        "    if directs(tab, runs, node):\n        runs.left[node] = 1\n    runs.state",
        "    runs.state",
    ),
    "a directed node keeps finished": ("    runs.node_flags[child] = 0\n", ""),
    "only direct subsidiaries are directed": (
        "                runs.stack[waiting] = child\n                waiting += 1",
        "                pass",
    ),
    "a parameter's owner is who uses it": (
        "runs.argument[slot], runs.owner[slot], me, stamp)",
        "runs.argument[slot], node, me, stamp)",
    ),
    "a directed behavior's target is its own": (
        "runs.owner[row * tab.arguments + k] = runs.direction_owner[parent * tab.arguments + k]",
        "runs.owner[row * tab.arguments + k] = child",
    ),
    "what one agent found is found by all": (
        "runs.target_stamp[target] != stamp or runs.target_owner[target] != owner",
        "runs.target_owner[target] != owner",
    ),
    "what one owner means is meant by all": (
        "runs.target_stamp[target] != stamp or runs.target_owner[target] != owner",
        "runs.target_stamp[target] != stamp",
    ),
    "features are sensed once for all": ("if runs.use_stamp[use] != stamp:", "if runs.use_stamp[use] == 0:"),
    "all of somebody is any": (
        "(count == 0 or so_far != 0.0) and value",
        "(count == 0 or so_far != 0.0) or value",
    ),
    "a mean is a sum": ("return result / count if", "return result if"),
    "the least is the first": ("operation == MIN and value < so_far", "operation == MIN and value < -1e9"),
    "direct subsidiaries are all agents below": (
        "below = tab.child[place] if tab.direct[use] != 0 else place",
        "below = place",
    ),
    "ticks in state start at 1": ("float(now - runs.entered[row])", "float(now - runs.entered[row] + 1)"),
    "agents that idle go on": ("            runs.act[agent] = -1\n", ""),
    "agents drive on": ("        world.drive[agent] = 0.0\n", ""),
}


@cache
def wanted(seed: int | None) -> ReferenceEngine:
    """A reference engine after the ticks that are compared."""
    engine = ReferenceEngine(two_owners() if seed is None else random_start(seed))
    _pass(engine, seed)
    return engine


def _pass(engine: Engine, seed: int | None) -> None:
    if seed is not None:
        begin(engine, seed)
    engine.step(TICKS)


def is_caught(text: str) -> bool:
    """Whether some run differs with a kernel of this text."""
    with plain_kernel(text):
        for seed in (None, *SEEDS):
            right = wanted(seed)
            found = KernelEngine(right.start)
            _pass(found, seed)
            if difference(found, right):
                return True
    return False


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_in_the_kernel_is_caught(mistake: str) -> None:
    right, wrong = MISTAKES[mistake]
    assert TEXT.count(right) >= 1
    assert is_caught(TEXT.replace(right, wrong))


def test_the_kernel_as_it_is_shows_no_difference() -> None:
    assert not is_caught(TEXT)
