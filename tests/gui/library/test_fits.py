"""How well behaviors fit is worked out beside the window, for those in which something that counts has changed."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from app.core.automaton import Settings
from app.core.edits import disable_examples, rename_automaton, set_settings
from app.core.project import Project
from app.core.vocabulary import Vocabulary
from app.editor.library import fits as module
from app.editor.library.fits import Fit, Fits, fit_of
from app.learner.freshness import Freshness
from app.learner.trainer import Key, apply, learn
from tests.gui.conftest import PATIENCE
from tests.samples import AGENT, project, vocabulary

KEY = (AGENT, "goto")


@pytest.fixture
def worked_out(monkeypatch: pytest.MonkeyPatch) -> list[Key]:
    """The automata whose fits were worked out, in this order."""
    found: list[Key] = []

    def noted(project: Project, scenario: Vocabulary, key: Key, freshness: Freshness) -> Fit:
        found.append(key)
        return fit_of(project, scenario, key, freshness)

    monkeypatch.setattr(module, "fit_of", noted)
    return found


@pytest.fixture
def fits(worked_out: list[Key]) -> Iterator[Fits]:
    fits = Fits(Freshness())
    yield fits
    fits.close()


def taught() -> Project:
    return apply(project(), learn(project(), vocabulary(), [KEY]))


def keys(project: Project) -> list[Key]:
    return [(name, key) for name, library in project.libraries.items() for key in library.automata]


def known(fits: Fits, key: Key = KEY) -> Fit:
    fit = fits.of(key)
    assert fit is not None
    return fit


def test_a_name_changes_no_fit_and_a_disabled_example_that_of_its_behavior(
    fits: Fits, worked_out: list[Key], qtbot: QtBot
) -> None:
    first = taught()
    fits.follow(first, vocabulary())
    qtbot.waitUntil(lambda: all(fits.of(key) for key in keys(first)), timeout=PATIENCE)
    worked_out.clear()
    renamed = rename_automaton(first, *KEY, "Approach")
    fits.follow(renamed, vocabulary())
    with qtbot.waitSignal(fits.changed, timeout=PATIENCE) as changed:
        fits.follow(disable_examples(renamed, *KEY, ["1"]), vocabulary())
    qtbot.waitUntil(lambda: not fits._worker.busy)  # whatever else it works out is there by then
    assert changed.args == [(KEY,)]
    assert worked_out == [KEY]
    assert known(fits).stale


def test_what_was_undone_meanwhile_is_not_shown(fits: Fits, worked_out: list[Key], qtbot: QtBot) -> None:
    first = taught()
    fits.follow(first, vocabulary())
    qtbot.waitUntil(lambda: all(fits.of(key) for key in keys(first)), timeout=PATIENCE)
    assert not known(fits).stale
    worked_out.clear()
    fits.follow(disable_examples(first, *KEY, ["1"]), vocabulary())
    qtbot.waitUntil(lambda: KEY in worked_out, timeout=PATIENCE)
    fits.follow(first, vocabulary())  # the answer may have been taken before
    other = set_settings(first, AGENT, "wander", Settings(pruning_confidence=0.1))
    before = known(fits, (AGENT, "wander"))
    fits.follow(other, vocabulary())
    qtbot.waitUntil(lambda: known(fits, (AGENT, "wander")) != before, timeout=PATIENCE)  # it has been by then
    qtbot.waitUntil(lambda: not known(fits).stale, timeout=PATIENCE)


def test_of_a_behavior_as_it_is_now_nothing_is_said_that_held_before(fits: Fits, qtbot: QtBot) -> None:
    first = taught()
    fits.follow(first, vocabulary())
    qtbot.waitUntil(lambda: fits.now(KEY, first) is not None, timeout=PATIENCE)
    assert fits.now(KEY, rename_automaton(first, *KEY, "Approach")) == known(fits)
    assert fits.now(KEY, disable_examples(first, *KEY, ["1"])) is None


def test_nothing_is_found_out_any_more_once_the_window_is_gone(fits: Fits) -> None:
    fits.close()
    fits.follow(taught(), vocabulary())
    assert not fits._soon.isActive()
