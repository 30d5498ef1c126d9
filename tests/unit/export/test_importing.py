"""What was exported becomes part of another project: it runs as it did, and nothing that was there is changed."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from app.core.automaton import START, Automaton, Basic, Nested
from app.core.check import check
from app.core.edits import add_automaton, add_rule, add_state, rename_automaton, set_note, set_world
from app.core.errors import EditError
from app.core.examples import Example
from app.core.library import Library, NodeType
from app.core.project import Arm, LevelTable, Project
from app.core.storage import load
from app.export.bundle import bundle_of_arm, bundle_of_behavior
from app.export.importing import Import, bring
from app.export.library_file import Exported, content, read, write
from app.learner.trainer import apply, is_stale, learn
from app.sim.scenarios.foraging import scenario as foraging
from tests.chase import scenario as chase

FORAGING = load(Path(__file__).parents[3] / "projects" / "foraging")
ARMS = [arm.name for arm in FORAGING.arms]
#: What one level of trained controllers needs.
TRAINED = bundle_of_arm(FORAGING, foraging, "one level")


def empty() -> Project:
    """A project in the same scenario that has nothing yet."""
    return Project(FORAGING.name, FORAGING.scenario, note=FORAGING.note)


def bytes_of(project: Project) -> bytes:
    return content(Exported(project))


def called(result: Import) -> dict[str, str]:
    """What the behaviors of the file are called in the project."""
    return {f"{b.type}/{b.name}": b.known_as for b in result.behaviors}


def automaton(project: Project, type_name: str, name: str) -> Automaton:
    found = project.library(type_name).by_name(name)
    assert found is not None
    return found


def with_another(name: str) -> Project:
    """The foraging project, where *name* of the agents is something else."""
    agents = FORAGING.libraries["agent"]
    old = agents.by_name(name)
    assert old is not None
    other, _ = add_state(FORAGING, "agent", old.id, Basic("Forward"), "more")
    assert other.library("agent").get(old.id).learned
    return replace(
        other,
        libraries={
            **other.libraries,
            "agent": Library({**agents.automata, old.id: replace(old, learned={}, learned_from="")}),
        },
    )


# ------------------------------------------------------------------------------------------- to the bit


@pytest.mark.parametrize("arm", ARMS)
def test_an_arm_that_was_imported_is_exported_as_the_same_bytes(arm: str, tmp_path: Path) -> None:
    bundle = bundle_of_arm(FORAGING, foraging, arm)
    write(Exported(bundle), tmp_path / "arm.json")
    result = bring(empty(), foraging, read(tmp_path / "arm.json").project, with_arm=True)
    assert result.arm == arm
    again = bundle_of_arm(result.project, foraging, arm)
    assert bytes_of(replace(again, types=bundle.types)) == bytes_of(bundle)
    assert not [p for p in check(result.project, foraging.vocabulary) if p.severity == "error"]


@pytest.mark.parametrize(
    ("type_name", "behavior"),
    [(kind, one) for kind, library in FORAGING.libraries.items() for one in library.automata],
)
def test_a_behavior_that_was_imported_is_exported_as_the_same_bytes(type_name: str, behavior: str) -> None:
    bundle = bundle_of_behavior(FORAGING, foraging, type_name, behavior)
    result = bring(empty(), foraging, bundle).project
    again = bundle_of_behavior(result, foraging, type_name, behavior)
    assert bytes_of(replace(again, types=(), arms=(), worlds={})) == bytes_of(
        replace(bundle, types=(), arms=(), worlds={})
    )


def test_an_arm_is_exported_as_the_same_bytes_out_of_a_project_with_another_world() -> None:
    elsewhere = set_world(empty(), "", {"boxes": 3, "sight": 20.0})
    result = bring(elsewhere, foraging, TRAINED, with_arm=True)
    again = bundle_of_arm(result.project, foraging, "one level")
    assert bytes_of(replace(again, types=TRAINED.types)) == bytes_of(TRAINED)


# ------------------------------------------------------------------------------------------- what is here


@pytest.mark.parametrize("arm", ARMS)
def test_what_the_project_has_already_is_used_and_nothing_is_added(arm: str) -> None:
    result = bring(FORAGING, foraging, bundle_of_arm(FORAGING, foraging, arm), with_arm=True)
    assert result.project is FORAGING
    assert not result.added
    assert (result.arm, result.arm_is_here) == (arm, True)


def test_a_behavior_is_the_same_whatever_its_id_and_the_states_that_nothing_enters() -> None:
    wander = bundle_of_behavior(FORAGING, foraging, "agent", "wander")
    here, new = add_automaton(empty(), "agent", "Other")
    here = bring(here, foraging, wander).project
    agents = here.libraries["agent"].automata
    moved = replace(agents["wander"], id="elsewhere")
    here = replace(here, libraries={"agent": Library({new: agents[new], "elsewhere": moved})})
    here, _ = add_state(here, "agent", "elsewhere", Basic("Forward"), "never entered")
    result = bring(here, foraging, bundle_of_behavior(FORAGING, foraging, "agent", "forage"))
    assert [b.id for b in result.behaviors if b.is_here] == ["elsewhere"]
    assert Nested("elsewhere") in [s.content for s in automaton(result.project, "agent", "Forage").states]


def test_nothing_that_was_there_is_changed() -> None:
    here = with_another("Wander")
    after = bring(here, foraging, TRAINED, with_arm=True).project
    for type_name, library in here.libraries.items():
        for key, there in library.automata.items():
            assert after.libraries[type_name].automata[key] is there
    assert after.arms[: len(here.arms)] == here.arms
    assert after.examples == here.examples


# ------------------------------------------------------------------------------------------- other behaviors of a name


def test_what_only_shares_a_name_comes_under_a_new_one_and_so_does_all_that_uses_it() -> None:
    result = bring(with_another("Wander"), foraging, TRAINED)
    assert called(result) == {
        "agent/Wander": "Wander 2",
        "agent/Goto": "Goto",
        "agent/ReturnWithBox": "ReturnWithBox",
        "agent/Forage": "Forage 2",
        "group/ControlForage": "ControlForage 2",
    }
    forage = automaton(result.project, "agent", "Forage 2")
    assert Nested(automaton(result.project, "agent", "Wander 2").id) in [s.content for s in forage.states]
    directed = {
        state.content.behavior
        for state in automaton(result.project, "group", "ControlForage 2").states
        if isinstance(state.content, Basic)
    }
    assert directed >= {"Forage 2", "Goto", "ReturnWithBox"}
    assert "Forage" not in directed


def test_the_arm_starts_with_the_behavior_that_came_and_runs_as_it_did() -> None:
    result = bring(with_another("Wander"), foraging, TRAINED, with_arm=True)
    arm = result.project.arm(result.arm)
    assert (result.arm, arm.top) == ("one level 2", "ControlForage 2")
    again = bundle_of_arm(result.project, foraging, result.arm)
    text = bytes_of(again).decode().replace("one level 2", "one level")
    for name in ("ControlForage", "Forage", "Wander"):
        text = text.replace(f"{name} 2", name)
    for name in ("control-forage", "forage", "wander"):
        text = text.replace(f'"{name}-2"', f'"{name}"')
    assert text == bytes_of(TRAINED).decode()


def test_a_name_is_new_for_all_types_of_the_file_so_that_controllers_can_direct_it() -> None:
    types = (NodeType("agent"), NodeType("robot"), NodeType("group", 1, ("agent", "robot")))
    source = Project("source", "foraging", types)
    for kind in ("agent", "robot"):
        source, move = add_automaton(source, kind, "Move")
        source, go = add_state(source, kind, move, Basic("Forward"))
        source, _ = add_rule(source, kind, move, START, go)
    source, lead = add_automaton(source, "group", "Lead")
    source, _ = add_state(source, "group", lead, Basic("Move"))
    here, _ = add_automaton(replace(source, libraries={}), "robot", "Move")
    result = bring(here, foraging, source)
    assert called(result) == {"agent/Move": "Move 2", "robot/Move": "Move 2", "group/Lead": "Lead"}
    assert automaton(result.project, "group", "Lead").states[1].content == Basic("Move 2")


def test_another_note_is_no_other_behavior() -> None:
    here = set_note(FORAGING, "agent", "wander", "mine")
    assert not bring(here, foraging, TRAINED).added


# ------------------------------------------------------------------------------------------- types and ids


def test_node_types_that_are_missing_are_made() -> None:
    result = bring(empty(), foraging, TRAINED)
    assert result.types == ("group",)
    assert result.project.types[-1] == NodeType("group", 1, ("agent",))


def test_an_id_that_is_taken_or_cannot_name_a_file_is_replaced() -> None:
    bundle = bundle_of_behavior(FORAGING, foraging, "agent", "wander")
    wander = bundle.libraries["agent"].automata["wander"]
    evil = replace(bundle, libraries={"agent": Library({"../../x": replace(wander, id="../../x")})})
    assert set(bring(empty(), foraging, evil).project.libraries["agent"].automata) == {"wander"}
    here, _ = add_automaton(empty(), "agent", "wander")
    assert set(bring(here, foraging, bundle).project.libraries["agent"].automata) == {"wander", "wander-2"}


# ------------------------------------------------------------------------------------------- examples


def test_with_its_examples_a_behavior_can_be_taught_further() -> None:
    bundle = bundle_of_behavior(FORAGING, foraging, "agent", "forage", examples=True)
    result = bring(empty(), foraging, bundle)
    assert not [b for b in result.added if b.lacks_examples]
    for key in ("forage", "wander", "goto"):
        taught = result.project.examples_of("agent", key)
        assert [e.values for e in taught] == [e.values for e in FORAGING.examples_of("agent", key)]
        assert not any(e.snapshot for e in taught)
        assert not is_stale(result.project, "agent", key)
    again = learn(result.project, foraging.vocabulary, [("agent", "goto")])
    assert apply(result.project, again) is result.project


def test_what_comes_without_its_examples_is_said() -> None:
    result = bring(empty(), foraging, bundle_of_behavior(FORAGING, foraging, "agent", "forage"))
    assert {b.name for b in result.added if b.lacks_examples} == {"Forage", "Wander", "Goto", "ReturnWithBox"}


def test_a_behavior_that_came_without_examples_gets_them_later() -> None:
    bare = bring(empty(), foraging, bundle_of_behavior(FORAGING, foraging, "agent", "forage")).project
    bundle = bundle_of_behavior(FORAGING, foraging, "agent", "forage", examples=True)
    result = bring(bare, foraging, bundle)
    assert not result.added
    assert all(brought.completed for brought in result.behaviors)
    assert result.words == "Import examples of Goto, examples of ReturnWithBox, examples of Wander and 1 more"
    assert result.project == bring(empty(), foraging, bundle).project
    assert bring(result.project, foraging, bundle).project is result.project


def test_the_same_behavior_with_other_examples_is_another_one() -> None:
    bundle = bundle_of_behavior(FORAGING, foraging, "agent", "wander", examples=True)
    assert not bring(FORAGING, foraging, bundle).added
    first, *rest = FORAGING.examples["agent"]["wander"]
    more: tuple[Example, ...] = (replace(first, weight=2.0), *rest)
    here = replace(
        FORAGING, examples={**FORAGING.examples, "agent": {**FORAGING.examples["agent"], "wander": more}}
    )
    assert [b.known_as for b in bring(here, foraging, bundle).added] == ["Wander 2"]


# ------------------------------------------------------------------------------------------- what is refused


def test_what_another_scenario_lacks_is_named() -> None:
    here = Project("chase", "chase")
    with pytest.raises(EditError) as refused:
        bring(here, chase, bundle_of_behavior(FORAGING, foraging, "agent", "return-with-box"))
    message = str(refused.value)
    assert "the file is of the scenario 'foraging'; this project's, 'chase', lacks what it needs" in message
    assert "GrabBox" in message
    assert "deposit" in message


def test_a_file_whose_type_stands_on_another_level_is_refused() -> None:
    here = replace(
        empty(), types=(NodeType("agent"), NodeType("pair", 1, ("agent",)), NodeType("group", 2, ("pair",)))
    )
    with pytest.raises(EditError, match="'group' is of level 1 in the file, and of level 2 in the project"):
        bring(here, foraging, TRAINED)


def test_an_arm_whose_world_is_not_possible_here_is_refused_and_can_be_left_out() -> None:
    source = replace(TRAINED, worlds={"": {"seasons": 4}})
    with pytest.raises(EditError, match=r"'one level' cannot come along: .*'seasons'.*; leave it out"):
        bring(empty(), foraging, source, with_arm=True)
    assert bring(empty(), foraging, source).added


def test_where_the_projects_own_worlds_are_not_possible_behaviors_can_come_all_the_same() -> None:
    with pytest.raises(EditError, match=r"'one level' cannot come along: .*'seasons'.*; leave it out"):
        bring(set_world(empty(), "", {"seasons": 4}), foraging, TRAINED, with_arm=True)
    assert bring(set_world(empty(), "", {"seasons": 4}), foraging, TRAINED).added


def test_an_arm_of_the_project_whose_world_is_not_possible_is_not_taken_for_that_of_the_file() -> None:
    here = bring(empty(), foraging, TRAINED, with_arm=True).project
    for arm in (replace(here.arms[0], parameters={"seasons": 4}), replace(here.arms[0], world="gone")):
        result = bring(replace(here, arms=(arm,)), foraging, TRAINED, with_arm=True)
        assert (result.arm, result.arm_is_here) == ("one level 2", False)


def test_an_arm_with_nodes_where_the_project_does_not_allow_them_is_refused() -> None:
    types = (NodeType("agent"), NodeType("robot"), NodeType("group", 1, ("robot",)))
    source = replace(
        TRAINED, libraries={}, arms=(Arm("one", LevelTable((2, 2), ("group", "agent")), "Forward"),)
    )
    with pytest.raises(EditError, match="allowed under 'group': robot; leave it out"):
        bring(replace(empty(), types=types), foraging, source, with_arm=True)


def broken(source: Project, **fields: Any) -> Project:
    """*source*, where Forage of the agents has other *fields*."""
    agents = source.libraries["agent"].automata
    forage = replace(agents["forage"], **fields)
    return replace(source, libraries={**source.libraries, "agent": Library({**agents, "forage": forage})})


def test_a_file_that_contradicts_itself_is_refused() -> None:
    forage = TRAINED.libraries["agent"].automata["forage"]
    circle = replace(forage.states[1], content=Nested("forage"))
    missing = replace(forage.states[1], content=Nested("nowhere"))
    for source, reason in (
        (broken(TRAINED, states=(forage.states[0], circle)), "recursion is not permitted"),
        (broken(TRAINED, states=(forage.states[0], missing)), "holds 'nowhere', which is not in it"),
        (broken(TRAINED, name="Goto"), "two of its behaviors are called 'Goto'"),
        (broken(TRAINED, name=" "), "has no name"),
        (replace(TRAINED, types=()), "no such node type"),
        (replace(TRAINED, types=(*TRAINED.types, NodeType("a/b"))), "cannot name a folder"),
    ):
        with pytest.raises(EditError, match=reason):
            bring(empty(), foraging, source)


def test_an_imported_behavior_can_be_renamed_like_any_other() -> None:
    project = bring(empty(), foraging, TRAINED, with_arm=True).project
    project = rename_automaton(project, "group", "control-forage", "Lead")
    assert project.arm("one level").top == "Lead"
