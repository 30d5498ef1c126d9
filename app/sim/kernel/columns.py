# mypy: disable-error-code="no-untyped-call"
# numba's own types carry none.
"""Columns as compiled code sees them: bare pointers, read and written by index, without bounds or reference counts.

Arrays in a hot loop cost six times as much. The price: an index out of range is not noticed, and the
arrays must outlive the call. A world, a program and its runs are blocks: one address, from which the addresses of all
columns are read, so that a function that is called costs one argument a block and not one a column.
"""

import operator
from collections.abc import Mapping
from hashlib import sha256
from typing import Any

from llvmlite import ir  # type: ignore[import-untyped] # it ships no types
from numba import types
from numba.core.imputils import lower_builtin, lower_getattr_generic
from numba.core.typing.templates import (
    AbstractTemplate,
    AttributeTemplate,
    infer_getattr,
    infer_global,
    signature,
)
from numba.extending import intrinsic, models, register_model

from .records import WORD, Place

_WORD_TYPE = ir.IntType(8 * WORD)
_MACHINE_TYPES = {types.float64: ir.DoubleType(), types.int64: _WORD_TYPE}
_TYPES = {"f": types.float64, "i": types.int64}
#: What stands where in a block, by name; a mapping is a block within it.
Places = Mapping[str, "Place | Places"]


class ColumnType(types.Type):
    """A column of float64 or int64 whose entries lie *stride* words apart."""

    def __init__(self, dtype: Any, stride: int) -> None:
        self.dtype = dtype
        self.stride = stride
        super().__init__(name=f"Column({dtype}, {stride})")


@register_model(ColumnType)
class _ColumnModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: ColumnType) -> None:
        super().__init__(manager, kind, _MACHINE_TYPES[kind.dtype].as_pointer())


@infer_global(operator.getitem)
class _Get(AbstractTemplate):
    def generic(self, args: Any, _kws: Any) -> Any:
        if len(args) == 2 and isinstance(args[0], ColumnType) and isinstance(args[1], types.Integer):
            return signature(args[0].dtype, args[0], types.int64)
        return None


@infer_global(operator.setitem)
class _Set(AbstractTemplate):
    def generic(self, args: Any, _kws: Any) -> Any:
        if len(args) != 3 or not isinstance(args[0], ColumnType) or not isinstance(args[1], types.Integer):
            return None
        whole = isinstance(args[0].dtype, types.Integer)
        if whole and not isinstance(args[2], types.Integer | types.Boolean):
            return None  # a list would keep the fraction that a whole column cuts off
        return signature(types.none, args[0], types.int64, args[0].dtype)


@lower_builtin(operator.getitem, ColumnType, types.int64)
def _get(_context: Any, builder: Any, signature: Any, args: Any) -> Any:
    return builder.load(_entry(builder, signature.args[0], args))


@lower_builtin(operator.setitem, ColumnType, types.int64, types.Any)
def _set(context: Any, builder: Any, signature: Any, args: Any) -> Any:
    builder.store(args[2], _entry(builder, signature.args[0], args))
    return context.get_dummy_value()


def _entry(builder: Any, kind: ColumnType, args: Any) -> Any:
    """The address of an entry."""
    words = builder.mul(args[1], ir.Constant(_WORD_TYPE, kind.stride), flags=("nsw",))
    return builder.gep(args[0], [words], inbounds=True)


# ------------------------------------------------------------------------------------------------- blocks


class BlockType(types.Type):
    """The address of words, which say where columns begin, or are numbers."""

    def __init__(self, places: Places) -> None:
        self.places = places
        super().__init__(name=f"Block({sha256(repr(places).encode()).hexdigest()[:12]})")


@register_model(BlockType)
class _BlockModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: BlockType) -> None:
        super().__init__(manager, kind, _WORD_TYPE.as_pointer())


@infer_getattr
class _Attributes(AttributeTemplate):
    key = BlockType

    def generic_resolve(self, kind: Any, name: str) -> Any:  # type: ignore[override]  # the stub says "not implemented"
        place = kind.places.get(name)
        return None if place is None else _kind(place)


def _kind(place: "Place | Places") -> Any:
    if not isinstance(place, Place):
        return BlockType(place)
    dtype = _TYPES[place.letter]
    return ColumnType(dtype, place.stride) if place.stride else dtype


@lower_getattr_generic(BlockType)
def _attribute(_context: Any, builder: Any, kind: BlockType, block: Any, name: str) -> Any:
    place = kind.places[name]
    if not isinstance(place, Place):
        return block
    machine_type = _MACHINE_TYPES[_TYPES[place.letter]]
    at = builder.gep(block, [ir.Constant(_WORD_TYPE, place.word)], inbounds=True)
    if not place.stride:
        return _constant(builder, builder.bitcast(at, machine_type.as_pointer()))
    first = builder.inttoptr(_constant(builder, at), machine_type.as_pointer())
    return builder.gep(first, [ir.Constant(_WORD_TYPE, place.offset)], inbounds=True)


def _constant(builder: Any, at: Any) -> Any:
    """What stands in a block, which nobody writes to: reading it again is as good as keeping it."""
    found = builder.load(at)
    found.set_metadata("invariant.load", builder.module.add_metadata([]))
    return found


def block(places: Places) -> Any:
    """In compiled code: a function of an address that returns the block there."""
    kind = BlockType(places)

    def at(_context: Any, address: Any) -> Any:  # noqa: ARG001 - numba wants this signature
        def generate(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
            return builder.inttoptr(args[0], _WORD_TYPE.as_pointer())

        return kind(types.int64), generate

    return intrinsic(at)
