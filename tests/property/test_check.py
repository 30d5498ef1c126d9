"""The check on random projects: silent on sound ones, and never at a loss on broken ones."""

from contextlib import suppress

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from app.core.check import check
from app.core.errors import EditError
from app.core.project import Project
from app.core.vocabulary import Vocabulary
from tests.strategies import projects_with_vocabulary, vocabularies

FEW = settings(max_examples=25, suppress_health_check=[HealthCheck.too_slow])


@FEW
@given(projects_with_vocabulary())
def test_a_sound_project_has_no_errors(drawn: tuple[Project, Vocabulary]) -> None:
    assert [str(problem) for problem in check(*drawn) if problem.severity == "error"] == []


@FEW
@given(projects_with_vocabulary(checked=False), st.none() | vocabularies())
def test_a_broken_project_is_listed_and_not_raised_at(
    drawn: tuple[Project, Vocabulary], other: Vocabulary | None
) -> None:
    """With the vocabulary of another scenario, hardly a name resolves."""
    project, vocabulary = drawn
    for problem in check(project, other or vocabulary):
        assert problem.file
        assert problem.message
        assert problem.fix or problem.mend is None


@FEW
@given(projects_with_vocabulary(checked=False))
def test_a_fix_removes_its_problem_or_is_refused(drawn: tuple[Project, Vocabulary]) -> None:
    project, vocabulary = drawn
    for problem in check(project, vocabulary)[:5]:
        if problem.mend is not None:
            with suppress(EditError):
                assert problem not in check(problem.mend(project), vocabulary)
