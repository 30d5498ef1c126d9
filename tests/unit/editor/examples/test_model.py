"""What the table of examples remembers from one behavior to the next."""

from dataclasses import replace

from app.core.edits import rename_automaton
from app.core.project import Project
from app.editor.examples.model import ExamplesModel, Subject
from app.editor.examples.verdicts import Verdict
from tests.samples import AGENT, project, vocabulary


def subject(of: Project, automaton_id: str = "goto") -> Subject:
    library = of.library(AGENT)
    return Subject(AGENT, library.get(automaton_id), library, vocabulary())


def test_verdicts_stay_with_their_behavior_though_others_have_examples_of_the_same_ids() -> None:
    model, examples = ExamplesModel(), project().examples_of(AGENT, "goto")
    model.show(subject(project()), examples)
    model.judge({example.id: Verdict.AGREES for example in examples})
    model.show(subject(rename_automaton(project(), AGENT, "goto", "Approach")), examples)
    assert model.verdict(examples[0]) is Verdict.AGREES
    model.show(subject(project(), "wander"), tuple(replace(example, node="other") for example in examples))
    assert model.verdict(model.example(0)) is Verdict.UNKNOWN
