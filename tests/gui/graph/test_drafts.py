"""A graph is worked out again where something that it shows has changed, and not for examples that no edge is read from."""

from collections.abc import Iterator
from dataclasses import replace

import pytest

from app.core.edits import disable_examples, note_state, rename_automaton, set_note
from app.core.library import Library
from app.core.project import Project
from app.core.tree import Forest, Tree
from app.editor.graph.drafts import Drafts
from app.editor.graph.laying_out import LayingOut
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from app.export.graph import AutomatonGraph

WANDER, FORAGE = BehaviorKey("agent", "wander"), BehaviorKey("agent", "forage")


@pytest.fixture
def drafts(studio: Studio) -> Iterator[Drafts]:
    laying_out = LayingOut()
    yield Drafts(studio.document, laying_out)
    laying_out.close()


def graph(drafts: Drafts, key: BehaviorKey) -> AutomatonGraph:
    drawn = drafts.drawn(key, ())
    assert drawn is not None
    return drawn.graph


def grown(project: Project, key: BehaviorKey) -> Project:
    """The project with a forest in place of each tree of an automaton."""
    automata = project.library(key.type).automata
    old = automata[key.id]
    models = {
        state: Forest(model.labels, (model,))
        for state, model in old.learned.items()
        if isinstance(model, Tree)
    }
    library = Library({**automata, key.id: replace(old, learned=models)})
    return replace(project, libraries={**project.libraries, key.type: library})


def test_examples_and_other_behaviors_change_no_graph_of_trees(studio: Studio, drafts: Drafts) -> None:
    studio.settings.learns_by_itself = False
    before = graph(drafts, WANDER)
    studio.document.do(disable_examples, WANDER.type, WANDER.id, ["1"])
    studio.document.do(rename_automaton, FORAGE.type, FORAGE.id, "Gather")
    assert graph(drafts, WANDER) is before


def test_a_note_changes_no_graph_and_a_note_on_a_state_does(studio: Studio, drafts: Drafts) -> None:
    before = graph(drafts, WANDER)
    studio.document.do(set_note, WANDER.type, WANDER.id, "It looks for boxes.")
    assert graph(drafts, WANDER) is before
    studio.document.do(note_state, WANDER.type, WANDER.id, "forward", "As long as nothing is in the way.")
    assert graph(drafts, WANDER) != before


def test_the_name_of_what_a_state_holds_does(studio: Studio, drafts: Drafts) -> None:
    before = graph(drafts, FORAGE)
    studio.document.do(rename_automaton, WANDER.type, WANDER.id, "Stroll")
    after = graph(drafts, FORAGE)
    assert [state.name for state in after.states] != [state.name for state in before.states]


def test_edges_that_are_read_from_examples_follow_them(studio: Studio, drafts: Drafts) -> None:
    studio.settings.learns_by_itself = False
    document = studio.document
    document.push("Grow", grown(document.project, WANDER))
    before = graph(drafts, WANDER)
    every = [example.id for example in document.project.examples_of(WANDER.type, WANDER.id)]
    document.do(disable_examples, WANDER.type, WANDER.id, every)
    assert graph(drafts, WANDER).edges != before.edges


def test_what_one_state_learned_changes_no_edges_of_others(studio: Studio, drafts: Drafts) -> None:
    document = studio.document
    before = graph(drafts, FORAGE)
    library = document.project.library(FORAGE.type)
    forage = library.automata[FORAGE.id]
    source, *others = [state for state in forage.learned if forage.learned[state] is not None]
    learned = {state: model for state, model in forage.learned.items() if state != source}
    changed = Library({**library.automata, FORAGE.id: replace(forage, learned=learned)})
    libraries = {**document.project.libraries, FORAGE.type: changed}
    document.push("Forget", replace(document.project, libraries=libraries))
    after = graph(drafts, FORAGE)
    kept = [edge for edge in before.edges if edge.source in others]
    assert kept
    assert all(any(edge is other for other in after.edges) for edge in kept)
    assert not any(edge.source == source and edge.support for edge in after.edges)
