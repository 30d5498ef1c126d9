"""What the numbers of an experiment depend on, as hashes: results are kept only as long as these stay the same."""

import hashlib
import json
from dataclasses import asdict, replace
from typing import Any

from ...core.project import Arm, Project
from ...core.storage.convert import automaton_document
from ...core.vocabulary import Phrases
from ...learner.trainer import LEARNER_VERSION, fingerprint
from ...sim.kernel.linking import fingerprint as of_functions
from ...sim.kernel.source import scenario_functions
from ...sim.scenario import Scenario
from ..runs import treatment
from .flat import NAME
from .learning import Key, behaviors_in_use
from .plan import Cell, Experiment
from .store import Fingerprint
from .treatments import changed, sorted_settings

#: Raised whenever the same experiment would give other numbers than before.
RESULTS_VERSION = 1


def fingerprint_of(project: Project, scenario: Scenario, experiment: Experiment) -> Fingerprint:
    """Hashes of all that a run's numbers depend on, by what the user calls it; not of titles, claims or how many runs."""
    cells = experiment.cells()
    learned = [cell for cell in cells if sorted_settings(cell.settings).lesson is not None]
    return {
        "ticks": str(experiment.ticks),
        "points": str(experiment.points),
        "seed": str(experiment.seed),
        "results version": str(RESULTS_VERSION),
        "arms and factors": _hash([_plain(cell) for cell in cells]),
        "behaviors": _hash(_distinct(_behaviors(project, scenario, cell) for cell in cells)),
        "worlds": _hash([_world(project, scenario, cell) for cell in cells]),
        "examples": _hash(_distinct(_lessons(project, scenario, cell) for cell in learned)),
        "scenario": fingerprint_of_scenario(scenario),
    }


def fingerprint_of_scenario(scenario: Scenario) -> str:
    """A hash of what a scenario does and declares, words for readers left out."""
    vocabulary = scenario.vocabulary
    declared = [
        *(replace(feature, phrases=Phrases(), doc="") for feature in vocabulary.features.values()),
        *(replace(behavior, doc="") for behavior in vocabulary.behaviors.values()),
        *(replace(target, doc="") for target in vocabulary.targets.values()),
    ]
    functions = {**scenario_functions(scenario), "reset": scenario.stages["reset"]}
    return _hash([of_functions(functions), [repr(one) for one in declared]])


def _plain(cell: Cell) -> list[Any]:
    return [cell.number, cell.arm, dict(cell.levels), cell.project_arm, sorted(cell.settings.items())]


def _keys(project: Project, scenario: Scenario, cell: Cell) -> tuple[Project, Arm, tuple[Key, ...]]:
    project, arm = changed(project, cell.project_arm, cell.settings)
    return project, arm, behaviors_in_use(project, scenario.vocabulary, arm)


def _behaviors(project: Project, scenario: Scenario, cell: Cell) -> list[Any]:
    project, arm, keys = _keys(project, scenario, cell)
    documents = [(key[0], automaton_document(project.library(key[0]).get(key[1]))) for key in keys]
    for _, document in documents:
        for words in ("note", "learned_from"):  # which change nothing about what it does
            del document[words]
    return [asdict(arm.forest()), arm.top, [asdict(kind) for kind in project.types], documents]


def _world(project: Project, scenario: Scenario, cell: Cell) -> list[Any]:
    project, arm = changed(project, cell.project_arm, cell.settings)
    settled = treatment(project, scenario, arm, sorted_settings(cell.settings).scenario)
    return [sorted(settled.parameters.items()), settled.physics]


def _lessons(project: Project, scenario: Scenario, cell: Cell) -> list[Any]:
    """What behaviors are learned anew from: examples with their picks, or the demonstrations of a flat automaton."""
    project, _, keys = _keys(project, scenario, cell)
    told: list[Any] = [
        [
            *key,
            fingerprint(project.library(key[0]).get(key[1]), project.examples_of(*key)),
            [[example.id, example.pick] for example in project.examples_of(*key)],
        ]
        for key in keys
    ]
    if sorted_settings(cell.settings).flat:
        told += [[NAME, asdict(d)] for d in project.demonstrations if (d.type, d.automaton) in keys]
    return [LEARNER_VERSION, told]


def _distinct(values: Any) -> list[str]:
    """Each document once, as text: many cells differ in nothing here."""
    return list(dict.fromkeys(json.dumps(value, sort_keys=True) for value in values))


def _hash(value: object) -> str:
    return hashlib.sha256(json.dumps(value, sort_keys=True).encode()).hexdigest()[:16]
