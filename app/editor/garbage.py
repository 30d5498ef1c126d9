"""Garbage is looked for in the window's thread alone: what is thrown away may be Qt's, which no other thread may end.

Python looks for it in whatever thread happens to make an object too many. A dialog that is part of a cycle would be ended by
the engine's thread, and the program with it.
"""

import gc

from PySide6.QtCore import QObject, QTimer

#: Looking through all objects stops every thread, for a tenth of a second in a large world, and reference counts free nearly
#: everything anyway: young objects are looked through after so many, those a little older every so often, old ones never.
YOUNG, OFTEN = 2_000, 5
#: Milliseconds between two looks at how many there are.
EVERY = 50


class Garbage(QObject):
    """Looks for garbage from now on, in the thread that makes it, in the place of Python."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        gc.disable()
        self._timer = QTimer(self, interval=EVERY)
        self._timer.timeout.connect(collect_due)
        self._timer.start()


def collect_due() -> None:
    """Look through young objects, if there are enough of them."""
    young, middle, _ = gc.get_count()
    if young > YOUNG:
        gc.collect(1 if middle > OFTEN else 0)
