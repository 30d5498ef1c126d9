"""The project that the first lesson takes place in: made from the shipped one, and kept nowhere."""

from dataclasses import replace
from pathlib import Path

from ...core.automaton import Automaton
from ...core.edits.place import with_automaton, with_examples
from ...core.examples import Example, Moment
from ...core.library import Library, NodeType
from ...core.project import Arm, LevelTable, Project
from ...core.storage import load
from ...engine.scenarios import open_scenario
from ...engine.shipped import shipped_folder
from ...sim.scenario import Scenario

NAME = "First lesson"
TYPE, WANDER, FORAGE = "agent", "wander", "forage"
#: What Forage needs besides Wander, taught already.
GIVEN = ("goto", "return-with-box")
AGENTS, BOXES = 50, 40
FOLDER = "projects/foraging"


def scratch_project(*, wander_is_taught: bool) -> tuple[Project, Scenario]:
    """Agents, boxes that one agent can pull, and behaviors that are only named yet.

    Args:
        wander_is_taught: Whether the first half of the lesson is done, so that its result has to be there.
    """
    shipped = load(shipped_folder(Path(FOLDER)))
    automata = dict(shipped.library(TYPE).automata)
    kept = (*GIVEN, *([WANDER] if wander_is_taught else []))
    library = {key: automata[key] for key in (WANDER, FORAGE, *GIVEN)}
    library = {key: a if key in kept else untaught(a) for key, a in library.items()}
    examples = {key: shipped.examples_of(TYPE, key) for key in kept}
    arm = Arm(
        NAME.lower(),
        LevelTable((AGENTS,), (TYPE,)),
        library[FORAGE if wander_is_taught else WANDER].name,
        parameters={"boxes": BOXES, "pullers": 1},
    )
    project = Project(
        NAME,
        shipped.scenario,
        (NodeType(TYPE),),
        libraries={TYPE: Library(library)},
        examples={TYPE: examples},
        moments=_moments(shipped, examples),
        arms=(arm,),
    )
    return project, open_scenario(project)


def lacks_wander(project: Project) -> bool:
    """Whether the first half of the lesson was gone over without doing it, so that its second half cannot work."""
    wander = project.library(TYPE).automata.get(WANDER)
    return wander is not None and not wander.learned


def with_wander(project: Project, taught: Project) -> Project:
    """*project* with Wander as in *taught*."""
    project = with_automaton(project, TYPE, taught.library(TYPE).get(WANDER))
    project = with_examples(project, TYPE, WANDER, taught.examples_of(TYPE, WANDER))
    return replace(project, moments={**taught.moments, **project.moments})


def untaught(automaton: Automaton) -> Automaton:
    """An automaton with its states and features, and nothing learned."""
    return replace(automaton, learned={}, learned_from="")


def _moments(shipped: Project, examples: dict[str, tuple[Example, ...]]) -> dict[str, Moment]:
    names = {example.snapshot for found in examples.values() for example in found if example.snapshot}
    return {name: shipped.moments[name] for name in sorted(names)}
