"""All that is measured, with its goals."""

from functools import partial

from . import commands, lessons, memory, rates
from .figures import Better, Measure

_HIGHER, _LOWER = Better.HIGHER, Better.LOWER
_RATE, _TIMES = "agent-ticks/s", "times"

MEASURES: tuple[Measure, ...] = (
    Measure("independent agents", partial(rates.kernel_rate, arm="independent"), _RATE, 10e6, _HIGHER),
    Measure("one level of controllers", partial(rates.kernel_rate, arm="one level"), _RATE, 8e6, _HIGHER),
    Measure("two levels of controllers", partial(rates.kernel_rate, arm="two levels"), _RATE, 8e6, _HIGHER),
    Measure("two threads against one", rates.threads_ratio, _TIMES, 1.9, _HIGHER),
    Measure("time against a loop written by hand", rates.yardstick_ratio, _TIMES, 3.0, _LOWER),
    Measure("time with 1,000 unused behaviors", rates.unused_ratio, _TIMES, 1.05, _LOWER),
    Measure("reference engine", rates.reference_rate, "ticks/s", 60.0, _HIGHER),
    Measure("rigid bodies", rates.rigid_rate, "ticks/s", 5_000.0, _HIGHER),
    Measure(
        "learning from 1,000 examples",
        partial(lessons.milliseconds_to_learn, examples=1_000, rounds=10),
        "ms",
        100.0,
        _LOWER,
    ),
    Measure("understudy --help", commands.seconds_of_help, "s", 0.3, _LOWER),
    Measure("understudy check", commands.seconds_of_check, "s", 1.0, _LOWER),
    Measure("understudy run, one tick", commands.seconds_to_run, "s", 2.0, _LOWER),
    Measure("the same, compiling first", commands.seconds_to_compile, "s", 60.0, _LOWER, long=True),
    Measure(
        "learning from 100,000 examples",
        partial(lessons.seconds_to_learn, examples=100_000, rounds=1),
        "s",
        10.0,
        _LOWER,
        long=True,
    ),
    # The allocator's own needs vary by half of this.
    Measure("growth of memory in 800 runs", memory.growth_with_runs, "MiB", 1.0, _LOWER, long=True),
    Measure("the paper's evaluation", commands.seconds_of_evaluation, "s", 240.0, _LOWER, long=True),
)
