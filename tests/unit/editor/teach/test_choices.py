"""What can be picked while an automaton is taught, and with which keys."""

from app.core.automaton import Automaton, Basic, Nested, RaiseFlag, Start, State
from app.core.features import Ground
from app.core.library import Library
from app.core.vocabulary import DONE, BasicBehavior, Vocabulary
from app.editor.teach.choices import DIGITS, LETTERS, Choice, choices_of, kept_in_place

VOCABULARY = Vocabulary(
    behaviors={
        behavior.name: behavior
        for behavior in (BasicBehavior("Forward"), BasicBehavior("Stop", raises=DONE), BasicBehavior("Turn"))
    }
)


def made(
    automaton_id: str, *contents: Basic | Nested | RaiseFlag, parameters: tuple[str, ...] = ()
) -> Automaton:
    states = tuple(State(f"s{number}", content) for number, content in enumerate(contents))
    start = State("start", Start(), "Start")
    return Automaton(automaton_id, automaton_id.title(), parameters, (start, *states))


def choices(automaton: Automaton, *others: Automaton, reserved: tuple[str, ...] = ()) -> dict[str, Choice]:
    library = Library({a.id: a for a in (automaton, *others)})
    return {choice.name: choice for choice in choices_of(automaton, library, VOCABULARY, reserved)}


def test_states_come_first_and_have_digits() -> None:
    found = choices(made("walk", Basic("Forward"), Basic("Turn")))
    assert [(c.name, c.state, c.key) for c in list(found.values())[:2]] == [
        ("Forward", "s0", "1"),
        ("Turn", "s1", "2"),
    ]


def test_a_letter_stays_with_what_raises_a_flag_when_it_becomes_a_state() -> None:
    before, after = choices(made("walk")), choices(made("walk", Basic("Forward"), Basic("Stop")))
    assert before["Stop"].key == after["Stop"].key == "S"
    assert (before["Stop"].state, after["Stop"].state) == ("", "s1")


def test_the_letter_that_added_a_state_still_picks_it() -> None:
    before, after = choices(made("walk")), choices(made("walk", Basic("Forward"), Basic("Turn")))
    assert after["Forward"].also == before["Forward"].key
    assert after["Forward"].key == "1"
    taken = [key for choice in after.values() for key in (choice.key, choice.also) if key]
    assert len(taken) == len(set(taken))


def test_reserved_keys_are_left_alone_and_no_key_is_given_twice() -> None:
    found = choices(made("walk", Basic("Forward")), made("seek"), made("sweep"), reserved=("S", "T"))
    keys = [choice.key for choice in found.values() if choice.key]
    assert not {"S", "T"} & set(keys)
    assert len(keys) == len(set(keys))


def test_what_holds_the_automaton_cannot_become_its_state() -> None:
    inner, outer = made("inner"), made("outer", Nested("inner"))
    assert "Outer" not in choices(inner, outer)
    assert "Inner" in choices(outer, inner)


def test_a_behavior_with_a_slot_can_be_added_again_with_another_target() -> None:
    seek = made("seek", parameters=("X",))
    found = choices(made("walk", Nested("seek", {"X": Ground("box")}), Basic("Turn")), seek)
    assert found["Seek(box)"].state == "s0"
    assert found["Seek(box)"].also == ""  # its letter asks for another target
    assert found["Seek"].slots == ("X",)
    assert found["Turn"].state == "s1"


def test_more_behaviors_than_keys_leave_some_without_one() -> None:
    many = [made(f"b{number}") for number in range(len(LETTERS) + len(DIGITS))]
    keys = [choice.key for choice in choices(made("walk"), *many).values()]
    assert keys.count("") > 0
    assert len([key for key in keys if key]) == len(LETTERS)


def test_a_controller_is_offered_first_what_the_level_below_has_learned_last() -> None:
    directed = [BasicBehavior(name, derived=True) for name in ("Forward", "Forage", "Control")]
    vocabulary = Vocabulary(behaviors={behavior.name: behavior for behavior in directed})
    lead = made("lead")
    found = choices_of(lead, Library({"lead": lead}), vocabulary)
    assert [choice.name for choice in found][:3] == ["Control", "Forage", "Forward"]
    assert next(choice for choice in found if choice.name == "Forage").key == "F"


# ------------------------------------------------------------------------------------------ where they stand


def order(before: Automaton, *after: Automaton, others: tuple[Automaton, ...] = ()) -> list[list[str]]:
    """How choices stand at first, and after each change of the automaton that is taught."""
    placed: tuple[Choice, ...] = ()
    found = []
    for automaton in (before, *after):
        library = Library({a.id: a for a in (automaton, *others)})
        found_now = [c for c in choices_of(automaton, library, VOCABULARY) if c.kind != "flag"]
        placed = kept_in_place(found_now, placed)
        found.append([f"{choice.name}{'' if choice.state else '?'}" for choice in placed])
    return found


def test_at_first_states_stand_before_what_can_be_added() -> None:
    (first,) = order(made("walk", Basic("Turn")))
    assert first == ["Turn", "Forward?", "Stop?"]


def test_what_becomes_a_state_stays_where_it_was_and_so_does_all_else() -> None:
    first, second, third = order(
        made("walk"), made("walk", Basic("Turn")), made("walk", Basic("Turn"), Basic("Forward"))
    )
    assert first == ["Forward?", "Stop?", "Turn?"]
    assert second == ["Forward?", "Stop?", "Turn"]
    assert third == ["Forward", "Stop?", "Turn"]


def test_a_pick_that_is_undone_moves_nothing() -> None:
    assert (
        len(
            {
                tuple(name.strip("?") for name in names)
                for names in order(made("walk"), made("walk", Basic("Turn")), made("walk"))
            }
        )
        == 1
    )


def test_what_can_be_added_with_other_targets_goes_to_the_end_and_comes_back() -> None:
    goto = made("goto", parameters=("x",))
    bound = Nested("goto", {"x": Ground("deposit")})
    first, second, third = order(made("walk"), made("walk", bound), made("walk"), others=(goto,))
    assert first[0] == "Goto?"
    assert second == ["Goto(deposit)", *first[1:], "Goto?"]
    assert third == first
