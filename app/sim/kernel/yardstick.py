# mypy: disable-error-code="no-untyped-def"
# numba finds out the types itself.
"""What the kernel is measured against: a loop written by hand for one behavior, the trained forager without controllers.

It knows nothing of automata: every state of every automaton that the forager passes through is a case below, every cut
that it learned stands here as a number, and what cannot happen to this behavior is left out. It is written to be fast, yet
passes tick after tick as the kernel does, and looks at every box in each: the same seed gives the same world, to the bit.
The behavior is the library in ``resources/bench/forager``, which was learned in ``projects/foraging``.
"""

from math import atan2, cos, pi, sin, sqrt
from typing import Any

import numpy as np
from numba import njit

from ...core.errors import ScenarioError
from ..engine import Start
from ..world import new_world
from .twins import draw, uniform, wrapped

# What an agent does. Those of Goto come twice, to a box and to the deposit, in the same order; a Goto that has not started,
# or that has just said that it is done, is in its first.
START, WANDER, WANDER_LEFT, WANDER_RIGHT = range(4)
TO_BOX, TO_BOX_FORWARD, TO_BOX_LEFT, TO_BOX_RIGHT, GRAB = range(4, 9)
HOME, HOME_FORWARD, HOME_LEFT, HOME_RIGHT, OVER = range(9, 14)
#: What Goto answers: done, or what to do.
ARRIVED, FORWARD, LEFT, RIGHT = range(4)

_TRIES = 32
_CLAIM, _PLACE_BOX_ANEW = 3, 2 * _TRIES
#: The automaton that wanders is the second from the outside, which is the number of its draws.
_WANDER_DRAW = 1
_NOBODY = -1


class Yardstick:
    """A world of foragers, each on its own, stepped by the loop.

    Attributes:
        columns: Those of the scenario that change, by name, as arrays.
    """

    def __init__(self, start: Start) -> None:
        """Begin a run.

        Raises:
            ScenarioError: The loop does not know such worlds.
        """
        _refuse_unknown(start)
        world = new_world(start.scenario, start.parameters, start.hierarchy, start.seed, start.world)
        self.columns: dict[str, Any] = {
            name: np.array(getattr(world, name), np.int64 if name in _WHOLE else np.float64)
            for name in _COLUMNS
        }
        p, agents, boxes = world.params, world.agents, world.end_box - world.first_box
        turn = p.turn_degrees * pi / 180.0
        self._numbers = (
            p.width,
            p.height,
            p.step,
            turn,
            p.sight * p.sight,
            p.grab_range * p.grab_range,
            p.deposit_range,
        )
        self._sizes = (agents, world.first_box, world.end_box, world.first_deposit)
        self._memory = (
            np.zeros(agents, np.int64),  # what it does
            np.zeros(agents, np.int64),  # since when
            np.zeros(agents, np.int64),  # whether its cosine and sine are those of its heading
            np.zeros(agents),
            np.zeros(agents),
            np.zeros(agents, np.int64),  # who grabs
            np.zeros(agents, np.int64),  # which box
            np.zeros(boxes, np.int64),  # boxes that need pullers
            np.zeros(boxes),
            np.zeros(boxes),
        )

    def step(self, ticks: int) -> None:
        """Pass ticks."""
        _step(ticks, self._sizes, self._numbers, *self.columns.values(), *self._memory)

    def measures(self) -> dict[str, float]:
        """The scenario's measures now."""
        return {name: float(self.columns[f"{name}_delivered"][0]) for name in ("boxes", "weight")}


_COLUMNS = ("clock", "x", "y", "heading", "held", "needed", "pulling", "boxes_delivered", "weight_delivered")
_WHOLE = {"clock", "held", "needed", "pulling"}


def _refuse_unknown(start: Start) -> None:
    unlike = {
        "top": (start.top, "Forage"),
        "physics": (start.physics, "kinematic"),
        "scenario": (start.scenario.name, "foraging"),
        "placement": (start.parameters.get("placement"), "anywhere"),
        "release": (start.parameters.get("release"), "anyone"),
        "controllers": (len(start.hierarchy.controllers()), 0),
    }
    for what, (found, known) in unlike.items():
        if found != known:
            raise ScenarioError(
                f"the loop written by hand knows only {known!r} as {what}, but found {found!r}"
            )


@njit(forceinline=True)
def _goto(doing, direction, distance):
    """What Goto does next."""
    if doing == FORWARD:
        if -0.30160016886123747 <= direction < 0.14559100666617653:
            return FORWARD if distance <= 999.9999999999999 else ARRIVED
        if distance <= 0.5404581538646889:
            return ARRIVED
        return RIGHT if direction >= 3.126297256079774 or direction < -0.0005493507056719692 else LEFT
    if doing == LEFT:
        return FORWARD if -0.048564382948972806 <= direction < 0.03173789131000016 else LEFT
    if doing == RIGHT:
        return RIGHT if direction >= 0.05288017296882109 or direction < -0.03833547986208474 else FORWARD
    if direction >= 2.9692336487046953 or direction < -0.5951263930891688:
        return RIGHT
    return LEFT if distance <= 516.7553863952307 else ARRIVED


@njit(forceinline=True)
def _clamped(value, high):
    if value < 0.0:
        return 0.0
    return min(value, high)


@njit(forceinline=True)
def _wandering(doing, passed, key, now, me):
    """What Wander does next while no box is in sight, *passed* ticks after it began to do what it does."""
    if doing == WANDER:
        if passed <= 179:
            return WANDER
        return WANDER_LEFT if draw(key, now, me, _WANDER_DRAW) < 0.5 else WANDER_RIGHT
    return WANDER if (doing == WANDER_LEFT and passed > 29) or passed > 39 else doing


@njit
def _list_open(sizes, x, y, needed, pulling, open_box, open_x, open_y):
    """Write down which boxes need pullers, and where they are; how many there are."""
    _, first_box, end_box, _ = sizes
    opened = 0
    for box in range(first_box, end_box):
        if pulling[box] < needed[box]:
            open_box[opened] = box
            open_x[opened] = x[box]
            open_y[opened] = y[box]
            opened += 1
    return opened


@njit
def _attach(clock, grabs, wanted, grabbing, held, needed, pulling):
    """Attach those who grab, the lowest draws where more grab than a box needs; how many boxes are full by that."""
    for k in range(grabbing):
        box = wanted[k]
        mine = uniform(clock, grabs[k], _CLAIM)
        before = pulling[box]
        for other in range(grabbing):
            if other != k and wanted[other] == box:
                theirs = uniform(clock, grabs[other], _CLAIM)
                before += theirs < mine or (theirs == mine and other < k)
        if before < needed[box]:
            held[grabs[k]] = box
    filled = 0
    for k in range(grabbing):
        if held[grabs[k]] == wanted[k]:
            pulling[wanted[k]] += 1
            filled += pulling[wanted[k]] == needed[wanted[k]]
    return filled


@njit
def _carry(box, sx, sy, agents, numbers, x, y, held):
    """Move a box one step along the sum of its pullers' headings, and all who hold it, as far as the walls allow."""
    width, height, step, _, _, _, _ = numbers
    length = sqrt(sx * sx + sy * sy)
    if length <= 1e-9:
        return
    bx = _clamped(x[box] + step * sx / length, width)
    by = _clamped(y[box] + step * sy / length, height)
    dx = bx - x[box]
    dy = by - y[box]
    x[box] = bx
    y[box] = by
    for me in range(agents):
        if held[me] == box:
            x[me] = _clamped(x[me] + dx, width)
            y[me] = _clamped(y[me] + dy, height)


@njit
def _deliver(box, sizes, numbers, clock, x, y, held, pulling):
    """Release all who hold a box that is at the deposit, and place it anew."""
    agents, _, _, deposit = sizes
    width, height, _, _, _, _, deposit_range = numbers
    home_x, home_y = x[deposit], y[deposit]
    pulling[box] = 0
    for me in range(agents):
        if held[me] == box:
            held[me] = _NOBODY
    for k in range(_TRIES):
        x[box] = uniform(clock, box, _PLACE_BOX_ANEW + 2 * k) * width
        y[box] = uniform(clock, box, _PLACE_BOX_ANEW + 2 * k + 1) * height
        dx = home_x - x[box]
        dy = home_y - y[box]
        if sqrt(dx * dx + dy * dy) > deposit_range:
            return
    x[box] = width if 2.0 * home_x < width else 0.0
    y[box] = height if 2.0 * home_y < height else 0.0


@njit(nogil=True, cache=True)
def _run(  # noqa: C901, PLR0912, PLR0915, PLR0917 - calls with arrays would cost what it is to measure
    ticks,
    sizes,
    numbers,
    clock,
    x,
    y,
    heading,
    held,
    needed,
    pulling,
    boxes,
    weight,
    doing,
    since,
    fresh,
    cosine,
    sine,
    grabs,
    wanted,
    open_box,
    open_x,
    open_y,
):
    agents, first_box, end_box, deposit = sizes
    width, height, step, turn, sight_squared, grab_squared, deposit_range = numbers
    home_x, home_y = x[deposit], y[deposit]
    key = clock[3]
    settled = False
    opened = 0
    full = 0
    first = clock[2]
    for now in range(first, first + ticks):
        clock[2] = now
        if not settled:
            settled = True
            opened = _list_open(sizes, x, y, needed, pulling, open_box, open_x, open_y)
            full = end_box - first_box - opened
        grabbing = 0
        for me in range(agents):
            state = doing[me]
            mx = x[me]
            my = y[me]
            act = ARRIVED
            begins = False  # whether ReturnWithBox is in its own Start
            if WANDER <= state <= WANDER_RIGHT:
                seen = 0
                for k in range(opened):
                    dx = open_x[k] - mx
                    dy = open_y[k] - my
                    seen |= dx * dx + dy * dy <= sight_squared
                if seen == 0:
                    following = _wandering(state, now - since[me], key, now, me)
                    if following != state:
                        since[me] = now
                        state = following
                    act = state
                else:
                    state = TO_BOX
                    begins = True
            elif state in (START, OVER):
                state = WANDER
                since[me] = now
                act = FORWARD
            if TO_BOX <= state <= TO_BOX_RIGHT:
                nearest = _NOBODY
                least = sight_squared
                for k in range(opened):
                    dx = open_x[k] - mx
                    dy = open_y[k] - my
                    square = dx * dx + dy * dy
                    if square < least or (nearest < 0 and square == least):
                        nearest = k
                        least = square
                distance = sqrt(least) if nearest >= 0 else 1000.0
                if begins and distance > 504.3895867177842:
                    state = OVER
                elif not begins and distance <= 4.497469768362239:
                    state = GRAB
                    if nearest >= 0 and least <= grab_squared:
                        grabs[grabbing] = me
                        wanted[grabbing] = open_box[nearest]
                        grabbing += 1
                elif not begins and distance > 999.9999999999999:
                    state = OVER
                else:
                    direction = 0.0
                    if nearest >= 0:
                        direction = wrapped(atan2(open_y[nearest] - my, open_x[nearest] - mx) - heading[me])
                    act = _goto(state - TO_BOX, direction, distance)
                    state = TO_BOX + act
            elif GRAB <= state <= HOME_RIGHT:
                if held[me] < 0:
                    state = OVER
                else:
                    if state == GRAB:
                        state = HOME
                    dx = home_x - mx
                    dy = home_y - my
                    direction = wrapped(atan2(dy, dx) - heading[me])
                    act = _goto(state - HOME, direction, sqrt(dx * dx + dy * dy))
                    state = HOME + act
            doing[me] = state
            if act == FORWARD:
                if held[me] < 0:
                    if fresh[me] == 0:
                        fresh[me] = 1
                        cosine[me] = cos(heading[me])
                        sine[me] = sin(heading[me])
                    x[me] = _clamped(mx + step * cosine[me], width)
                    y[me] = _clamped(my + step * sine[me], height)
            elif act != ARRIVED:
                heading[me] = wrapped(heading[me] + (turn if act == LEFT else -turn))
                fresh[me] = 0
        if grabbing > 0:
            settled = False
            full += _attach(clock, grabs, wanted, grabbing, held, needed, pulling)
        if full > 0:
            for box in range(first_box, end_box):
                if pulling[box] >= needed[box]:
                    sx = 0.0
                    sy = 0.0
                    for me in range(agents):
                        if held[me] == box and doing[me] == HOME_FORWARD:
                            if fresh[me] == 0:
                                fresh[me] = 1
                                cosine[me] = cos(heading[me])
                                sine[me] = sin(heading[me])
                            sx += cosine[me]
                            sy += sine[me]
                    _carry(box, sx, sy, agents, numbers, x, y, held)
                    dx = home_x - x[box]
                    dy = home_y - y[box]
                    if sqrt(dx * dx + dy * dy) <= deposit_range:
                        settled = False
                        boxes[0] += 1.0
                        weight[0] += needed[box]
                        _deliver(box, sizes, numbers, clock, x, y, held, pulling)
    clock[2] = first + ticks


#: numba's stubs do not see that it takes arguments.
_step: Any = _run
