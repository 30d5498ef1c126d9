"""Moments as files: a canonical ``.npz`` each, named by a hash of its bytes.

The same moment always gives the same bytes, so the name of a file proves what is in it. Files hold an ``about.json`` and
one ``world/COLUMN.npy`` for each column (little-endian float64, int64, or uint64 where numbers need it); numpy's
``load`` reads them, and needs no pickle for it.
"""

import hashlib
import io
import json
import re
import struct
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from numbers import Integral

from ..errors import StorageError
from ..examples import Moment

#: Hexadecimal digits of a hash: enough that among a million moments no two meet by chance.
DIGITS = 16
ABOUT = "about.json"
FOLDER, ENDING = "world/", ".npy"

Numbers = tuple[float, ...] | tuple[int, ...]
#: numpy's name of a type -> Python's.
CODES = {"<f8": "d", "<i8": "q", "<u8": "Q"}
MAGIC = b"\x93NUMPY\x01\x00"
ALIGNMENT = 64
HEADER = re.compile(rb"\{'descr': '(<[fiu]8)', 'fortran_order': False, 'shape': \((\d+),\), \} *\n")
#: Every member of every file carries it: when a file was written must not change its bytes.
DATE = (1980, 1, 1, 0, 0, 0)
#: Readable and writable by the owner, readable by others, as unzip restores it.
PERMISSIONS = 0o644 << 16


def moment_hash(moment: Moment) -> str:
    """The name under which *moment* is stored, and by which examples refer to it.

    Raises:
        StorageError: It holds something that cannot be stored.
    """
    return hash_of(encoded(moment))


def hash_of(data: bytes) -> str:
    """The name of the file that holds *data*."""
    return hashlib.sha256(data).hexdigest()[:DIGITS]


# ------------------------------------------------------------------------------------------------------- writing


def encoded(moment: Moment) -> bytes:
    """The one file that holds *moment*.

    Raises:
        StorageError: A column or the machine holds something that cannot be stored.
    """
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_STORED) as archive:
        _add(archive, ABOUT, _about(moment))
        for name in sorted(moment.world):
            if not name.isidentifier():
                raise StorageError(f"a moment cannot be stored: a column cannot be called {name!r}")
            _add(archive, FOLDER + name + ENDING, _array(name, moment.world[name]))
    return file.getvalue()


def _add(archive: zipfile.ZipFile, name: str, data: bytes) -> None:
    member = zipfile.ZipInfo(name, DATE)
    member.external_attr = PERMISSIONS
    member.create_system = 3
    archive.writestr(member, data)


def _about(moment: Moment) -> bytes:
    about = {
        "scenario": moment.scenario,
        "parameters": dict(moment.parameters),
        "arm": moment.arm,
        "machine": dict(moment.machine),
    }
    try:
        return json.dumps(about, allow_nan=False, ensure_ascii=False, sort_keys=True).encode()
    except (TypeError, ValueError) as error:
        raise StorageError(
            f"a moment cannot be stored: its parameters and machine must be finite numbers, text, arrays and objects, "
            f"but: {error}"
        ) from error


def _array(name: str, column: Sequence[float] | Sequence[int]) -> bytes:
    try:
        kind = _kind(column)
        header = f"{{'descr': '{kind}', 'fortran_order': False, 'shape': ({len(column)},), }}".encode()
        padding = -(len(MAGIC) + 2 + len(header) + 1) % ALIGNMENT
        header += b" " * padding + b"\n"
        numbers = struct.pack(f"<{len(column)}{CODES[kind]}", *column)
    except (struct.error, TypeError, OverflowError) as error:
        raise StorageError(
            f"a moment cannot be stored: column {name!r} must hold float64, int64 or uint64 numbers, but: {error}"
        ) from error
    return MAGIC + struct.pack("<H", len(header)) + header + numbers


def _kind(column: Sequence[float] | Sequence[int]) -> str:
    types = set(map(type, column))
    if not types or not all(issubclass(number, Integral) for number in types):
        return "<f8"
    return "<u8" if max(column) >= 2**63 else "<i8"


# ------------------------------------------------------------------------------------------------------- reading


def decoded(data: bytes) -> Moment:
    """The moment that a file holds.

    Raises:
        StorageError: It is not one that `encoded` could have written.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            return _moment({member.filename: _stored(archive, member) for member in archive.infolist()})
    except (zipfile.BadZipFile, LookupError, TypeError, ValueError, struct.error, RuntimeError) as error:
        raise StorageError(f"it is no stored moment: {error}") from error


def _stored(archive: zipfile.ZipFile, member: zipfile.ZipInfo) -> bytes:
    if member.compress_type != zipfile.ZIP_STORED:
        raise ValueError(f"{member.filename!r} is compressed")
    return archive.read(member)


def _moment(members: Mapping[str, bytes]) -> Moment:
    about = json.loads(members[ABOUT])
    world = {
        name.removeprefix(FOLDER).removesuffix(ENDING): _numbers(data)
        for name, data in members.items()
        if name != ABOUT
    }
    return Moment(about["scenario"], about["parameters"], about["arm"], world, about["machine"])


def _numbers(data: bytes) -> Numbers:
    found = HEADER.fullmatch(data, len(MAGIC) + 2, data.index(b"\n") + 1) if data.startswith(MAGIC) else None
    if found is None:
        raise ValueError("a column is no one-dimensional array of float64, int64 or uint64")
    kind, length = found[1].decode(), int(found[2])
    return struct.unpack(f"<{length}{CODES[kind]}", data[found.end() :])


class Moments(Mapping[str, Moment]):
    """Moments by hash, made from their files' bytes when they are asked for; those bytes are known to be whole.

    A name is a hash of what it names, so two of these are equal when their names are.
    """

    def __init__(self, files: Mapping[str, bytes]) -> None:
        self._files = dict(files)
        self._made: dict[str, Moment] = {}

    def __getitem__(self, name: str) -> Moment:
        """The moment called *name*; `StorageError` if its file was written by something else than `encoded`."""
        if name not in self._made:
            try:
                self._made[name] = decoded(self._files[name])
            except StorageError as error:
                raise StorageError(f"examples/moments/{name}.npz: {error}") from error
        return self._made[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._files)

    def __len__(self) -> int:
        return len(self._files)

    def __contains__(self, name: object) -> bool:
        return name in self._files

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Moments):
            return self._files.keys() == other._files.keys()
        return super().__eq__(other)

    __hash__ = None  # type: ignore[assignment]  # like dict: equal ones may be of different kinds

    def __repr__(self) -> str:
        return f"Moments({', '.join(sorted(self._files))})"

    def file(self, name: str) -> bytes:
        """The bytes of the file that holds the moment called *name*."""
        return self._files[name]


def file_of(moments: Mapping[str, Moment], name: str) -> bytes:
    """The bytes of the file that is to hold the moment called *name*.

    Raises:
        StorageError: It cannot be stored, or *name* is not its hash.
    """
    if isinstance(moments, Moments):
        return moments.file(name)
    data = encoded(moments[name])
    if hash_of(data) != name:
        raise StorageError(f"the moment called {name!r} must be called by its hash, {hash_of(data)!r}")
    return data
