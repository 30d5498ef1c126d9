"""Colors of behaviors are seen on every ground, and told apart."""

from pathlib import Path

import pytest
from PySide6.QtGui import QColor

from app.core import edits
from app.core.project import Project
from app.editor.behavior_colors import BehaviorColors, first_places, luminance, nth_color
from app.editor.documents import colors as kept_colors
from app.editor.documents.private import NAME
from app.editor.palette import DARK, LIGHT, OKABE_ITO, Palette

#: Generated colors that are looked at, and how much they stand out at least: all are as good as those of Okabe and Ito that are
#: dark on dark ground, and better than those that are light on light ground.
MANY, ENOUGH = 60, 2.0


@pytest.mark.parametrize("colors", [DARK, LIGHT], ids=["dark", "light"])
@pytest.mark.parametrize("ground", ["panel", "raised", "canvas"])
def test_generated_colors_stand_out_from_every_ground(colors: Palette, ground: str) -> None:
    behind = luminance(QColor(getattr(colors, ground)))
    for place in range(len(OKABE_ITO), MANY):
        dark, bright = sorted((behind, luminance(nth_color(place))))
        assert (bright + 0.05) / (dark + 0.05) >= ENOUGH, nth_color(place).name()


def test_the_first_behaviors_have_the_colors_that_the_color_blind_tell_apart() -> None:
    assert [nth_color(place).name().upper() for place in range(len(OKABE_ITO))] == list(OKABE_ITO)


def test_no_two_behaviors_have_the_same_color() -> None:
    names = {nth_color(place).name() for place in range(MANY)}
    assert len(names) == MANY


# ------------------------------------------------------------------------------------------------- who has which

AGENT = "agent"


def project(*names: str) -> Project:
    found = Project("Colors", "foraging")
    for name in names:
        found = edits.add_automaton(found, AGENT, name)[0]
    return found


def told(colors: BehaviorColors, opened: Project) -> dict[str, str]:
    return {a.name: colors.color(AGENT, a.id).name() for a in opened.library(AGENT).automata.values()}


def test_a_behavior_keeps_its_color_whatever_is_done_with_others() -> None:
    colors, before = BehaviorColors(), project("Goto", "Forage", "Wander")
    colors.begin(before, {})
    first = told(colors, before)
    renamed = edits.rename_automaton(before, AGENT, "goto", "Approach")
    fewer = edits.delete_automaton(renamed, AGENT, "forage")
    more = edits.add_automaton(fewer, AGENT, "Rest")[0]
    for now in (renamed, fewer, more):
        colors.use(now)
        assert told(colors, now)["Approach"] == first["Goto"]
        assert told(colors, now)["Wander"] == first["Wander"]
        assert len(set(told(colors, now).values())) == len(told(colors, now))
    last = told(colors, more)
    for now in (fewer, renamed, before):  # all is undone
        colors.use(now)
    assert told(colors, before) == first
    for now in (renamed, fewer, more):  # and done again
        colors.use(now)
    assert told(colors, more) == last


def test_the_colors_of_a_project_can_be_taken_up_again() -> None:
    colors, before = BehaviorColors(), project("Goto", "Wander")
    colors.begin(before, {})
    after = edits.add_automaton(before, AGENT, "Approach")[0]  # would be the first in the library
    colors.use(after)
    again = BehaviorColors()
    again.begin(after, colors.places)
    assert told(again, after) == told(colors, after)
    again.begin(project("Wander"), {})  # another project
    assert again.places == {"Wander": 0} == first_places(project("Wander"))


@pytest.mark.parametrize("kept", ['{"Goto": -1}', '{"Goto": true}', '{"A": 1, "B": 1}', "[1]", "{", "\xff"])
def test_what_is_no_sensible_choice_of_colors_is_passed_over(kept: str, tmp_path: Path) -> None:
    (tmp_path / kept_colors.COLORS).write_text(kept, encoding="latin-1")
    assert kept_colors.read(tmp_path) == {}


def test_colors_are_kept_only_where_they_are_not_those_of_any_opening(tmp_path: Path) -> None:
    there = project("Goto", "Wander")
    kept_colors.keep(tmp_path / NAME, there, {"Wander": 0, "Goto": 5})
    assert kept_colors.read(tmp_path / NAME) == {"Wander": 0, "Goto": 5}
    kept_colors.keep(tmp_path / NAME, there, first_places(there))
    assert not (tmp_path / NAME / kept_colors.COLORS).exists()
