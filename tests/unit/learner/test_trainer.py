"""Learning whole automata, putting what was learned into a project, and telling that it is stale."""

from dataclasses import replace
from math import nan
from typing import Any

import pytest

from app.core.automaton import START, Automaton, Prune, Refit, Rule, Sampling, Settings
from app.core.errors import ExampleError, LibraryError, ParameterError
from app.core.examples import Example
from app.core.features import FeatureUse, Ground, Sense, TicksInState
from app.core.library import Library
from app.core.project import Project
from app.core.tree import Branch, Tree
from app.learner.builder import LearningCancelled
from app.learner.trainer import (
    Learned,
    apply,
    classifiers,
    fingerprint,
    is_stale,
    learn,
    refit,
    with_examples,
)
from tests import samples
from tests.samples import AGENT, GROUP

GOTO = (AGENT, "goto")
VOCABULARY = samples.vocabulary()
EXAMPLES = samples.goto_examples()


def with_goto(automaton: Automaton | None = None, examples: tuple[Example, ...] | None = None) -> Project:
    """The sample project with another goto, or other examples of it."""
    project = samples.project()
    if automaton is not None:
        automata = {**project.library(AGENT).automata, "goto": automaton}
        project = replace(project, libraries={**project.libraries, AGENT: Library(automata)})
    return project if examples is None else replace(project, examples={AGENT: {"goto": examples}})


def settings(**fields: Any) -> Automaton:
    return replace(samples.goto(), settings=Settings(**fields))


def goto_of(project: Project) -> Automaton:
    return project.library(AGENT).get("goto")


# ------------------------------------------------------------------------------------------------ learning


def test_each_state_with_examples_gets_a_model() -> None:
    learned = learn(samples.project(), VOCABULARY).automata[GOTO]
    assert list(learned.models) == [START, "forward", "left"]
    forward = learned.models["forward"]
    assert isinstance(forward, Tree)
    assert forward.labels == ("forward", "left")
    assert forward.decide({"distance": 30.0, "direction": 2.0}.__getitem__).probabilities == (0.0, 1.0)


def test_authored_automata_are_left_alone() -> None:
    assert list(learn(samples.project(), VOCABULARY).automata) == [GOTO]


def test_automata_are_learned_after_those_that_they_hold() -> None:
    project = samples.project()
    examples = {
        AGENT: {"forage": EXAMPLES, "wander": EXAMPLES, "goto": EXAMPLES},
        GROUP: {"control": EXAMPLES},
    }
    assert with_examples(replace(project, examples=examples)) == (
        (AGENT, "goto"),
        (AGENT, "wander"),
        (AGENT, "forage"),
        (GROUP, "control"),
    )


def test_the_report_says_what_was_learned() -> None:
    (report,) = learn(samples.project(), VOCABULARY).reports
    assert (report.type, report.automaton, report.name, report.level, report.examples) == (
        *GOTO,
        "goto",
        0,
        5,
    )
    assert [(s.state, s.name, s.examples, s.nodes, s.accuracy, s.cv_accuracy) for s in report.states] == [
        (START, "Start", 1, 1, 1.0, None),
        ("forward", "forward", 2, 3, 1.0, None),
        ("left", "left", 2, 3, 1.0, None),
    ]


def test_the_report_estimates_accuracy_on_new_examples_when_asked() -> None:
    (report,) = learn(samples.project(), VOCABULARY, cross_validate=True).reports
    assert [state.cv_accuracy for state in report.states] == [None, 0.0, 0.0]


def test_the_level_in_the_report_is_the_types() -> None:
    examples = tuple(
        Example(str(n), "search", label, {"attached": float(n), "finished": 0.0, "help": 0.0})
        for n, label in enumerate(("search", "gather"))
    )
    project = replace(samples.project(), examples={GROUP: {"control": examples}})
    assert learn(project, VOCABULARY).reports[0].level == 1


def test_examples_left_out_are_in_the_report() -> None:
    partial = replace(EXAMPLES[0], values={})
    (report,) = learn(with_goto(examples=(partial, *EXAMPLES[1:])), VOCABULARY).reports
    assert report.examples == 4
    assert [left.example for left in report.left_out] == ["1"]


def test_states_whose_examples_are_all_disabled_have_no_model() -> None:
    some = (replace(EXAMPLES[0], enabled=False), *EXAMPLES[1:])
    assert START not in learn(with_goto(examples=some), VOCABULARY).automata[GOTO].models


def test_learning_all_unlearns_an_automaton_whose_examples_are_all_disabled() -> None:
    none = tuple(replace(e, enabled=False) for e in EXAMPLES)
    project = with_goto(examples=none)
    assert goto_of(apply(project, learn(project, VOCABULARY))).learned == {}


def test_asking_for_an_automaton_without_examples_is_refused() -> None:
    with pytest.raises(ExampleError, match="'wander' has no examples to learn from \\(teach it first\\)"):
        learn(samples.project(), VOCABULARY, [(AGENT, "wander")])


def test_asking_for_an_automaton_with_unusable_examples_only_is_refused_with_the_reasons() -> None:
    some = (replace(EXAMPLES[0], enabled=False), replace(EXAMPLES[1], values={}))
    with pytest.raises(
        ExampleError, match="1 are disabled and 1 left out, the first because it has no value"
    ):
        learn(with_goto(examples=some), VOCABULARY, [GOTO])


def test_asking_for_an_automaton_that_is_not_there_is_refused() -> None:
    with pytest.raises(LibraryError, match="no behavior with the id 'fly'"):
        learn(samples.project(), VOCABULARY, [(AGENT, "fly")])
    with pytest.raises(LibraryError, match="no node type 'bird'"):
        learn(samples.project(), VOCABULARY, [("bird", "fly")])


def test_an_example_that_is_no_number_is_refused_with_its_place() -> None:
    bad = replace(EXAMPLES[2], values={"distance": nan, "direction": 0.0})
    with pytest.raises(ExampleError, match="behavior 'goto', state 'forward', example '3'"):
        learn(with_goto(examples=(bad,)), VOCABULARY)


def test_an_unknown_classifier_is_refused() -> None:
    with pytest.raises(ParameterError, match="no classifier 'oracle'"):
        learn(with_goto(settings(classifier="oracle")), VOCABULARY)


def test_an_option_out_of_range_is_refused() -> None:
    with pytest.raises(ParameterError, match="'min_leaf' is 0"):
        learn(with_goto(settings(options={"min_leaf": 0.0})), VOCABULARY)


def test_progress_rises_from_0_to_1_and_names_behavior_and_state() -> None:
    told: list[tuple[float, str]] = []
    learn(samples.project(), VOCABULARY, progress=lambda *said: told.append(said), cross_validate=True)
    shares = [share for share, _ in told]
    assert shares == sorted(shares)
    assert (shares[0], shares[-1]) == (0.0, 1.0)
    assert "goto: forward" in [what for _, what in told]


def test_learning_stops_when_asked() -> None:
    with pytest.raises(LearningCancelled):
        learn(samples.project(), VOCABULARY, cancelled=lambda: True)


def test_learning_can_stop_in_the_middle() -> None:
    answers = iter([False, False, True])
    with pytest.raises(LearningCancelled):
        learn(samples.project(), VOCABULARY, cancelled=lambda: next(answers))


def test_only_the_chosen_features_are_looked_at() -> None:
    """Values of others may lie in the examples; ticks and flags are no exception."""
    goto = replace(samples.goto(), features=(*samples.goto().features, FeatureUse("ticks", TicksInState())))
    apart = tuple(
        replace(e, values={"distance": 5.0, "direction": 0.0, "ticks": float(not e.continuation)})
        for e in EXAMPLES
    )
    with_ticks = learn(with_goto(goto, apart), VOCABULARY).automata[GOTO].models["forward"]
    without = learn(with_goto(samples.goto(), apart), VOCABULARY).automata[GOTO].models["forward"]
    assert isinstance(with_ticks, Tree)
    assert isinstance(without, Tree)
    assert with_ticks.features() == ("ticks",)
    assert without.features() == ()


# ------------------------------------------------------------------------------------------------ applying


def test_what_was_learned_goes_into_the_automaton() -> None:
    project = samples.project()
    learned = learn(project, VOCABULARY)
    goto = goto_of(apply(project, learned))
    assert goto.learned == learned.automata[GOTO].models
    assert goto.learned_from == learned.automata[GOTO].fingerprint


def test_automata_that_were_not_learned_stay_the_same_values() -> None:
    project = samples.project()
    after = apply(project, learn(project, VOCABULARY))
    assert after.library(AGENT).get("wander") is project.library(AGENT).get("wander")
    assert after.library(GROUP) is project.library(GROUP)
    assert after.examples is project.examples


def test_learning_again_changes_nothing() -> None:
    once = apply(samples.project(), learn(samples.project(), VOCABULARY))
    assert apply(once, learn(once, VOCABULARY)) is once


def test_prunes_survive_learning() -> None:
    project = samples.project()
    prune = Prune("7", "forward", (), frozenset({"left"}))
    project = with_goto(replace(goto_of(project), prunes=(prune,)))
    assert goto_of(apply(project, learn(project, VOCABULARY))).prunes == (prune,)


def test_an_answer_for_an_automaton_that_is_gone_is_skipped() -> None:
    project = samples.project()
    learned = learn(project, VOCABULARY)
    without = replace(project, libraries={})
    assert apply(without, learned) is without


def test_nothing_learned_changes_nothing() -> None:
    project = samples.project()
    assert apply(project, Learned()) is project


# ------------------------------------------------------------------------------------------------ staleness


def test_a_learned_automaton_is_stale_only_until_it_is_learned_again() -> None:
    project = samples.project()
    assert is_stale(project, *GOTO)
    assert not is_stale(apply(project, learn(project, VOCABULARY)), *GOTO)


def test_an_authored_automaton_is_never_stale() -> None:
    assert not is_stale(samples.project(), AGENT, "wander")


CHANGES_THAT_MATTER = {
    "an example is disabled": lambda a, e: (a, (replace(e[0], enabled=False), *e[1:])),
    "an example is added": lambda a, e: (a, (*e, replace(e[2], id="6"))),
    "a value changes": lambda a, e: (a, (replace(e[0], values={**e[0].values, "distance": 41.0}), *e[1:])),
    "a label changes": lambda a, e: (a, (replace(e[0], label="left"), *e[1:])),
    "a weight changes": lambda a, e: (a, (replace(e[0], weight=2.0), *e[1:])),
    "a continuation is none": lambda a, e: (a, (*e[:1], replace(e[1], continuation=False), *e[2:])),
    "a feature is dropped": lambda a, e: (replace(a, features=a.features[:1]), e),
    "features change places": lambda a, e: (replace(a, features=a.features[::-1]), e),
    "a feature means something else": lambda a, e: (
        replace(
            a,
            features=(
                FeatureUse("distance", Sense("DistanceTo", {"target": Ground("deposit")})),
                a.features[1],
            ),
        ),
        e,
    ),
    "the classifier changes": lambda a, e: (replace(a, settings=Settings("cart")), e),
    "an option changes": lambda a, e: (replace(a, settings=Settings(options={"min_leaf": 2.0})), e),
    "pruning is switched on": lambda a, e: (replace(a, settings=Settings(pruning_confidence=0.25)), e),
    "a state that examples mention goes": lambda a, e: (replace(a, states=a.states[:3]), e),
}

CHANGES_THAT_DO_NOT = {
    "the order of examples": lambda a, e: (a, e[::-1]),
    "a disabled example": lambda a, e: (a, (*e, replace(e[0], id="6", label="left", enabled=False))),
    "a value of a feature not in use": lambda a, e: (
        a,
        (replace(e[0], values={**e[0].values, "x": 1.0}), *e[1:]),
    ),
    "where an example came from": lambda a, e: (
        a,
        (replace(e[0], tick=9, node="agent-2", snapshot="m2", pick=8), *e[1:]),
    ),
    "an example's number": lambda a, e: (a, (replace(e[0], id="77"), *e[1:])),
    "whole numbers as integers": lambda a, e: (
        a,
        (replace(e[0], values={"distance": 40, "direction": 0.1}), *e[1:]),
    ),
    "the automaton's name": lambda a, e: (replace(a, name="Servo"), e),
    "a feature's name": lambda a, e: (
        replace(a, features=(replace(a.features[0], name="How far"), a.features[1])),
        e,
    ),
    "a state's name": lambda a, e: (
        replace(a, states=(*a.states[:2], replace(a.states[2], name="Turn"), *a.states[3:])),
        e,
    ),
    "a state that no example mentions": lambda a, e: (
        replace(a, states=(*a.states[:2], samples.state("right", "RotateRight"), *a.states[2:])),
        e,
    ),
    "sampling": lambda a, e: (replace(a, settings=Settings(sampling=Sampling.HOLD)), e),
    "rules and prunes": lambda a, e: (replace(a, rules=(Rule("1", START, (), "left"),), prunes=()), e),
    "what was learned before": lambda a, e: (replace(a, learned={}, learned_from=""), e),
}


@pytest.mark.parametrize("change", CHANGES_THAT_MATTER)
def test_what_learning_depends_on_makes_it_stale(change: str) -> None:
    automaton, examples = CHANGES_THAT_MATTER[change](samples.goto(), EXAMPLES)
    assert fingerprint(automaton, examples) != fingerprint(samples.goto(), EXAMPLES)


@pytest.mark.parametrize("change", CHANGES_THAT_DO_NOT)
def test_what_learning_does_not_depend_on_leaves_it_fresh(change: str) -> None:
    automaton, examples = CHANGES_THAT_DO_NOT[change](samples.goto(), EXAMPLES)
    assert fingerprint(automaton, examples) == fingerprint(samples.goto(), EXAMPLES)
    before, after = (
        learn(with_goto(a, e), VOCABULARY).automata[GOTO].models
        for a, e in ((samples.goto(), EXAMPLES), (automaton, examples))
    )
    assert before == after


def test_the_order_in_which_slots_were_bound_does_not_matter() -> None:
    one = {"a": Ground("deposit"), "b": Ground("nearest-box")}
    other = dict(reversed(list(one.items())))
    uses = [(FeatureUse("f", Sense("Between", bindings)),) for bindings in (one, other)]
    first, second = (fingerprint(replace(samples.goto(), features=use), ()) for use in uses)
    assert first == second


# ------------------------------------------------------------------------------------------------ running


def test_stored_trees_are_found_as_they_are() -> None:
    project = samples.project()
    find = classifiers(project, VOCABULARY)
    goto = goto_of(project)
    assert find(AGENT, goto, "left") is goto.learned["left"]
    assert find(AGENT, goto, "done") is None


def test_other_classifiers_are_refitted_once_and_only_when_needed() -> None:
    project = with_goto(settings(classifier="knn"))
    project = apply(project, learn(project, VOCABULARY))
    goto = goto_of(project)
    assert goto.learned["forward"] == Refit("knn")
    find = classifiers(project, VOCABULARY)
    found = find(AGENT, goto, "forward")
    assert found is not None
    assert found is find(AGENT, goto, "forward")
    assert found.labels == ("forward", "left")


def test_a_refitted_classifier_without_examples_says_nothing() -> None:
    project = with_goto(replace(settings(classifier="knn"), learned={"done": Refit("knn")}))
    assert classifiers(project, VOCABULARY)(AGENT, goto_of(project), "done") is None


def test_refitting_gives_the_classifier_that_was_learned() -> None:
    project = with_goto(settings(classifier="logistic"))
    values = {"distance": 35.0, "direction": 1.0}.__getitem__
    one, other = (refit(project, VOCABULARY, *GOTO, "forward") for _ in range(2))
    assert one is not None
    assert other is not None
    assert one.decide(values) == other.decide(values)


def test_a_tree_learned_from_continuations_goes_on_up_to_the_transition() -> None:
    """Forward was kept from far; at 30 the demonstrator turned. At 30.1 the agent still walks."""
    values = [{"distance": 40.0, "direction": 0.0}, {"distance": 30.0, "direction": 0.0}]
    examples = (
        replace(EXAMPLES[1], values=values[0]),
        replace(EXAMPLES[2], values=values[1]),
    )
    model = learn(with_goto(examples=examples), VOCABULARY).automata[GOTO].models["forward"]
    assert isinstance(model, Tree)
    assert isinstance(model.root, Branch)
    assert model.decide({"distance": 30.1, "direction": 0.0}.__getitem__).probabilities == (1.0, 0.0)
    assert model.decide({"distance": 30.0, "direction": 0.0}.__getitem__).probabilities == (0.0, 1.0)
