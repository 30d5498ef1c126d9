"""What is wrong with a project, found without running it and without giving up at the first problem.

`check` lists everything: errors, which keep what they concern from running, and warnings. `refuse` raises the errors
that concern a run. Files are named as `app.core.storage` names them; the form of files on disk is its business, the
parameters of a scenario are the scenario's.
"""

from collections.abc import Iterable, Iterator

from ..errors import UnderstudyError
from ..library import Types
from ..project import Project
from ..vocabulary import Vocabulary
from .arms import arm_problems, demonstration_problems
from .automata import automaton_problems, library_problems
from .examples import example_problems, stray_examples
from .features import feature_problems
from .node_types import sound_types, type_problems
from .problem import PROJECT_FILE, Problem, Severity, automaton_file, demonstration_file, examples_file, place
from .reach import Where, in_use
from .scope import Scope, Subject, scopes
from .transitions import transition_problems

__all__ = [
    "PROJECT_FILE",
    "Problem",
    "Severity",
    "automaton_file",
    "check",
    "demonstration_file",
    "examples_file",
    "in_use",
    "refuse",
]

#: As many as a user reads; the rest are counted.
MOST_TOLD = 20


def check(project: Project, vocabulary: Vocabulary) -> tuple[Problem, ...]:
    """Everything that is wrong with *project* in a scenario with this *vocabulary*, file by file."""
    types = _types(project, vocabulary)
    return tuple(_problems(project, types, scopes(types, vocabulary)))


def refuse(
    project: Project, vocabulary: Vocabulary, arm: str | None = None, taught: Iterable[Where] = ()
) -> None:
    """Raise one error that names all that keeps *project* from running.

    Args:
        arm: Only what concerns this arm counts; examples and demonstrations then do not, since a run needs neither.
        taught: Automata, by type and id, that run in the arm besides those that its roots start with.

    Raises:
        UnderstudyError: Of the kind that all the errors are of, if they are of one kind.
    """
    errors = [problem for problem in check(project, vocabulary) if problem.severity == "error"]
    if arm is not None:
        errors = list(_concerning(errors, project, _types(project, vocabulary), arm, taught))
    if not errors:
        return
    kinds = {problem.raises for problem in errors}
    kind = kinds.pop() if len(kinds) == 1 else UnderstudyError
    raise kind(_told(errors))


def _told(errors: list[Problem]) -> str:
    if len(errors) == 1:
        return str(errors[0])
    lines = [
        f"{len(errors)} problems keep the project from running:",
        *(f"  {e}" for e in errors[:MOST_TOLD]),
    ]
    if len(errors) > MOST_TOLD:
        lines.append(f"  and {len(errors) - MOST_TOLD} more; `understudy check` lists all")
    return "\n".join(lines)


def _types(project: Project, vocabulary: Vocabulary) -> Types:
    return Types(sound_types(project), project.libraries, vocabulary)


def _problems(project: Project, types: Types, scopes: dict[str, Scope]) -> Iterator[Problem]:
    yield from type_problems(project)
    yield from arm_problems(project, types)
    for type_name, scope in scopes.items():
        yield from library_problems(scope)
        for automaton in scope.library.automata.values():
            subject = Subject(scope, automaton)
            examples = project.examples_of(type_name, automaton.id)
            yield from automaton_problems(subject)
            yield from feature_problems(subject)
            yield from transition_problems(subject, examples)
            yield from example_problems(subject, examples)
    yield from stray_examples(project, scopes)
    yield from demonstration_problems(project, types)


def _concerning(
    errors: list[Problem], project: Project, types: Types, arm: str, taught: Iterable[Where]
) -> Iterator[Problem]:
    """The errors that keep one arm from running."""
    index = [other.name for other in project.arms].index(project.arm(arm).name)
    files = {automaton_file(*where) for where in in_use(types, project.arms[index], taught)}
    own = place("arms", index)
    for problem in errors:
        of_arms = problem.file == PROJECT_FILE and problem.where.startswith("arms")
        if (
            problem.file in files
            or (problem.file == PROJECT_FILE and not of_arms)
            or (of_arms and (problem.where + ".").startswith((own + ".", own + ",")))
        ):
            yield problem
