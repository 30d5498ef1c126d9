"""What the canvas tells: legend, card under the mouse, badge, banners, stored moments, and choosing."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import Qt

from app.core.edits import rename_automaton
from app.editor.canvas.coloring import ColorBy
from app.editor.selection import BehaviorKey
from app.editor.theme import ThemeMode
from app.engine.commands import Pick, RunArm, Step, Teach, UndoPick, UseArm
from tests.gui.canvas.pilot import LEFT, Pilot


def show_example(pilot: Pilot) -> int:
    """Show the moment of one; returns its tick."""
    examples = pilot.studio.document.project.examples_of("agent", "forage")
    example = next(e for e in examples if e.snapshot and e.tick)
    moment = pilot.studio.document.project.moments[example.snapshot]
    pilot.studio.moment_wanted.emit(moment, example.node, f"The moment of example {example.id}")
    return example.tick


# ---------------------------------------------------------------------------------------------------- legend


def test_the_legend_counts_and_a_click_lights_those_up(pilot: Pilot) -> None:
    pilot.send(Step(200))
    legend = pilot.canvas.on_top.legend
    pilot.wait(lambda: "Wander" in legend.buttons)

    def counted() -> str:
        coloring = pilot.frame.coloring
        counts = {e.words: n for e, n in zip(coloring.entries, coloring.counts, strict=True)}
        return f"Wander {counts['Wander']}"

    pilot.wait(lambda: legend.buttons["Wander"].text() == counted())
    button, coloring = legend.buttons["Wander"], pilot.frame.coloring
    assert not pilot.is_lit()
    pilot.qtbot.mouseClick(button, LEFT)
    lit = pilot.frame.lit
    assert lit is not None
    assert {coloring.entries[k].words for k in lit} == {"Wander"}
    pilot.qtbot.mouseClick(button, LEFT)
    assert not pilot.is_lit()


def test_entries_of_the_legend_keep_their_places(pilot: Pilot) -> None:
    pilot.send(Step(200))
    legend = pilot.canvas.on_top.legend
    pilot.wait(lambda: "Wander" in legend.buttons)
    coloring = pilot.frame.coloring
    legend.tell(coloring, 2_000)
    before = list(legend.buttons)
    # As another program has them.
    other = replace(coloring, entries=coloring.entries[::-1], counts=coloring.counts[::-1])
    legend.tell(other, 2_000)
    assert list(legend.buttons) == before


def test_what_colors_tell_is_switched_in_the_legends_menu_and_remembered(pilot: Pilot) -> None:
    actions = pilot.canvas.on_top.legend.settings.menu().actions()
    basic = next(action for action in actions if "basic" in action.text())
    basic.trigger()
    assert pilot.frame.coloring.entries
    assert pilot.canvas.looking.color_by is ColorBy.BASIC
    assert basic.isChecked()
    assert pilot.studio.settings.flag("canvas_color_basic")


def test_every_way_to_color_can_be_painted_in_both_themes(pilot: Pilot) -> None:
    pilot.use_arm("two levels")
    for name in ("canvas.hulls", "canvas.links", "canvas.all_trails"):
        pilot.choose(name)
    pilot.send(Step(50))
    pilot.studio.selection.select_nodes(("agent-3", "group-1"))
    for mode in (ThemeMode.DARK, ThemeMode.LIGHT):
        pilot.studio.settings.theme = mode
        for by in ColorBy:
            pilot.choose(f"canvas.color_{by}")
            picture = pilot.picture()
            ground = pilot.studio.theme.color("canvas")
            assert picture.pixelColor(2, picture.height() // 2) in (ground, pilot.studio.theme.color("grid"))


# -------------------------------------------------------------------------------------------- under the mouse


def test_hovering_tells_who_it_is_what_it_runs_and_what_it_sees(pilot: Pilot) -> None:
    pilot.send(Step(100))
    agent = pilot.alone()
    pilot.hover(pilot.at(agent))
    node = pilot.snapshot.place.agents[agent]
    pilot.wait(lambda: node in pilot.snapshot.watched)
    pilot.wait(lambda: any("ticks" in line for line in pilot.canvas.card.lines))
    lines = pilot.canvas.card.lines
    assert pilot.canvas.card.isVisible()
    assert lines[0] == f"Agent {agent + 1}"
    assert lines[1].startswith("Forage →")
    assert any("box" in line for line in lines)
    pilot.hover(pilot.nowhere())
    assert not pilot.canvas.card.isVisible()
    pilot.wait(lambda: node not in pilot.snapshot.watched)


def test_hovering_over_a_box_tells_how_many_hold_it(pilot: Pilot) -> None:
    pilot.hover(pilot.at(50))
    assert pilot.canvas.card.lines[:2] == ("box 1", "0 of the 5 agents that it needs")


def test_a_box_that_needs_one_agent_says_so_in_the_singular(pilot: Pilot) -> None:
    pilot.send(UseArm("independent", {"world.pullers": 1}))
    pilot.wait(lambda: pilot.frame.scene.columns["needed"][50] == 1)
    pilot.hover(pilot.at(50))
    assert pilot.canvas.card.lines[:2] == ("box 1", "0 of the 1 agent that it needs")


# ---------------------------------------------------------------------------------------------- badge, banners


def test_the_badge_says_what_the_session_is_for(pilot: Pilot) -> None:
    assert not pilot.canvas.on_top.badge.isVisible()
    pilot.send(Teach("agent", "forage", ("agent-17",)))
    pilot.wait(pilot.canvas.on_top.badge.isVisible)
    assert pilot.canvas.on_top.badge.text() == "● Teaching agent 17"
    pilot.choose("teach.test")
    pilot.wait(lambda: pilot.canvas.on_top.badge.text() == "▷ Testing Forage")
    pilot.send(RunArm())
    pilot.wait(lambda: not pilot.canvas.on_top.badge.isVisible())


def test_the_badge_says_at_once_who_is_in_training_in_a_test(pilot: Pilot) -> None:
    badge = pilot.canvas.on_top.badge
    pilot.send(Teach("agent", "forage", ("agent-17",)))
    pilot.wait(badge.isVisible)
    pilot.choose("teach.test")
    pilot.wait(lambda: badge.text() == "▷ Testing Forage")
    pilot.send(Pick("agent-17", "wander"))
    pilot.wait(lambda: badge.text() == "▷ Testing Forage · agent 17 in training")
    pilot.send(UndoPick())
    pilot.wait(lambda: badge.text() == "▷ Testing Forage")


def test_a_long_name_leaves_room_for_the_world_and_for_other_names(pilot: Pilot) -> None:
    name = "A name that somebody gives who says everything"
    pilot.studio.document.do(rename_automaton, "agent", "forage", name)
    pilot.send(Teach("agent", "forage", ("agent-17",)))
    legend = pilot.canvas.on_top.legend
    pilot.wait(lambda: name in legend.buttons)
    assert "…" in legend.buttons[name].text()
    assert legend.buttons[name].toolTip().startswith(name)
    pilot.choose("teach.test")
    pilot.wait(lambda: pilot.canvas.on_top.badge.text() == "▷ Testing A name that somebody gives who…")


def test_a_failure_is_told_with_a_way_out(pilot: Pilot) -> None:
    failed = replace(pilot.snapshot, failure="after_tick of foraging: division by zero")
    pilot.studio.bridge.snapshot_changed.emit(failed)
    assert pilot.canvas.on_top.failure.isVisible()
    assert "after_tick" in pilot.canvas.on_top.failure.words.text()
    assert pilot.canvas.on_top.failure.button.text() == "Reset"
    place = pilot.snapshot.place
    pilot.qtbot.mouseClick(pilot.canvas.on_top.failure.button, LEFT)
    pilot.wait(lambda: pilot.snapshot.place is not place and not pilot.canvas.on_top.failure.isVisible())


def test_a_notice_of_the_engine_can_be_hidden(pilot: Pilot) -> None:
    told = replace(pilot.snapshot, notice="compiling the kernel; until then ticks are slower")
    pilot.studio.bridge.snapshot = told
    pilot.studio.bridge.snapshot_changed.emit(told)
    assert pilot.canvas.on_top.notice.isVisible()
    pilot.qtbot.mouseClick(pilot.canvas.on_top.notice.button, LEFT)
    pilot.studio.bridge.snapshot_changed.emit(told)
    assert not pilot.canvas.on_top.notice.isVisible()


# ----------------------------------------------------------------------------------------------------- moments


def test_a_stored_moment_is_shown_until_the_user_goes_back_to_now(pilot: Pilot) -> None:
    tick = show_example(pilot)
    assert not pilot.is_live()
    assert pilot.frame.scene.tick == tick
    assert pilot.canvas.on_top.moment.isVisible()
    assert pilot.canvas.on_top.moment.words.text().startswith("The moment of example")
    pilot.qtbot.mouseClick(pilot.canvas.on_top.moment.button, LEFT)
    assert pilot.is_live()
    assert pilot.frame.scene.tick == 0


def test_escape_goes_back_to_now_wherever_the_focus_is(pilot: Pilot) -> None:
    show_example(pilot)
    table = pilot.window.docks["library"].widget()
    table.setFocus()
    pilot.qtbot.keyClick(table, Qt.Key.Key_Escape)
    assert pilot.is_live()


def test_nothing_of_a_stored_moment_can_be_moved(pilot: Pilot) -> None:
    show_example(pilot)
    pilot.drag(pilot.at(50), pilot.nowhere())
    assert [text for text in pilot.said if "stored moment" in text]
    assert pilot.canvas.hand.dragged is None


def test_time_that_passes_ends_the_moment(pilot: Pilot) -> None:
    show_example(pilot)
    pilot.choose("run.play")
    pilot.wait(pilot.is_live)


# ---------------------------------------------------------------------------------------------------- choosing


def test_an_entity_is_chosen_by_a_click_and_others_are_refused_in_words(pilot: Pilot) -> None:
    chosen: list[int] = []
    pilot.canvas.entity_chosen.connect(chosen.append)
    pilot.canvas.choose_entity("click a box", lambda entity: entity >= 50)
    assert pilot.canvas.on_top.prompt.isVisible()
    pilot.click(pilot.at(pilot.alone()))
    assert chosen == []
    assert pilot.said[-1] == "this cannot be chosen; click a box"
    pilot.click(pilot.at(52))
    assert chosen == [52]
    assert not pilot.canvas.on_top.prompt.isVisible()
    assert pilot.selected == []


def test_escape_chooses_nothing(pilot: Pilot) -> None:
    with pilot.qtbot.waitSignal(pilot.canvas.choosing_ended):
        pilot.canvas.choose_entity("click a box", lambda entity: entity >= 50)
        pilot.key(Qt.Key.Key_Escape)
    assert pilot.canvas.hand.choice is None
    pilot.click(pilot.at(pilot.alone()))
    assert len(pilot.selected) == 1


def test_a_click_on_nothing_while_something_is_to_be_chosen_is_answered(pilot: Pilot) -> None:
    pilot.studio.selection.select_behavior(BehaviorKey("agent", "goto"))
    said: list[str] = []
    pilot.studio.said.connect(lambda message: said.append(message.text))
    pilot.choose("teach.teach")
    pilot.wait(lambda: pilot.studio.teaching.choosing.is_busy)
    pilot.click(pilot.nowhere())
    assert said == ["nothing is at that place; click what X of Goto is to be, or press Enter for a list"]
    assert pilot.studio.teaching.choosing.is_busy


def test_an_agent_upon_a_target_is_not_chosen_in_its_place(pilot: Pilot) -> None:
    pilot.studio.selection.select_behavior(BehaviorKey("agent", "goto"))
    (deposit,) = pilot.frame.scene.place.spans["deposit"]
    agent, there = pilot.alone(), pilot.at(deposit)
    pilot.drag(pilot.at(agent), there)
    pilot.wait(lambda: pilot.canvas.hand.dragged is None and pilot.at(agent) == there)
    pilot.choose("teach.teach")
    pilot.wait(lambda: deposit in pilot.canvas.hand.sought())
    pilot.hover(there)
    assert pilot.canvas.hovering.entity == deposit
    pilot.click(there)
    pilot.wait(lambda: pilot.studio.teaching.lesson is not None)
    assert pilot.studio.teaching.arguments == {"X": "deposit"}
