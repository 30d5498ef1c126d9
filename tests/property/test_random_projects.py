"""Random projects are what `tests.strategies` says they are, and the check copes with all of them."""

from hypothesis import HealthCheck, given, settings

from app.core.check import check
from app.core.project import Project
from app.core.vocabulary import Vocabulary
from tests.strategies import projects_with_vocabulary

few = settings(max_examples=30, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large])


@few
@given(projects_with_vocabulary())
def test_a_checked_project_has_no_errors(drawn: tuple[Project, Vocabulary]) -> None:
    assert [str(problem) for problem in check(*drawn) if problem.severity == "error"] == []


@few
@given(projects_with_vocabulary(checked=False))
def test_any_project_can_be_checked(drawn: tuple[Project, Vocabulary]) -> None:
    for problem in check(*drawn):
        assert problem.file
        assert problem.message
