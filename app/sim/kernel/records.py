"""Where the columns of a kernel lie in memory: those that are read together lie together, as fields of records.

Compiled code then holds one address a record instead of one a column, of which there are more than a processor has
registers by far, and finds all that it asks of a state, a test, or a run in one cache line or two. Blocks begin on cache
lines of their own: worlds step on threads side by side, and a core that writes to a line takes it away from the others.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from ..program.tables import TABLE_COLUMNS, Column

#: Names of columns in the order of their fields.
Record = tuple[str, ...]

#: Bytes of a number.
WORD = 8
#: Words that are set apart from others: two cache lines, since processors fetch them in pairs.
_APART = 16
_DTYPES = {"f": np.dtype(np.float64), "i": np.dtype(np.int64)}


def records(columns: Iterable[str], together: Iterable[Record]) -> tuple[Record, ...]:
    """The records of *together*, and one of its own for each other column."""
    shared = {name: record for record in together for name in record}
    return tuple(dict.fromkeys(shared.get(name, (name,)) for name in columns))


#: Of a program's columns.
TABLE_RECORDS = records(
    TABLE_COLUMNS,
    (
        ("operation", "use", "low", "high", "yes", "no", "goal", "mask"),
        ("share", "running"),
        (
            "code",
            "sampling",
            "labels_at",
            "labels",
            "prunable",
            "content",
            "held",
            "bound",
            "bound_at",
            "trees",
        ),
        ("behavior", "once", "raises", "finishes", "derived", "arity"),
        ("source", "feature", "slots_at", "slots", "default", "flag", "statistic", "direct", "empty"),
        ("type", "parent", "first_member", "end_member", "children_at", "children_end"),
    ),
)


def stride(record: Record) -> int:
    """Words from one record to the next: a power of two, which is cheap to multiply by."""
    return 1 << (len(record) - 1).bit_length()


def laid_out(
    lengths: Mapping[str, int], letters: Mapping[str, str], shape: Iterable[Record]
) -> dict[str, Column]:
    """Columns of zeros, float64 ("f") or int64 ("i"); one entry at least, so that each has an address."""
    rows = {record: max(1, *(lengths[name] for name in record)) for record in shape}
    words = {record: -(-count * stride(record) // _APART) * _APART for record, count in rows.items()}
    block = np.zeros(sum(words.values()) + _APART, np.int64)
    at = -block.ctypes.data // WORD % _APART
    columns: dict[str, Column] = {}
    for record, count in rows.items():
        fields = block[at : at + count * stride(record)].reshape(count, stride(record))
        for k, name in enumerate(record):
            columns[name] = fields[:, k].view(_DTYPES[letters[name]])
        at += words[record]
    return {name: columns[name] for name in letters}


def packed(
    columns: Mapping[str, Column], letters: Mapping[str, str], shape: Iterable[Record]
) -> dict[str, Column]:
    """The same columns, laid out as records."""
    made = laid_out({name: len(columns[name]) for name in letters}, letters, shape)
    for name, column in made.items():
        column[: len(columns[name])] = columns[name]
    return made


def addresses(columns: Mapping[str, Column], shape: Iterable[Record]) -> list[int]:
    """Where each record begins: its first column."""
    return [columns[record[0]].ctypes.data for record in shape]


@dataclass(frozen=True, slots=True)
class Place:
    """Where in a block a number stands, or what it takes to find a column.

    Attributes:
        letter: "f" for float64 or "i" for int64.
        word: Of the block: the number, or the address of the column's record.
        offset: Of the column in its record, in words.
        stride: Words from one entry of the column to the next; 0 for a number.
    """

    letter: str
    word: int
    offset: int = 0
    stride: int = 0


def places(letters: Mapping[str, str], shape: Iterable[Record], first: int = 0) -> dict[str, Place]:
    """Where columns are found if the addresses of their records stand in a block from word *first* on."""
    return {
        name: Place(letters[name], word, offset, stride(record))
        for word, record in enumerate(shape, first)
        for offset, name in enumerate(record)
    }
