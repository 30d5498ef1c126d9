"""A project that cannot run is refused, for what concerns the arm that is to run."""

import re
from dataclasses import replace

import pytest

from app.core import edits
from app.core.check import check, refuse
from app.core.errors import (
    BindingError,
    EditError,
    ExampleError,
    HierarchyError,
    LibraryError,
    UnderstudyError,
)
from app.core.library import Library
from app.core.project import Arm, Demonstration, LevelTable, Project
from tests.samples import AGENT, automaton, nested, project, vocabulary
from tests.unit.core.problems import AGENTS, armed, with_example


def broken() -> Project:
    """The sample with an open binding in a behavior that only the first arm runs, and a second arm without its top."""
    opened = edits.bind_state(project(), AGENT, "forage", "approach", "target", None)
    return edits.add_arm(opened, Arm("nothing", AGENTS, "gone"))


def test_a_sound_project_is_not_refused() -> None:
    refuse(project(), vocabulary())
    warned = edits.add_automaton(project(), AGENT, "new")[0]
    assert check(warned, vocabulary())
    refuse(warned, vocabulary())


def test_one_error_is_raised_as_what_it_is() -> None:
    opened = edits.bind_state(project(), AGENT, "forage", "approach", "target", None)
    with pytest.raises(
        BindingError, match=r"libraries/agent/forage\.json: states\[2\].*'target' of goto is open"
    ):
        refuse(opened, vocabulary())
    with pytest.raises(LibraryError):
        refuse(armed(Arm("a", AGENTS, "gone")), vocabulary())
    with pytest.raises(HierarchyError):
        refuse(armed(Arm("a", LevelTable((0,), (AGENT,)), "forage")), vocabulary())
    with pytest.raises(ExampleError):
        refuse(with_example(weight=-1.0), vocabulary())


def test_several_errors_are_listed_together() -> None:
    with pytest.raises(UnderstudyError, match=re.compile("2 problems .*arms.3..top.*forage.json", re.DOTALL)):
        refuse(broken(), vocabulary())


def test_an_arm_is_refused_only_for_what_concerns_it() -> None:
    with pytest.raises(BindingError):
        refuse(broken(), vocabulary(), arm="independent")
    with pytest.raises(LibraryError, match="'gone'"):
        refuse(broken(), vocabulary(), arm="nothing")
    with pytest.raises(BindingError):  # its agents forage too, since their controllers direct them to
        refuse(broken(), vocabulary(), arm="two levels")
    wandering = edits.add_arm(broken(), Arm("w", AGENTS, "wander"))
    refuse(wandering, vocabulary(), arm="w")
    with pytest.raises(BindingError):
        refuse(wandering, vocabulary(), arm="w", taught=[(AGENT, "forage")])
    with pytest.raises(EditError, match="there is no arm 'x'"):
        refuse(project(), vocabulary(), arm="x")


def test_examples_and_demonstrations_do_not_keep_an_arm_from_running() -> None:
    changed = replace(
        with_example(weight=-1.0), demonstrations=(Demonstration("d", "x", "x", "x", 1, (), 1),)
    )
    refuse(changed, vocabulary(), arm="independent")
    with pytest.raises(UnderstudyError):
        refuse(changed, vocabulary())


def test_a_cycle_that_an_arm_would_run_into_refuses_it() -> None:
    looped = edits.add_automaton(project(), AGENT, "loop")[0]
    library = {**looped.library(AGENT).automata, "loop": automaton("loop", nested("again", "loop"))}
    looped = replace(looped, libraries={**looped.libraries, AGENT: Library(library)})
    refuse(looped, vocabulary(), arm="independent")
    looped = edits.add_arm(looped, Arm("l", AGENTS, "loop"))
    with pytest.raises(LibraryError, match="recursion is not permitted, but loop holds loop"):
        refuse(looped, vocabulary(), arm="l")


def test_many_errors_are_counted() -> None:
    arms = tuple(Arm(f"a{n}", AGENTS, "gone") for n in range(30))
    with pytest.raises(LibraryError, match="and 10 more; `understudy check` lists all"):
        refuse(replace(project(), arms=arms, demonstrations=()), vocabulary())
