"""The compiled engine: one generated kernel for each scenario, which steps any program in it.

numba may be imported here and nowhere else.
"""

from .processor import avoid_wide_vectors

avoid_wide_vectors()

from .engine import KernelEngine  # noqa: E402 - numba looks at its settings when it first compiles

__all__ = ["KernelEngine"]
