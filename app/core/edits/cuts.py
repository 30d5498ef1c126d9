"""Edits of cuts that the user moves, see `app.core.cuts`."""

from ..automaton import Automaton, Cut
from ..conditions import Equals, Guard, Test
from ..cuts import same_place, stands, with_cuts
from ..errors import EditError
from ..naming import next_number
from ..project import Project
from ..tree import Tree
from .place import change, find_automaton, find_index, replaced
from .rules import refuse_guard
from .states import refuse_states
from .words import says


@says("Move a cut of state {state_id} of {automaton_id}")
def move_cut(
    project: Project, type_name: str, automaton_id: str, state_id: str, guard: Guard, test: Test
) -> tuple[Project, str]:
    """Let a test of a state's tree have these numbers, now and after learning; also returns the cut's id.

    Args:
        guard: The tests on the way to it, as they come out there.

    Raises:
        EditError: The state has no tree, or its tree does not test that feature there in that way.
    """
    automaton = find_automaton(project, type_name, automaton_id)
    refuse_states(automaton, [state_id])
    before = [c for c in automaton.cuts if c.source == state_id and same_place(c.guard, guard)]
    number = before[0].id if before else str(next_number(c.id for c in automaton.cuts))
    cut = Cut(number, state_id, guard, test)
    tree = automaton.learned.get(state_id)
    _refuse(automaton, cut, tree)
    assert isinstance(tree, Tree)
    cuts = tuple(cut if c.id == number else c for c in automaton.cuts)
    learned = {**automaton.learned, state_id: with_cuts(tree, [cut])}
    cuts = cuts if before else (*cuts, cut)
    return change(project, type_name, automaton_id, cuts=cuts, learned=learned), number


@says("Take back cut {cut_id} of {automaton_id}")
def remove_cut(project: Project, type_name: str, automaton_id: str, cut_id: str) -> Project:
    """No such cut any more; learning puts the test back where the examples want it."""
    automaton = find_automaton(project, type_name, automaton_id)
    index = find_index([cut.id for cut in automaton.cuts], cut_id, "cut", automaton.name)
    return change(project, type_name, automaton_id, cuts=replaced(automaton.cuts, index))


def _refuse(automaton: Automaton, cut: Cut, tree: object) -> None:
    refuse_guard(automaton, cut.guard)
    if isinstance(cut.test, Equals):
        raise EditError("a test for one value has no cut that could be moved")
    if not isinstance(tree, Tree):
        raise EditError(f"state {cut.source!r} of {automaton.name} has no tree, so it has no cut to move")
    if not stands(tree, cut):
        raise EditError(
            f"the tree of state {cut.source!r} of {automaton.name} does not test {cut.test.feature!r} there any more"
        )
