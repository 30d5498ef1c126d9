"""What is remembered from one value of a project to the next never differs from what is worked out anew."""

from hypothesis import given
from hypothesis import strategies as st

from app.core.check import Checker, check
from app.core.edits import SENTENCES
from app.core.history import History
from app.core.project import Project
from app.editor.library.survey import Surveyor
from app.learner.freshness import Freshness
from app.learner.trainer import Key, is_stale
from tests import samples

from .test_edits import MANY, some_edit


def keys(project: Project) -> list[Key]:
    return [(name, key) for name, library in project.libraries.items() for key in library.automata]


@MANY
@given(st.data())
def test_after_any_edits_all_is_found_that_is_found_at_first_sight(data: st.DataObject) -> None:
    history, vocabulary = History(samples.project()), samples.vocabulary()
    checker, freshness, surveyor = Checker(), Freshness(), Surveyor()
    for edit in data.draw(st.lists(st.sampled_from(list(SENTENCES)), min_size=3, max_size=12)):
        some_edit(history, data.draw, edit)
        if history.can_undo and data.draw(st.booleans()):
            history.undo()
        project = history.project
        assert checker.check(project, vocabulary) == check(project, vocabulary)
        freshness.keep(keys(project))
        assert [freshness.is_stale(project, key) for key in keys(project)] == [
            is_stale(project, *key) for key in keys(project)
        ]
        types, arm = project.types_with(vocabulary), next(iter(project.arms), None)
        assert surveyor.survey(project, types, arm) == Surveyor().survey(project, types, arm)
