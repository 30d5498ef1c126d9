"""Moments are stored once, by a name that proves what is in them."""

import io
import math
import pickle
import zipfile
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from app.core.errors import StorageError
from app.core.examples import Moment
from app.core.storage import moment_hash
from app.core.storage.moments import Moments, decoded, encoded, file_of, hash_of
from tests.unit.core.storage import every_kind

MOMENT = every_kind.moment(12)


def world(**columns: Any) -> Moment:
    return replace(MOMENT, world=columns)


def test_a_moment_comes_back_with_its_kinds_of_number() -> None:
    back = decoded(encoded(MOMENT))
    assert back == MOMENT
    assert [type(number) for column in ("x", "weight", "clock") for number in back.world[column]] == [
        *(float, float, float),
        *(int, int),
        *(int, int, int, int),
    ]
    assert math.copysign(1.0, back.world["x"][1]) == -1.0


def test_the_name_of_a_moment_is_for_ever() -> None:
    """It stands in the users' files, so neither a new Python nor a new machine may change it."""
    assert moment_hash(MOMENT) == "3cc5552dc50bf6f4"
    assert moment_hash(replace(MOMENT)) == moment_hash(MOMENT)


@pytest.mark.parametrize(
    "other",
    [
        replace(MOMENT, arm="two levels"),
        replace(MOMENT, scenario="another"),
        replace(MOMENT, parameters={**MOMENT.parameters, "boxes": 1.0}),
        replace(MOMENT, machine={**MOMENT.machine, "now": 13}),
        replace(MOMENT, world={**MOMENT.world, "x": (1.0, 0.0, 1e-300)}),
        replace(MOMENT, world={"x": MOMENT.world["x"]}),
    ],
)
def test_any_difference_gives_another_name(other: Moment) -> None:
    assert moment_hash(other) != moment_hash(MOMENT)


def test_the_order_in_which_things_were_put_in_does_not_matter() -> None:
    turned = replace(
        MOMENT,
        world=dict(sorted(MOMENT.world.items(), reverse=True)),
        parameters=dict(sorted(MOMENT.parameters.items(), reverse=True)),
    )
    assert encoded(turned) == encoded(MOMENT)


def test_arrays_give_the_same_file_as_tuples() -> None:
    arrays: Any = {
        "x": np.array(MOMENT.world["x"]),
        "weight": np.array(MOMENT.world["weight"]),
        "clock": np.array(MOMENT.world["clock"], dtype=np.uint64),
        "none": np.array([]),
    }
    assert encoded(replace(MOMENT, world=arrays)) == encoded(MOMENT)


def test_numpy_reads_the_file_without_pickle() -> None:
    with np.load(io.BytesIO(encoded(MOMENT)), allow_pickle=False) as file:
        read = {name: file[f"world/{name}"] for name in MOMENT.world}
        assert b'"scenario": "sample"' in file["about.json"]
    assert {name: array.dtype.str for name, array in read.items()} == {
        "x": "<f8",
        "weight": "<i8",
        "clock": "<u8",
        "none": "<f8",
    }
    assert {name: tuple(array.tolist()) for name, array in read.items()} == dict(MOMENT.world)


def test_infinite_columns_can_be_kept() -> None:
    assert decoded(encoded(world(deadline=(math.inf, -math.inf)))).world["deadline"] == (math.inf, -math.inf)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        (world(x=("far",)), "column 'x' must hold float64, int64 or uint64 numbers, but"),
        (world(x=(2**64,)), "column 'x' must hold float64, int64 or uint64 numbers, but"),
        (world(x=(2**63, -1)), "column 'x' must hold float64, int64 or uint64 numbers, but"),
        (world(x=(0.5, 10**400)), "column 'x' must hold float64, int64 or uint64 numbers, but"),
        (world(**{"../x": (1.0,)}), "a column cannot be called '../x'"),
        (replace(MOMENT, machine={"now": math.nan}), "must be finite numbers"),
        (replace(MOMENT, machine={"now": {1, 2}}), "must be finite numbers, text, arrays and objects, but"),
    ],
)
def test_what_cannot_be_stored_is_refused(wrong: Moment, message: str) -> None:
    with pytest.raises(StorageError, match="a moment cannot be stored") as caught:
        moment_hash(wrong)
    assert message in str(caught.value)


def packed(*, compressed: bool = False, **members: bytes) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED if compressed else zipfile.ZIP_STORED) as archive:
        for name, data in members.items():
            archive.writestr(name.replace("_", "."), data)
    return file.getvalue()


def npy(values: object) -> bytes:
    file = io.BytesIO()
    np.save(file, np.array(values))
    return file.getvalue()


ABOUT = b'{"arm": "", "machine": {}, "parameters": {}, "scenario": ""}'
STRANGE = {
    "no archive": b"PK and then nothing",
    "nothing": b"",
    "no about.json": packed(x_npy=npy([1.0])),
    "about.json is no JSON": packed(about_json=b"{"),
    "about.json is no object": packed(about_json=b"[]"),
    "about.json is not UTF-8": packed(about_json=b"\xff"),
    "about.json is nested too deeply": packed(about_json=b"[" * 100_000),
    "about.json lacks a key": packed(about_json=b"{}"),
    "a column of text": packed(about_json=ABOUT, x_npy=npy(["a"])),
    "a table": packed(about_json=ABOUT, x_npy=npy([[1.0]])),
    "a column that claims to be longer": packed(about_json=ABOUT, x_npy=npy([1.0]).replace(b"(1,)", b"(9,)")),
    "a column that holds objects": packed(about_json=ABOUT, x_npy=npy([1.0]).replace(b"'<f8'", b"'|O' ")),
    "compressed": packed(about_json=ABOUT, compressed=True),
}


@pytest.mark.parametrize("case", STRANGE)
def test_files_that_something_else_wrote_are_refused_when_they_are_needed(case: str) -> None:
    data = STRANGE[case]
    stored = Moments({hash_of(data): data})
    with pytest.raises(StorageError, match=f"examples/moments/{hash_of(data)}.npz: it is no stored moment"):
        stored[hash_of(data)]


def test_a_pickle_is_never_opened() -> None:
    class Trap:
        def __reduce__(self) -> tuple[object, ...]:
            return pytest.fail, ("a pickle was opened",)

    trap = io.BytesIO()
    np.save(trap, np.array([Trap()], dtype=object), allow_pickle=True)
    with pytest.raises(StorageError):
        decoded(packed(about_json=ABOUT, x_npy=trap.getvalue()))
    assert b"Trap" in pickle.dumps(Trap.__name__)


def test_moments_are_made_when_they_are_asked_for_and_once() -> None:
    name, broken = moment_hash(MOMENT), b"broken"
    stored = Moments({name: encoded(MOMENT), hash_of(broken): broken})
    assert len(stored) == 2
    assert name in stored
    assert set(stored) == {name, hash_of(broken)}
    assert stored[name] is stored[name]
    assert "none" not in stored
    with pytest.raises(KeyError):
        stored["none"]


def test_stored_moments_equal_those_they_were_made_from() -> None:
    name = moment_hash(MOMENT)
    stored = Moments({name: encoded(MOMENT)})
    assert stored == {name: MOMENT}
    assert {name: MOMENT} == stored
    assert stored == Moments({name: encoded(MOMENT)})
    assert stored != Moments({})
    assert stored != {name: every_kind.moment(13)}
    assert repr(stored) == f"Moments({name})"


def test_a_stored_moment_is_written_again_without_being_made() -> None:
    broken = b"whatever it is"
    assert file_of(Moments({hash_of(broken): broken}), hash_of(broken)) == broken
