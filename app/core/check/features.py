"""Checks of what an automaton looks at, and of tests of it."""

from collections.abc import Iterator
from math import isfinite, pi

from ..conditions import AtMost, Equals, Guard, InArc, Test
from ..errors import BindingError, ScenarioError, UnderstudyError
from ..features import FeatureUse, FlagUp, Over, Sense, Source, Statistic, declaration
from ..vocabulary import Feature, FeatureKind
from .bindings import Slots, binding_problems
from .problem import Problem, allowed, place
from .scope import Subject

#: Angles and other circular values may end a rounding beyond the seam.
ROUNDING = 1e-9

_TESTS: dict[FeatureKind, tuple[type[Test], str]] = {
    FeatureKind.CONTINUOUS: (AtMost, "compared with a threshold"),
    FeatureKind.BOOLEAN: (Equals, "true or false"),
    FeatureKind.CATEGORICAL: (Equals, "compared with one of its categories"),
    FeatureKind.TOROIDAL: (InArc, "compared with an arc"),
}
_NAMES: dict[type[Test], str] = {
    AtMost: "compared with a threshold",
    Equals: "compared with a value",
    InArc: "compared with an arc",
}


def feature_problems(subject: Subject) -> Iterator[Problem]:
    """What is wrong with an automaton's features."""
    seen: dict[str, str] = {}
    for index, use in enumerate(subject.automaton.features):
        yield from _source_problems(subject, use, use.source, ("features", index, "source"))
        same = seen.setdefault(repr(use.source), use.id)
        if same != use.id:
            message = f"feature {use.shown} of {subject.automaton.name} is the same as feature {same!r}"
            yield subject.warning(place("features", index), message)


def _source_problems(
    subject: Subject, use: FeatureUse, source: Source, where: tuple[str | int, ...]
) -> Iterator[Problem]:
    match source:
        case Sense():
            yield from _sense_problems(subject, use, source, where)
        case FlagUp(flag):
            yield from _flag_problems(subject, flag, where)
        case Statistic():
            yield from _statistic_problems(subject, use, source, where)


def _sense_problems(
    subject: Subject, use: FeatureUse, sense: Sense, where: tuple[str | int, ...]
) -> Iterator[Problem]:
    feature = subject.scope.vocabulary.features.get(sense.feature)
    if feature is not None:
        yield from binding_problems(subject, _slots(use, feature), sense.bindings, where)
        return
    who = f"{subject.automaton.name} looks at {sense.feature!r}"
    there = allowed(sense.feature, subject.scope.vocabulary.features)
    here = place(*where, "feature")
    if sense.feature not in subject.scope.scenario.features:
        yield subject.error(here, f"{who}, which is no feature of the scenario; {there}", ScenarioError)
    elif subject.scope.type.level > 0:
        statistic = f"a statistic of it, such as 'any {sense.feature}'"
        message = f"{who}, which agents sense, but a controller has no body: use {statistic}, or one of its own; {there}"
        yield subject.error(here, message, BindingError)
    else:
        yield subject.error(here, f"{who}, which only controllers have; {there}", BindingError)


def _slots(use: FeatureUse, feature: Feature) -> Slots:
    return Slots(f"feature {use.shown}", feature.name, feature.parameters)


def _flag_problems(subject: Subject, flag: str, where: tuple[str | int, ...]) -> Iterator[Problem]:
    held = subject.automaton.nested()
    raised = frozenset().union(*(subject.scope.raised.get(automaton, ()) for automaton in held))
    if flag not in raised:
        message = f"the flag {flag!r} is never up in {subject.automaton.name}: no automaton that its states hold raises it"
        yield subject.warning(place(*where, "flag"), f"{message}; {allowed(flag, raised, 'raised are')}")


def _statistic_problems(
    subject: Subject, use: FeatureUse, statistic: Statistic, where: tuple[str | int, ...]
) -> Iterator[Problem]:
    scope = subject.scope
    if scope.type.level == 0:
        message = f"feature {use.shown} of {subject.automaton.name} is a statistic over subsidiaries, but agents have none"
        yield subject.error(place(*where), message, BindingError)
        return
    of, here = statistic.of, (*where, "of")
    if isinstance(of, FlagUp):
        shown = scope.shown[statistic.over]
        if of.flag not in shown:
            message = f"feature {use.shown} of {subject.automaton.name} never changes: no node that it is about shows that flag"
            yield subject.warning(place(*here, "flag"), f"{message}; {allowed(of.flag, shown, 'shown are')}")
        return
    feature = scope.statistics.features.get(of.feature)
    if feature is None:
        there = allowed(of.feature, scope.statistics.features)
        message = (
            f"{subject.automaton.name} sums up {of.feature!r}, which is no feature that agents sense; {there}"
        )
        yield subject.error(place(*here, "feature"), message, ScenarioError)
        return
    yield from binding_problems(subject, _slots(use, feature), of.bindings, here)
    if not scope.senses[statistic.over]:
        yield _nobody(subject, use, statistic, where)


def _nobody(subject: Subject, use: FeatureUse, statistic: Statistic, where: tuple[str | int, ...]) -> Problem:
    direct = statistic.over is Over.SUBSIDIARIES
    message = (
        f"feature {use.shown} of {subject.automaton.name} is about nobody: only agents sense, and none stand "
    )
    how = (
        "directly under a controller of this type; let it range over all agents below" if direct else "below"
    )
    return subject.warning(place(*where, "over"), message + how)


# ----------------------------------------------------------------------------------------------- tests


def declared(subject: Subject) -> dict[str, Feature | None]:
    """Feature id -> its kind, categories and period; None where the scenario lacks it, which is said elsewhere."""
    return {use.id: _declared(subject, use.source) for use in subject.automaton.features}


def _declared(subject: Subject, source: Source) -> Feature | None:
    scope = subject.scope
    inside = scope.statistics if isinstance(source, Statistic) else scope.scenario
    try:
        return declaration(source, inside)
    except UnderstudyError:
        return None


def guard_problems(guard: Guard, known: dict[str, Feature | None]) -> Iterator[tuple[int, str]]:
    """What is wrong with the tests of a guard: the number of each with a message."""
    for number, condition in enumerate(guard):
        for message in test_problems(condition.test, known):
            yield number, message


def test_problems(test: Test, known: dict[str, Feature | None]) -> Iterator[str]:
    """What is wrong with a test of one of the features *known* to an automaton."""
    if test.feature not in known:
        yield f"feature {test.feature!r}, which the automaton lacks; {allowed(test.feature, known)}"
        return
    feature = known[test.feature]
    if feature is None:
        return
    right, how = _TESTS[feature.kind]
    if not isinstance(test, right):
        yield f"{test.feature!r}, which is {feature.kind.value} and must be {how}, but is {_NAMES[type(test)]}"
    else:
        yield from _number_problems(test, feature)


def _number_problems(test: Test, feature: Feature) -> Iterator[str]:
    match test:
        case AtMost(_, threshold):
            if not isfinite(threshold):
                yield f"{test.feature!r}, whose threshold is {threshold}; it must be a finite number"
        case Equals(_, value):
            choices = feature.categories if feature.kind is FeatureKind.CATEGORICAL else ("false", "true")
            if value not in range(len(choices)):
                meaning = ", ".join(f"{i} ({choice})" for i, choice in enumerate(choices))
                yield f"{test.feature!r}, which is never {value:g}; allowed: {meaning}"
        case InArc(_, start, end):
            half = feature.period / 2
            for number in (start, end):
                if not -half - ROUNDING <= number <= half + ROUNDING:
                    yield f"{test.feature!r}, whose arc reaches {number:g}; allowed: {_range(half)}"


def _range(half: float) -> str:
    return "-pi to pi" if half == pi else f"{-half:g} to {half:g}"
