"""What leaves a project runs as it did there, to the bit, and takes along no more than it needs."""

from dataclasses import replace
from pathlib import Path
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.core.automaton import Basic
from app.core.edits import add_automaton, add_state
from app.core.errors import EditError
from app.core.library import Library
from app.core.machine_state import freeze
from app.core.project import Arm, Project
from app.core.storage import FilesError, load
from app.engine.models import Models
from app.engine.runs import start_engine, treatment
from app.engine.scenarios import open_scenario
from app.export.bundle import bundle_of_arm, bundle_of_behavior
from app.export.importing import bring
from app.export.library_file import Exported, content, read, write
from app.learner.trainer import apply, is_stale, learn
from app.sim.scenario import Scenario
from app.sim.scenarios.foraging import scenario as foraging
from tests.playground import scenario as playground
from tests.random_automata import random_forest
from tests.random_runs import TYPES, playing_types

FORAGING = load(Path(__file__).parents[3] / "projects" / "foraging")
REFERENCE = {"engine": "reference"}


def states(project: Project, scenario: Scenario, arm: str, ticks: int) -> tuple[object, object]:
    """The world and what all nodes do, after some ticks."""
    models = Models(scenario.vocabulary)
    models.use(project)
    of = treatment(project, scenario, project.arm(arm), REFERENCE, classifiers=models.classifiers)
    engine = start_engine(of, 5)
    engine.step(ticks)
    return engine.frozen_world(), freeze(engine.machine)


def written(project: Project, folder: Path) -> Project:
    """The same from the file."""
    path = folder / "export.json"
    write(Exported(project), path)
    return read(path).project


@pytest.mark.parametrize("arm", [arm.name for arm in FORAGING.arms])
def test_an_arm_runs_from_the_file_as_from_the_project(arm: str, tmp_path: Path) -> None:
    bundle = written(bundle_of_arm(FORAGING, foraging, arm), tmp_path)
    assert states(bundle, foraging, arm, 150) == states(FORAGING, foraging, arm, 150)


@pytest.mark.parametrize("arm", ["independent", "two levels"])
def test_with_its_examples_an_arm_runs_the_same_and_is_not_stale(arm: str, tmp_path: Path) -> None:
    bundle = written(bundle_of_arm(FORAGING, foraging, arm, examples=True), tmp_path)
    assert states(bundle, foraging, arm, 100) == states(FORAGING, foraging, arm, 100)
    keys = [(kind, one) for kind, library in bundle.libraries.items() for one in library.automata]
    assert all(bundle.examples_of(*key) for key in keys)
    assert not any(is_stale(bundle, *key) for key in keys)


def random_project(seed: int) -> Project | None:
    """Random behaviors and a random hierarchy whose roots run one of them; None where that cannot run by itself."""
    random = Random(seed)
    types = playing_types(random)
    forest = random_forest(random, TYPES)
    names = sorted(set.intersection(*(set(types.repertoire(root.type)) for root in forest.roots)))
    top = names[seed % len(names)]
    if any(types.repertoire(root.type)[top].parameters for root in forest.roots):
        return None
    libraries = {node_type.name: types.library(node_type.name) for node_type in TYPES}
    return Project("random", "playground", TYPES, libraries=libraries, arms=(Arm("arm", forest, top),))


@given(st.integers(0, 2**32))
def test_random_hierarchies_of_random_behaviors_run_the_same_from_their_bundle_and_imported(
    seed: int,
) -> None:
    project = random_project(seed)
    if project is None:
        return
    bundle = bundle_of_arm(project, playground, "arm")
    there = states(project, playground, "arm", 25)
    assert states(bundle, playground, "arm", 25) == there
    imported = bring(Project("other", "playground", ()), playground, bundle, with_arm=True)
    assert states(imported.project, playground, "arm", 25) == there
    assert bring(imported.project, playground, bundle, with_arm=True).project is imported.project


@given(st.integers(0, 2**32), st.integers(0, 2**32))
def test_what_was_imported_does_what_it_did_whatever_has_the_same_names(seed: int, other: int) -> None:
    project, into = random_project(seed), random_project(other)
    if project is None or into is None:
        return
    bundle = bundle_of_arm(project, playground, "arm")
    imported = bring(into, playground, bundle, with_arm=True)
    world, _ = states(project, playground, "arm", 25)
    assert states(imported.project, playground, imported.arm, 25)[0] == world


def test_only_what_is_used_is_taken_along() -> None:
    bundle = bundle_of_arm(FORAGING, foraging, "independent")
    assert set(bundle.libraries) == {"agent"}
    assert set(bundle.libraries["agent"].automata) == {"forage", "wander", "return-with-box", "goto"}
    assert not bundle.examples
    assert not bundle.moments
    assert [t.name for t in bundle.types] == ["agent"]


def test_a_controller_takes_along_what_it_directs() -> None:
    bundle = bundle_of_arm(FORAGING, foraging, "two levels")
    assert set(bundle.libraries) == {"agent", "group", "squad"}
    assert "gather-at" in bundle.libraries["agent"].automata


def test_states_that_cannot_be_entered_stay_behind() -> None:
    project, _ = add_state(FORAGING, "agent", "forage", Basic("Forward"), "never")
    bundle = bundle_of_arm(project, foraging, "independent")
    assert [s.name for s in bundle.libraries["agent"].automata["forage"].states].count("never") == 0


def test_a_behavior_without_parameters_brings_an_arm_that_runs_it() -> None:
    bundle = bundle_of_behavior(FORAGING, foraging, "agent", "wander")
    assert [(arm.name, arm.top) for arm in bundle.arms] == [("Wander", "Wander")]
    assert len(bundle.arms[0].forest().agents()) == 50


def test_a_behavior_with_parameters_brings_none() -> None:
    bundle = bundle_of_behavior(FORAGING, foraging, "agent", "goto")
    assert bundle.arms == ()
    assert set(bundle.libraries["agent"].automata) == {"goto"}


def test_a_type_in_no_arm_gets_one_node_with_what_has_to_be_below_it() -> None:
    project = replace(FORAGING, arms=())
    bundle = bundle_of_behavior(project, foraging, "group", "control-forage")
    assert [node.type for node in bundle.arms[0].forest().walk()] == ["group", "agent"]


def test_models_without_a_table_form_take_their_examples_along(tmp_path: Path) -> None:
    library = FORAGING.libraries["agent"]
    wander = library.automata["wander"]
    refitted = replace(wander, settings=replace(wander.settings, classifier="bayes"))
    libraries = {**FORAGING.libraries, "agent": Library({**library.automata, "wander": refitted})}
    project = replace(FORAGING, libraries=libraries)
    project = apply(project, learn(project, foraging.vocabulary, [("agent", "wander")]))
    bundle = written(bundle_of_arm(project, foraging, "independent"), tmp_path)
    assert bundle.examples_of("agent", "wander")
    assert states(bundle, foraging, "independent", 60) == states(project, foraging, "independent", 60)


def test_an_arm_that_does_not_exist_is_refused_by_name() -> None:
    with pytest.raises(EditError, match="there is no arm 'nobody'"):
        bundle_of_arm(FORAGING, foraging, "nobody")


def test_an_automaton_that_is_new_and_empty_can_leave(tmp_path: Path) -> None:
    project, new = add_automaton(FORAGING, "agent", "Empty")
    bundle = written(bundle_of_behavior(project, foraging, "agent", new), tmp_path)
    assert bundle.libraries["agent"].automata[new].name == "Empty"


# ------------------------------------------------------------------------------------------------ bad files


def bad(tmp_path: Path, text: str) -> str:
    path = tmp_path / "bad.json"
    path.write_text(text)
    with pytest.raises(FilesError) as error:
        read(path)
    return str(error.value)


def test_a_file_that_is_no_export_is_told_apart(tmp_path: Path) -> None:
    assert "this is no export of Understudy" in bad(tmp_path, '{"name": "x"}')
    assert "this is no export of Understudy" in bad(tmp_path, "[]")


def test_a_damaged_file_names_the_place(tmp_path: Path) -> None:
    assert "line 1" in bad(tmp_path, '{"format": ')


def test_a_file_of_a_newer_version_says_so(tmp_path: Path) -> None:
    assert "newer Understudy" in bad(tmp_path, '{"format": "understudy export", "schema_version": 999}')


def test_an_unknown_key_and_a_missing_one_are_named(tmp_path: Path) -> None:
    text = content(Exported(bundle_of_arm(FORAGING, foraging, "independent"))).decode()
    told = bad(tmp_path, text.replace('"libraries"', '"librarys"', 1))
    assert "librarys" in told
    assert "did you mean 'libraries'?" in told


def test_a_file_is_written_whole_or_not_at_all(tmp_path: Path) -> None:
    with pytest.raises(FilesError, match="there is no folder"):
        write(Exported(FORAGING), tmp_path / "nowhere" / "x.json")
    assert list(tmp_path.iterdir()) == []


def test_exporting_twice_gives_the_same_bytes() -> None:
    first, second = (content(Exported(bundle_of_arm(FORAGING, foraging, "two levels"))) for _ in range(2))
    assert first == second


def test_the_scenario_of_a_bundle_is_the_projects() -> None:
    assert open_scenario(bundle_of_arm(FORAGING, foraging, "independent")) is foraging
