"""Random vocabularies, automata, forests and whole projects for property tests.

A project drawn *checked* has no errors: every name resolves, every binding is closed, every test fits its feature,
libraries have no cycle. Otherwise any reference may lead nowhere, slots may be open and automata may hold each other in
circles; the form of each value is still what its type promises, so that it can be stored.
"""

from .automata import (
    Scope,
    automata,
    bindings,
    entered_states,
    feature_tests,
    left_states,
    models,
    trees,
    values_of,
)
from .projects import examples, moments, projects, projects_with_vocabulary, tops
from .vocabularies import finite, forests, level_tables, node_types, scalars, some, vocabularies, words

__all__ = [
    "Scope",
    "automata",
    "bindings",
    "entered_states",
    "examples",
    "feature_tests",
    "finite",
    "forests",
    "left_states",
    "level_tables",
    "models",
    "moments",
    "node_types",
    "projects",
    "projects_with_vocabulary",
    "scalars",
    "some",
    "tops",
    "trees",
    "values_of",
    "vocabularies",
    "words",
]
