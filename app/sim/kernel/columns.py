# mypy: disable-error-code="no-untyped-call"
"""Columns as compiled code sees them: bare pointers, read and written by index, without bounds or reference counts.

Arrays in a hot loop cost six times as much (DESIGN section 11). The price: an index out of range is not noticed, and the
arrays must outlive the call.
"""

import operator
from typing import Any

from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.core.imputils import lower_builtin
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import intrinsic, models, register_model

_MACHINE_TYPES = {types.float64: ir.DoubleType(), types.int64: ir.IntType(64)}


class ColumnType(types.Type):
    """A column of float64 or int64 whose entries lie *stride* words apart."""

    def __init__(self, dtype: Any, stride: int = 1) -> None:
        self.dtype = dtype
        self.stride = stride
        super().__init__(name=f"Column({dtype}, {stride})")


@register_model(ColumnType)
class _ColumnModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: ColumnType) -> None:
        super().__init__(manager, kind, _MACHINE_TYPES[kind.dtype].as_pointer())


@infer_global(operator.getitem)
class _Get(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:  # noqa: ARG002
        if len(args) == 2 and isinstance(args[0], ColumnType) and isinstance(args[1], types.Integer):
            return signature(args[0].dtype, args[0], types.int64)
        return None


@infer_global(operator.setitem)
class _Set(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:  # noqa: ARG002
        if len(args) != 3 or not isinstance(args[0], ColumnType) or not isinstance(args[1], types.Integer):
            return None
        whole = isinstance(args[0].dtype, types.Integer)
        if whole and not isinstance(args[2], types.Integer | types.Boolean):
            return None  # a list would keep the fraction that a whole column cuts off
        return signature(types.none, args[0], types.int64, args[0].dtype)


@lower_builtin(operator.getitem, ColumnType, types.int64)
def _get(_context: Any, builder: Any, signature: Any, args: Any) -> Any:
    return builder.load(_place(builder, signature.args[0], args))


@lower_builtin(operator.setitem, ColumnType, types.int64, types.Any)
def _set(context: Any, builder: Any, signature: Any, args: Any) -> Any:
    builder.store(args[2], _place(builder, signature.args[0], args))
    return context.get_dummy_value()


def _place(builder: Any, kind: ColumnType, args: Any) -> Any:
    """The address of an entry."""
    words = builder.mul(args[1], ir.Constant(ir.IntType(64), kind.stride), flags=("nsw",))
    return builder.gep(args[0], [words], inbounds=True)


def _maker(dtype: Any) -> Any:
    def column(_context: Any, address: Any, stride: Any) -> Any:  # noqa: ARG001 - numba wants this signature
        if not isinstance(stride, types.IntegerLiteral):
            return None
        kind = ColumnType(dtype, stride.literal_value)

        def generate(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
            return builder.inttoptr(args[0], _MACHINE_TYPES[dtype].as_pointer())

        return kind(types.int64, stride), generate

    return intrinsic(column)


#: In compiled code: the column at an address, with the words from one entry to the next, a constant.
column_f, column_i = _maker(types.float64), _maker(types.int64)
