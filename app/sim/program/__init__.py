"""Libraries and a forest lowered to flat, read-only arrays, which a kernel can step.

May import `app.core` and numpy; knows nothing of numba.
"""

from .lowering import lower
from .needs import Needs, needs_of
from .tables import Program

__all__ = ["Needs", "Program", "lower", "needs_of"]
