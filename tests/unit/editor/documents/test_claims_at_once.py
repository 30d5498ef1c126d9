"""Windows that open the same project at the same moment, whatever lock they find: one of them has it."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from pathlib import Path
from threading import Barrier

import pytest

from app.editor.documents.claims import Owner, claim, holder_of, new_owner, release
from app.editor.documents.private import NAME

WINDOWS, ROUNDS = 4, 20


def at_once(do: Callable[[Owner], Owner | None], owners: list[Owner]) -> list[Owner | None]:
    """What each of them gets when all begin together."""
    barrier = Barrier(len(owners))

    def begin(owner: Owner) -> Owner | None:
        barrier.wait()
        return do(owner)

    with ThreadPoolExecutor(len(owners)) as pool:
        return list(pool.map(begin, owners))


@pytest.mark.parametrize("left", [None, "", "gone"])
def test_of_all_that_claim_a_project_at_once_one_has_it_and_the_others_hear_who(
    tmp_path: Path, left: str | None
) -> None:
    for number in range(ROUNDS):
        folder = tmp_path / str(number) / NAME
        if left == "gone":
            claim(folder, replace(new_owner(), started="1"))
        elif left is not None:
            folder.mkdir(parents=True)
            (folder / "lock").write_text(left)
        owners = [new_owner() for _ in range(WINDOWS)]
        found = at_once(partial(claim, folder), owners)
        (winner,) = [owner for owner, other in zip(owners, found, strict=True) if other is None]
        assert holder_of(folder) == winner
        assert [other for other in found if other is not None] == [winner] * (WINDOWS - 1)


def test_a_project_that_is_given_free_while_another_claims_it_is_never_without_the_one_that_has_it(
    tmp_path: Path,
) -> None:
    folder = tmp_path / NAME

    def come_and_go(owner: Owner) -> None:
        for _ in range(ROUNDS):
            if claim(folder, owner) is None:
                assert holder_of(folder) == owner
                release(folder, owner)

    at_once(come_and_go, [new_owner() for _ in range(WINDOWS)])
    assert not folder.exists()


def test_giving_free_what_is_gone_brings_nothing_back(tmp_path: Path) -> None:
    release(tmp_path / "gone" / NAME, new_owner())
    assert list(tmp_path.iterdir()) == []
