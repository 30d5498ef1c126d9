"""What is said of many examples at once, said of one after another as anybody would who had all the time."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

from app.core.automaton import Automaton, Model, Refit
from app.core.examples import Example
from app.core.tree import Forest, Tree
from app.editor.examples.verdicts import Verdict


def verdicts(automaton: Automaton, examples: Sequence[Example]) -> Mapping[str, Verdict]:
    """The verdict on each example, by its id."""
    enabled = [example for example in examples if example.enabled]
    against = set[str]().union(*conflicts(automaton, enabled))
    return {
        example.id: Verdict.OFF
        if not example.enabled
        else Verdict.LEFT_OUT
        if not learnable(automaton, example)
        else Verdict.CONFLICT
        if example.id in against
        else opinion(automaton.learned.get(example.source), example)
        for example in examples
    }


def learnable(automaton: Automaton, example: Example) -> bool:
    """Whether both states are there, and every feature has a value."""
    states = {state.id for state in automaton.states}
    there = all(use.id in example.values for use in automaton.features)
    return there and example.source in states and example.label in states


def conflicts(automaton: Automaton, examples: Sequence[Example]) -> Iterator[set[str]]:
    """Ids of examples of one state with equal features, of which some have another label."""
    alike: dict[object, list[Example]] = defaultdict(list)
    for example in examples:
        alike[example.source, *(example.values.get(use.id) for use in automaton.features)].append(example)
    for group in alike.values():
        if len({example.label for example in group}) > 1:
            yield {example.id for example in group}


def opinion(model: Model | None, example: Example) -> Verdict:
    """What the model of its state says of an example."""
    if isinstance(model, Refit):
        return Verdict.UNTOLD
    if model is None:
        return Verdict.UNKNOWN
    try:
        guess = guessed(model, example)
    except KeyError:
        return Verdict.UNKNOWN
    return Verdict.AGREES if guess == example.label else Verdict.OUTVOTED


def guessed(model: Tree | Forest, example: Example) -> str:
    """The first of the most probable labels."""
    probabilities = model.decide(example.values.__getitem__).probabilities
    return model.labels[max(range(len(probabilities)), key=probabilities.__getitem__)]
