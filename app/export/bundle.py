"""What has to leave a project so that something runs without it: a smaller project, with all that is needed and no more.

States that cannot be entered are trimmed (paper, section 3.1), and so are behaviors that nobody uses. What runs from a
bundle equals what runs from the project, to the bit. With its examples, a behavior can be taught further elsewhere; it
then keeps all its states, since examples speak of them.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from ..core.automaton import Automaton, Basic, Refit, trimmed
from ..core.edits.place import find_automaton
from ..core.errors import EditError
from ..core.examples import Example, enabled
from ..core.library import Library, NodeType
from ..core.project import Arm, LevelTable, Project
from ..learner.trainer import fingerprint
from ..sim.scenario import Scenario

#: A type's name and an automaton's id.
Key = tuple[str, str]


def bundle_of_arm(project: Project, scenario: Scenario, arm_name: str, *, examples: bool = False) -> Project:
    """An arm with its controllers, agents and world, and every behavior that they may come to run.

    Args:
        examples: Whether all examples of these behaviors come along.

    Raises:
        EditError: There is no such arm.
        ParameterError: Its parameters are not possible.
    """
    arm = project.arm(arm_name)
    kinds = {node.type for node in arm.forest().walk()}
    roots = {root.type for root in arm.forest().roots}
    wanted = _Wanted(project, examples=examples)
    return _bundle(wanted, scenario, arm, kinds, wanted.of_name(roots, arm.top))


def bundle_of_behavior(
    project: Project, scenario: Scenario, type_name: str, automaton_id: str, *, examples: bool = False
) -> Project:
    """A behavior with all that it uses, and an arm whose roots run it, if it has no parameters that would be open.

    The arm is the project's first whose roots are of the behavior's type, or a single node with what has to be below it.
    """
    automaton = find_automaton(project, type_name, automaton_id)
    wanted = _Wanted(project, examples=examples)
    needed = wanted.of([(type_name, automaton_id)])
    if automaton.parameters:
        return _bundle(wanted, scenario, None, {type_name}, needed)
    arm = replace(_arm_for(project, type_name), name=automaton.name, top=automaton.name)
    kinds = {node.type for node in arm.forest().walk()}
    return _bundle(wanted, scenario, arm, kinds, needed)


def holds_arm(bundle: Project) -> bool:
    """Whether a whole arm was exported, and no behavior with an arm named after it that only lets it run."""
    return any(arm.name != arm.top for arm in bundle.arms)


def _arm_for(project: Project, type_name: str) -> Arm:
    for arm in project.arms:
        if {root.type for root in arm.forest().roots} == {type_name}:
            return arm
    types = [type_name]
    while below := _type(project, types[-1]).subsidiaries:
        types.append(below[0])
    return Arm("", LevelTable((1,) * len(types), tuple(types)), "")


def _type(project: Project, name: str) -> NodeType:
    return next(node_type for node_type in project.types if node_type.name == name)


class _Wanted:
    """What is to leave a project, and in which form; finds what else that needs.

    Others are needed where an automaton holds them, and where a controller directs them by name.

    Attributes:
        examples: Whether all examples come along.
    """

    def __init__(self, project: Project, *, examples: bool) -> None:
        self.project = project
        self.examples = examples
        self._found: dict[Key, None] = {}

    def form(self, key: Key) -> tuple[Automaton, tuple[Example, ...]]:
        """An automaton and its examples as they leave the project."""
        automaton = find_automaton(self.project, *key)
        if self.examples:
            return automaton, without_moments(self.project.examples_of(*key))
        automaton = trimmed(automaton)
        taught = refitted_from(self.project, key[0], automaton)
        return replace(automaton, learned_from=fingerprint(automaton, taught) if taught else ""), taught

    def of_name(self, types: Iterable[str], name: str) -> tuple[Key, ...]:
        """What nodes of these types need to do what is called *name*; basic behaviors need nothing."""
        return self.of([key for type_name in types for key in self._called(type_name, name)])

    def of(self, keys: Iterable[Key]) -> tuple[Key, ...]:
        """These automata, and all that they need."""
        waiting = list(keys)
        while waiting:
            key = waiting.pop()
            if key not in self._found:
                self._found[key] = None
                waiting += self._used(*key)
        return tuple(self._found)

    def _called(self, type_name: str, name: str) -> list[Key]:
        """The automata that *name* stands for in a type, or below it where the type only directs it."""
        automata = self.project.library(type_name).automata.values()
        own = [(type_name, automaton.id) for automaton in automata if automaton.name == name]
        return own or [
            key for child in _type(self.project, type_name).subsidiaries for key in self._called(child, name)
        ]

    def _used(self, type_name: str, automaton_id: str) -> list[Key]:
        automaton = find_automaton(self.project, type_name, automaton_id)
        automaton = automaton if self.examples else trimmed(automaton)
        used: list[Key] = [(type_name, nested) for nested in automaton.nested()]
        for state in automaton.states:
            if isinstance(state.content, Basic):
                below = _type(self.project, type_name).subsidiaries
                used += [key for child in below for key in self._called(child, state.content.behavior)]
        return used


def _bundle(
    wanted: _Wanted, scenario: Scenario, arm: Arm | None, kinds: set[str], needed: Iterable[Key]
) -> Project:
    project, keys = wanted.project, set(needed)
    kept = _with_subsidiaries(project, kinds | {type_name for type_name, _ in keys})
    automata: dict[str, dict[str, Automaton]] = {}
    examples: dict[str, dict[str, tuple[Example, ...]]] = {}
    for type_name, automaton_id in sorted(keys):
        automaton, taught = wanted.form((type_name, automaton_id))
        if taught:
            examples.setdefault(type_name, {})[automaton_id] = taught
        automata.setdefault(type_name, {})[automaton_id] = automaton
    worlds: Mapping[str, Mapping[str, float | int | str | bool]] = {}
    if arm is not None:
        worlds = {"": scenario.settle(project.parameters_of(arm))}
    return Project(
        project.name,
        project.scenario,
        types=tuple(node_type for node_type in project.types if node_type.name in kept),
        worlds=worlds,
        libraries={type_name: Library(by_id) for type_name, by_id in automata.items()},
        examples=examples,
        arms=() if arm is None else (replace(arm, world="", parameters={}),),
        note=project.note,
    )


def _with_subsidiaries(project: Project, kinds: set[str]) -> set[str]:
    """*kinds* and all types that may stand under them, since these decide what a controller can direct."""
    found: set[str] = set()
    waiting = list(kinds)
    while waiting:
        name = waiting.pop()
        if name not in found:
            if all(node_type.name != name for node_type in project.types):
                raise EditError(f"there is no node type {name!r}, which the arm names")
            found.add(name)
            waiting += _type(project, name).subsidiaries
    return found


def refitted_from(project: Project, type_name: str, automaton: Automaton) -> tuple[Example, ...]:
    """The examples that models without a table form are fitted from again; none for trees and rules."""
    refitted = {state for state, model in automaton.learned.items() if isinstance(model, Refit)}
    examples = enabled(project.examples_of(type_name, automaton.id))
    return without_moments(tuple(example for example in examples if example.source in refitted))


def without_moments(examples: tuple[Example, ...]) -> tuple[Example, ...]:
    """*examples* by their values alone: the moments that they were recorded in stay in their project."""
    return tuple(replace(example, snapshot="") for example in examples)
