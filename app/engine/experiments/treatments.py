"""From the settings of a cell to a treatment that can be run.

====================================  ================================================================================
setting                               what it changes
====================================  ================================================================================
``world.NAME``                        a parameter of the scenario
``physics``, ``engine``               what moves things, and what steps worlds, as ``understudy run --set`` does
``world``                             the project's named set of parameters that the arm takes place in
``sizes``                             the sizes of the hierarchy's levels, from the roots down: ``[2, 5, 5]``
``top``                               the behavior that every root runs
``rule.TYPE/BEHAVIOR/RULE``           the probability of an authored rule, by the id of the rule
``use.TYPE/BEHAVIOR``                 another behavior in its place, ``TYPE/BEHAVIOR``: same parameters, other insides
``learner.classifier``                learns the arm's behaviors anew with this classifier
``learner.options.NAME``              an option of that classifier
``learner.picks``                     learns them from so many picks, drawn at random for each run; or ``all``
``learner.flat``                      true: one flat automaton instead of the hierarchy of behaviors, see `flat`
====================================  ================================================================================
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from threading import Lock

from ...core.amounts import counted
from ...core.automaton import Automaton
from ...core.check import refuse
from ...core.errors import ParameterError
from ...core.library import Library
from ...core.project import Arm, LevelTable, Project, Value
from ...learner.trainer import classifiers
from ...sim.scenario import Scenario
from ..runs import Treatment, treatment
from .flat import Flat, flat_of, refuse_controllers, with_flat
from .learning import Lesson, relearned
from .plan import Cell, Experiment, Given, Settings

#: What is counted of a run besides the scenario's measures, where behaviors are learned anew.
EXTRA_MEASURES = ("picks", "examples")
ALL = "all"
KNOWN = (
    "world.NAME, world, physics, engine, sizes, top, rule.TYPE/BEHAVIOR/RULE, use.TYPE/BEHAVIOR, "
    "learner.classifier, learner.options.NAME, learner.picks, learner.flat"
)


@dataclass(frozen=True, slots=True)
class Sorted:
    """Settings by what they are for."""

    scenario: Mapping[str, Value] = field(default_factory=dict)
    lesson: Lesson | None = None
    flat: bool = False


@dataclass(frozen=True, slots=True)
class Ready:
    """A treatment, and what else is counted of its runs."""

    treatment: Treatment
    counts: Mapping[str, float] = field(default_factory=dict)


class Treatments:
    """Makes treatments for the runs of an experiment; those that are the same for all runs of a cell once."""

    def __init__(self, project: Project, scenario: Scenario, experiment: Experiment) -> None:
        self._project = project
        self._scenario = scenario
        self._experiment = experiment
        self._ready: dict[int, Ready] = {}
        self._flats: dict[str, Flat] = {}
        self._lock = Lock()

    def of(self, cell: Cell, run: int) -> Ready:
        """The treatment of one run.

        Raises:
            UnderstudyError: A setting names nothing, or its value is not allowed.
        """
        wanted = sorted_settings(cell.settings)
        with self._lock:  # one thread watches a flat automaton, or makes a treatment, while the others wait
            if cell.number not in self._ready:
                self._ready[cell.number] = self._prepared(cell, wanted)
        ready = self._ready[cell.number]
        return ready if wanted.lesson is None else self._taught(ready.treatment, wanted.lesson, run)

    def _prepared(self, cell: Cell, wanted: Sorted) -> Ready:
        """What all runs of a cell have in common."""
        project, arm = changed(self._project, cell.project_arm, cell.settings)
        if wanted.flat:
            project, arm = with_flat(project, arm, self._flat(project, arm))
        models = classifiers(project, self._scenario.vocabulary)
        return Ready(treatment(project, self._scenario, arm, wanted.scenario, None, models))

    def _taught(self, common: Treatment, lesson: Lesson, run: int) -> Ready:
        """The same with behaviors learned anew for this run."""
        vocabulary, seed = self._scenario.vocabulary, self._experiment.seed
        new = relearned(common.project, vocabulary, common.arm, lesson, seed, run)
        models = classifiers(new.project, vocabulary)
        counts = {"picks": float(new.picks), "examples": float(new.examples)}
        return Ready(replace(common, project=new.project, classifiers=models), counts)

    def _flat(self, project: Project, arm: Arm) -> Flat:
        if arm.name not in self._flats:
            self._flats[arm.name] = flat_of(project, self._scenario, arm)
        return self._flats[arm.name]


def refuse_settings(
    project: Project, scenario: Scenario, arm_name: str, settings: Settings, sound: Settings | None = None
) -> None:
    """Raise an error that says what is wrong with the settings of an arm, if something is.

    Args:
        sound: Settings with which nothing was wrong: where the project is the same, it is not checked once more.
    """
    wanted = sorted_settings(settings)
    project, arm = changed(project, arm_name, settings)
    treatment(project, scenario, arm, wanted.scenario)
    if wanted.lesson is not None:
        wanted.lesson.refuse_bad()
    if wanted.flat:
        refuse_controllers(arm)
    if sound is not None and _of_project(settings) == _of_project(sound):
        return
    others = tuple(arm if a.name == arm.name else a for a in project.arms)
    refuse(replace(project, arms=others), scenario.vocabulary, arm.name)


# ---------------------------------------------------------------------------------------------------- settings


def sorted_settings(settings: Settings) -> Sorted:
    """What is to be done besides changing project and arm.

    Raises:
        ParameterError: There is no such setting, or a value is of the wrong type.
    """
    scenario = {key: _scalar(key, value) for key, value in settings.items() if _is_scenario(key)}
    learner = {
        key.removeprefix("learner."): value for key, value in settings.items() if key.startswith("learner.")
    }
    flat = learner.pop("flat", False)
    if not isinstance(flat, bool):
        raise ParameterError(f"'learner.flat' must be true or false, but found {flat!r}")
    return Sorted(scenario, _lesson(learner, flat=flat), flat)


def _of_project(settings: Settings) -> Settings:
    """Those that change behaviors or the hierarchy."""
    return {k: v for k, v in settings.items() if not (_is_scenario(k) or k.startswith("learner."))}


def _is_scenario(key: str) -> bool:
    return key in ("physics", "engine") or key.startswith("world.")


def _scalar(key: str, value: Given) -> Value:
    if isinstance(value, tuple):
        raise ParameterError(f"{key!r} takes a single value, but found an array")
    return value


def _lesson(learner: Mapping[str, Given], *, flat: bool) -> Lesson | None:
    if not learner:
        return Lesson() if flat else None
    options: list[tuple[str, float]] = []
    classifier, picks = "", None
    for key, value in learner.items():
        if key == "classifier" and isinstance(value, str):
            classifier = value
        elif key == "picks" and (value == ALL or (isinstance(value, int) and value > 0)):
            picks = None if value == ALL else int(str(value))
        elif key.startswith("options.") and isinstance(value, int | float):
            options.append((key.removeprefix("options."), float(value)))
        else:
            allowed = "classifier (a name), options.NAME (a number), picks (1 or more, or 'all'), flat"
            raise ParameterError(f"'learner.{key}' cannot be {value!r}; there are: {allowed}")
    return Lesson(classifier, tuple(options), picks)


def changed(project: Project, arm_name: str, settings: Settings) -> tuple[Project, Arm]:
    """*project* and its arm with the settings that change behaviors and hierarchy; the others are skipped.

    Raises:
        UnderstudyError: A setting names nothing, or its value is not allowed.
    """
    arm = project.arm(arm_name)
    for key, value in sorted(settings.items()):  # rules before what uses the behaviors that they are of
        kind, _, name = key.partition(".")
        if key == "world":
            arm = replace(arm, world=str(value))
        elif key == "top":
            arm = replace(arm, top=str(value))
        elif key == "sizes":
            arm = _resized(arm, value)
        elif kind == "rule":
            project = _with_probability(project, name, value)
        elif kind == "use":
            project = _with_other(project, name, str(value))
        elif not (_is_scenario(key) or kind == "learner"):
            raise ParameterError(f"there is no setting {key!r}; there are: {KNOWN}")
    return project, arm


def _resized(arm: Arm, sizes: Given) -> Arm:
    if not isinstance(arm.hierarchy, LevelTable):
        raise ParameterError(
            f"the hierarchy of arm {arm.name!r} is drawn by hand, so 'sizes' cannot change it"
        )
    levels = len(arm.hierarchy.types)
    if not isinstance(sizes, tuple) or len(sizes) != levels or min(sizes) < 1:
        raise ParameterError(
            f"'sizes' must be an array of {counted(levels, 'whole number')}, 1 or more, for arm {arm.name!r}, but found {sizes!r}"
        )
    return replace(arm, hierarchy=LevelTable(sizes, arm.hierarchy.types))


def _with_probability(project: Project, name: str, value: Given) -> Project:
    behavior, _, rule_id = name.rpartition("/")
    type_name, automaton = _behavior(project, behavior)
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0.0 <= value <= 1.0:
        raise ParameterError(f"'rule.{name}' must be a probability from 0 to 1, but found {value!r}")
    if rule_id not in (rule.id for rule in automaton.rules):
        there = ", ".join(rule.id for rule in automaton.rules) or "none"
        raise ParameterError(f"{automaton.name!r} has no rule {rule_id!r}; there are: {there}")
    rules = tuple(replace(r, probability=float(value)) if r.id == rule_id else r for r in automaton.rules)
    return _put(project, type_name, replace(automaton, rules=rules))


def _with_other(project: Project, name: str, other: str) -> Project:
    """*project* in which the insides of one behavior are those of another."""
    type_name, replaced = _behavior(project, name)
    _, instead = _behavior(project, other)
    if instead.parameters != replaced.parameters:
        wanted = ", ".join(replaced.parameters) or "none"
        raise ParameterError(f"{other!r} cannot stand for {name!r}: its parameters have to be: {wanted}")
    return _put(project, type_name, replace(instead, id=replaced.id, name=replaced.name))


def _behavior(project: Project, name: str) -> tuple[str, Automaton]:
    type_name, _, called = name.partition("/")
    found = project.library(type_name).by_name(called)
    if found is None:
        there = [f"{t}/{a.name}" for t, lib in project.libraries.items() for a in lib.automata.values()]
        raise ParameterError(f"there is no behavior {name!r}; there are: {', '.join(there) or 'none'}")
    return type_name, found


def _put(project: Project, type_name: str, automaton: Automaton) -> Project:
    library = Library({**project.library(type_name).automata, automaton.id: automaton})
    return replace(project, libraries={**project.libraries, type_name: library})
