"""Checks of bindings: none open, none of a slot that is not there, none to what is not there or stands too high."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from ..automaton import Automaton
from ..edits import set_parameters
from ..edits.bindings import bindings_of
from ..errors import BindingError
from ..features import Bindings, Ground, Parameter
from ..project import Project
from .problem import Problem, allowed, place
from .scope import Subject

Mend = Callable[[Project], Project]


@dataclass(frozen=True, slots=True)
class Slots:
    """The slots of what a state holds or a feature senses.

    Attributes:
        where: The state or feature, in words.
        of: What has the slots: a behavior or feature by name.
        names: The slots there are.
        drop: Makes an edit that takes the binding of a slot away.
    """

    where: str
    of: str
    names: tuple[str, ...]
    drop: Callable[..., Mend] | None = None


def bound_parameters(automaton: Automaton) -> frozenset[str]:
    """The names of parameters that something in the automaton is bound to."""
    values = (*(s.content for s in automaton.states), *(use.source for use in automaton.features))
    bound = (binding for value in values for binding in bindings_of(value).values())
    return frozenset(binding.name for binding in bound if isinstance(binding, Parameter))


def binding_problems(
    subject: Subject, slots: Slots, bindings: Bindings, where: tuple[str | int, ...]
) -> Iterator[Problem]:
    """What is wrong with *bindings*, which stand at *where*."""
    for slot in slots.names:
        if slot not in bindings:
            yield _open(subject, slots, slot, where)
    for slot, binding in bindings.items():
        here = place(*where, "bindings", slot)
        if slot not in slots.names:
            yield _unknown_slot(subject, slots, slot, here)
        elif isinstance(binding, Ground):
            yield from _target_problems(subject, slots, slot, binding.target, here)
        elif binding.name not in subject.automaton.parameters:
            yield _unknown_parameter(subject, slots, slot, binding.name, here)


def _open(subject: Subject, slots: Slots, slot: str, where: tuple[str | int, ...]) -> Problem:
    targets = ", ".join(sorted(subject.scope.vocabulary.targets)) or "none"
    parameters = ", ".join(subject.automaton.parameters) or "none"
    return subject.error(
        place(*where, "bindings"),
        f"{slot!r} of {slots.of} is open in {slots.where} of {subject.automaton.name}: bind it to a target "
        f"({targets}) or to a parameter of {subject.automaton.name} ({parameters})",
        BindingError,
    )


def _unknown_slot(subject: Subject, slots: Slots, slot: str, here: str) -> Problem:
    return subject.error(
        here,
        f"{slot!r} is bound in {slots.where} of {subject.automaton.name}, but {slots.of} has no such slot; "
        f"{allowed(slot, slots.names, 'it has')}",
        BindingError,
        "drop the binding" if slots.drop else None,
        slots.drop(slot=slot) if slots.drop else None,
    )


def _target_problems(subject: Subject, slots: Slots, slot: str, target: str, here: str) -> Iterator[Problem]:
    scope = subject.scope
    if target in scope.vocabulary.targets:
        return
    who = f"{slot!r} of {slots.of} in {slots.where} of {subject.automaton.name} is bound to {target!r}"
    there = allowed(target, scope.vocabulary.targets, f"targets for {scope.type.name!r} are")
    if target in scope.scenario.targets:
        level = scope.scenario.targets[target].level
        reason = f"which only nodes of level {level} and up can bind, and {scope.type.name!r} has level {scope.type.level}"
    else:
        reason = "which is no target of the scenario"
    yield subject.error(here, f"{who}, {reason}; {there}", BindingError)


def _unknown_parameter(subject: Subject, slots: Slots, slot: str, name: str, here: str) -> Problem:
    automaton = subject.automaton
    return subject.error(
        here,
        f"{slot!r} of {slots.of} in {slots.where} is bound to parameter {name!r}, which {automaton.name} lacks; "
        f"{allowed(name, automaton.parameters, 'it has')}",
        BindingError,
        f"add the parameter {name!r} to {automaton.name}",
        subject.edit(set_parameters, (*automaton.parameters, name)),
    )
