"""Telling which automata of one value of a project after another are stale."""

from collections.abc import Collection
from threading import Lock

from ..core.project import Project
from ..core.remembered import Remembered
from .trainer import Key, fingerprint


class Freshness:
    """Knows what automata would be learned from, and works it out again only where that has changed: no name does it.

    Several threads may ask: what one of them works out, the others know.
    """

    def __init__(self) -> None:
        self._lock = Lock()
        self._fingerprints: Remembered[Key, str] = Remembered()

    def fingerprint(self, project: Project, key: Key) -> str:
        """That of what an automaton would be learned from now."""
        automaton, examples = project.library(key[0]).get(key[1]), project.examples_of(*key)
        made_of = automaton.features, automaton.states, automaton.settings, automaton.cuts, examples
        with self._lock:
            return self._fingerprints.of(key, made_of, lambda: fingerprint(automaton, examples))

    def is_stale(self, project: Project, key: Key) -> bool:
        """Whether learning an automaton again could give something else; never for one without examples."""
        if not project.examples_of(*key):
            return False
        return project.library(key[0]).get(key[1]).learned_from != self.fingerprint(project, key)

    def keep(self, keys: Collection[Key]) -> None:
        """Forget all automata but these."""
        with self._lock:
            self._fingerprints.keep(keys)
