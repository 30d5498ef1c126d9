"""What can be picked for a node: the states of the automaton that is taught, and what could become one, with their keys."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from ...core.automaton import Automaton, Basic, Content, Nested, RaiseFlag, State
from ...core.examples import Example
from ...core.library import Library, known_flags
from ...core.naming import shown_content
from ...core.vocabulary import FINISHED, Vocabulary
from ...core.wording import state_words

DIGITS = "123456789"
LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"


@dataclass(frozen=True, slots=True)
class Choice:
    """One thing that can be picked.

    Attributes:
        name: What the user reads.
        content: What the state holds, or would hold; the bindings of one that is no state yet are still open.
        state: Id of the state; empty where it would be a new one.
        key: The key that picks it; empty if there is none left.
        also: The letter that picked it before it was a state, and still does; empty if there is none.
        slots: Target parameters that have to be chosen before it can be picked.
        raises: The flag that it raises, after which the automaton begins anew; empty if it raises none.
        doc: What it does.
    """

    name: str
    content: Content
    state: str = ""
    key: str = ""
    also: str = ""
    slots: tuple[str, ...] = ()
    raises: str = ""
    doc: str = ""

    @property
    def automaton(self) -> str:
        """Id of the automaton that it runs; empty if it is none."""
        return self.content.automaton if isinstance(self.content, Nested) else ""

    @property
    def kind(self) -> str:
        """What it is, in a word."""
        match self.content:
            case Nested():
                return "learned"
            case RaiseFlag():
                return "flag"
        return "basic"


def choices_of(
    automaton: Automaton, library: Library, vocabulary: Vocabulary, reserved: Collection[str] = ()
) -> tuple[Choice, ...]:
    """All that can be picked while *automaton* is taught: its states in order, then what could be added to it.

    Digits pick states, letters what raises a flag or is no state yet. A letter stays with its behavior: whoever has
    just added a state by it can go on to press it.

    Args:
        reserved: Keys that mean something else.
    """
    addable = _addable(automaton, library, vocabulary)
    letters = _letters(addable, reserved)
    states = _with_keys(
        [_of_state(state, automaton, library, vocabulary) for state in automaton.states[1:]], letters
    )
    held = [choice.content for choice in states]
    new = [choice for choice in addable if choice.slots or choice.content not in held]
    taken = {choice.key for choice in states}
    return (*states, *(_keyed(choice, letters[_basis(choice.content)], taken) for choice in new))


def kept_in_place(choices: Sequence[Choice], before: Sequence[Choice]) -> tuple[Choice, ...]:
    """The same choices, as far as can be where they were *before*: nobody's click is to land on a neighbor.

    What has become a state stands where it was added from; what can be added once more, with other targets, goes to the end.
    What is a state no more, since its pick was undone, stands where the state was.
    """
    left, known = list(choices), {_named(choice) for choice in before}
    placed = []
    for old in before:
        found = _become_of(old, left, known)
        if found is not None:
            left.remove(found)
            placed.append(found)
    last = max((at + 1 for at, choice in enumerate(placed) if choice.state), default=0)
    states = [choice for choice in left if choice.state]
    return (*placed[:last], *states, *placed[last:], *(choice for choice in left if not choice.state))


def _become_of(old: Choice, choices: Sequence[Choice], known: Collection[tuple[str, str]]) -> Choice | None:
    """The choice that stands where *old* stood; None if it is gone.

    Args:
        known: What was there before, so that it stands where it did itself.
    """
    same = next((choice for choice in choices if _named(choice) == _named(old)), None)
    alike = [choice for choice in choices if _basis(choice.content) == _basis(old.content)]
    if not old.state:
        return next((choice for choice in alike if choice.state and _named(choice) not in known), same)
    return same or next((choice for choice in alike if not choice.state), None)


def _named(choice: Choice) -> tuple[str, str]:
    """What a choice is known by from one time to the next."""
    return choice.state, "" if choice.state else choice.name


def examples_by_label(examples: Iterable[Example]) -> Mapping[str, int]:
    """How many enabled examples lead to, or stay in, each state."""
    counts: dict[str, int] = {}
    for example in examples:
        if example.enabled:
            counts[example.label] = counts.get(example.label, 0) + 1
    return counts


def _addable(automaton: Automaton, library: Library, vocabulary: Vocabulary) -> list[Choice]:
    """Behaviors and flags that a state could hold: learned ones first, as they are what is composed.

    Of what a controller directs, too: its vocabulary begins with what agents do alone, and ends with what the level right
    below has learned.
    """
    circular = {automaton.id, *library.all_users(automaton.id)}
    learned = [a for a in library.automata.values() if a.id not in circular]
    own = [b for b in vocabulary.behaviors.values() if not b.derived]
    directed = [b for b in vocabulary.behaviors.values() if b.derived]
    flags = [flag for flag in known_flags(library, vocabulary) if flag != FINISHED]
    return [
        *(Choice(a.name, Nested(a.id), slots=a.parameters, doc=a.note) for a in learned),
        *(
            Choice(b.name, Basic(b.name), slots=b.parameters, raises=b.raises or "", doc=b.doc)
            for b in (*own, *reversed(directed))
        ),
        *(
            Choice(flag, RaiseFlag(flag), raises=flag, doc=f"raises the flag {flag} and begins anew")
            for flag in flags
        ),
    ]


def _of_state(state: State, automaton: Automaton, library: Library, vocabulary: Vocabulary) -> Choice:
    raises, doc = "", ""
    match state.content:
        case RaiseFlag(flag):
            raises = flag
        case Basic(name) if name in vocabulary.behaviors:
            raises, doc = vocabulary.behaviors[name].raises or "", vocabulary.behaviors[name].doc
        case Nested(held) if held in library.automata:
            doc = library.automata[held].note
    content_words = shown_content(state.content, library)
    told = content_words if not doc or content_words == state.name else f"{content_words}: {doc}"
    return Choice(state_words(automaton, state.id, library), state.content, state.id, raises=raises, doc=told)


def _with_keys(states: list[Choice], letters: Mapping[str, str]) -> list[Choice]:
    digits, taken, keyed = iter(DIGITS), set[str](), []
    for choice in states:
        letter = letters.get(_basis(choice.content), "")
        letter = "" if letter in taken else letter
        key = letter if letter and choice.raises else next(digits, "")
        keyed.append(_keyed(choice, key, taken))
        if letter and key != letter and not _has_slots(choice.content):
            keyed[-1] = replace(keyed[-1], also=letter)
            taken.add(letter)
    return keyed


def _has_slots(content: Content) -> bool:
    """Whether its letter adds another state, with other targets."""
    return isinstance(content, Basic | Nested) and bool(content.bindings)


def _keyed(choice: Choice, key: str, taken: set[str]) -> Choice:
    """*choice* with *key*, unless that is taken."""
    key = "" if key in taken else key
    taken.add(key)
    return replace(choice, key=key)


def _letters(addable: Iterable[Choice], reserved: Collection[str]) -> Mapping[str, str]:
    """A letter for each behavior: of its name, if one is free, or else any."""
    free = [letter for letter in LETTERS if letter not in reserved]
    letters = {}
    for choice in addable:
        own = next((letter for letter in choice.name.upper() if letter in free), "")
        letter = own or next(iter(free), "")
        letters[_basis(choice.content)] = letter
        if letter:
            free.remove(letter)
    return letters


def _basis(content: Content) -> str:
    """What is held, whatever it is bound to."""
    match content:
        case Basic(name):
            return f"basic {name}"
        case Nested(held):
            return f"automaton {held}"
        case RaiseFlag(flag):
            return f"flag {flag}"
    return "start"
