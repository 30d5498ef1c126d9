"""Those below a controller as the subject of a sentence: "someone", "not everyone in Group 3", "3 or more agents"."""

from dataclasses import dataclass
from math import floor, inf

from .features import Operation, Over
from .phrasing import Who, number

#: Who a statistic over all agents below, or over the direct subsidiaries, speaks of.
WORDS = {
    Over.AGENTS: {"any": "someone", "none": "nobody", "all": "everyone", "one": "agent", "many": "agents"},
    Over.SUBSIDIARIES: {
        "any": "a subsidiary",
        "none": "no subsidiary",
        "all": "every subsidiary",
        "one": "subsidiary",
        "many": "subsidiaries",
    },
}


@dataclass(frozen=True, slots=True)
class Crowd:
    """Those whom a statistic sums up.

    Attributes:
        group: The name of their controller; empty leaves it out.
    """

    over: Over
    group: str

    def some_or_all(self, operation: Operation, *, wanted: bool) -> Who:
        """Any of them or none; all of them or not all."""
        if operation is Operation.ANY:
            return self._placed(self._word("any" if wanted else "none"))
        return self._placed(("" if wanted else "not ") + self._word("all"))

    def so_many(self, low: float, high: float) -> Who:
        """Above *low* and up to *high* of them."""
        least = 0 if low == -inf else floor(low) + 1
        if high < 1.0:
            return self.some_or_all(Operation.ANY, wanted=False)
        if high < inf:
            return self._up_to(least, floor(high))
        if least <= 1:
            return self.some_or_all(Operation.ANY, wanted=True)
        return self._many(f"{least} or more", least)

    def _up_to(self, least: int, most: int) -> Who:
        if least <= 0:
            return self._many(f"at most {most}", most)
        return self.just(least) if least == most else self._many(f"{least} to {most}", most)

    def just(self, count: float) -> Who:
        """So many of them."""
        if count == 0.0:
            return self.some_or_all(Operation.ANY, wanted=False)
        return self._many(number(count), int(count))

    def share(self, low: float, high: float) -> Who:
        """Above the share *low* and up to *high* of them, both from 0 to 1."""
        words = [f"more than {number(100.0 * low)}%"] if low > -inf else []
        words += [f"at most {number(100.0 * high)}%"] if high < inf else []
        return self._placed(f"{' and '.join(words)} of the {self._word('many')}", many=True)

    def average(self) -> Who:
        """All of them, on average."""
        return Who(self._placed(f"the {self._word('many')}").words + " on average", many=True)

    def _many(self, words: str, count: int) -> Who:
        return self._placed(f"{words} {self._word('one' if count == 1 else 'many')}", many=count != 1)

    def _word(self, which: str) -> str:
        return WORDS[self.over][which]

    def _placed(self, words: str, *, many: bool = False) -> Who:
        if not self.group:
            return Who(words, many)
        return Who(f"{words} {'of' if self.over is Over.SUBSIDIARIES else 'in'} {self.group}", many)
