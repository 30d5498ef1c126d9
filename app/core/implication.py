"""What tests say about each other: whether some that are met leave no choice about another."""

from collections.abc import Iterable

from .conditions import AtMost, Condition, Equals, Guard


def implied(condition: Condition, known: Iterable[Condition]) -> bool:
    """Whether *condition* surely comes out as it wants where all that is *known* does; arcs are told only if the same."""
    return any(_implies(fact, condition) for fact in known if fact.test.feature == condition.test.feature)


def _implies(fact: Condition, condition: Condition) -> bool:
    if fact == condition:
        return True
    match fact.test, condition.test:
        case AtMost(_, known), AtMost(_, asked) if fact.wanted == condition.wanted:
            return known <= asked if fact.wanted else known >= asked
        case Equals(_, known), Equals(_, asked):
            return fact.wanted and not condition.wanted and known != asked
    return False


def guard_implied(guard: Guard, known: Guard) -> bool:
    """Whether *guard* is surely met where all that is *known* holds."""
    return all(implied(condition, known) for condition in guard)
