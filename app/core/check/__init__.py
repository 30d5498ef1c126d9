"""What is wrong with a project, found without running it and without giving up at the first problem.

`check` lists everything: errors, which keep what they concern from running, and warnings. A `Checker` does so for one
value of a project after another. `refuse` raises the errors that concern a run. Files are named as `app.core.storage`
names them; the form of files on disk is its business, the parameters of a scenario are the scenario's.
"""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from ..errors import UnderstudyError
from ..library import Types
from ..project import Arm, Project
from ..vocabulary import Vocabulary
from .arms import top_problems
from .checker import Checker, types_of
from .problem import PROJECT_FILE, Problem, Severity, automaton_file, demonstration_file, examples_file, place
from .reach import Where, in_use

__all__ = [
    "PROJECT_FILE",
    "Checker",
    "Problem",
    "Severity",
    "automaton_file",
    "check",
    "demonstration_file",
    "examples_file",
    "in_use",
    "refuse",
    "refuse_top",
]

#: As many as a user reads; the rest are counted.
MOST_TOLD = 20


def check(project: Project, vocabulary: Vocabulary) -> tuple[Problem, ...]:
    """Everything that is wrong with *project* in a scenario with this *vocabulary*, file by file."""
    return Checker().check(project, vocabulary)


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
        errors = list(_concerning(errors, project, types_of(project, vocabulary), arm, taught))
    if not errors:
        return
    kinds = {problem.raises for problem in errors}
    kind = kinds.pop() if len(kinds) == 1 else UnderstudyError
    raise kind(_told(errors))


def refuse_top(project: Project, vocabulary: Vocabulary, arm: Arm, where: str) -> None:
    """Raise an error if the roots of *arm* cannot start with its behavior, which was named at *where*.

    Raises:
        UnderstudyError: They cannot.
    """
    for problem in top_problems(0, arm, types_of(project, vocabulary)):
        raise problem.raises(str(replace(problem, file="", where=where)))


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
