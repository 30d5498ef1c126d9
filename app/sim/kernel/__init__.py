"""The compiled engine: one generated kernel for each scenario, which steps any program in it (DESIGN section 6).

numba may be imported here and nowhere else.
"""

from .engine import KernelEngine

__all__ = ["KernelEngine"]
