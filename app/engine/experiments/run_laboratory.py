"""Carries out one experiment: the program that `app.engine.experiments.process` starts.

It is given an order on its standard input, then words to heed; on its standard output it tells how far it is. Once the
program that started it is gone it ends at once: a run is in the results in full or not at all.
"""

import os
import sys
from dataclasses import replace
from threading import Thread
from typing import IO

from ...core.errors import UnderstudyError
from ..children import step_back
from .laboratory import Laboratory, Look, Stage
from .order import Order, Told, Word, heard, tell

#: Seconds between two looks.
GLANCE = 0.1


def main() -> None:
    """Carry out what is ordered."""
    step_back(10)
    orders, looks = sys.stdin.buffer, _private_output()
    order: Order = heard(orders)
    try:
        laboratory = order.begin()
    except UnderstudyError as error:
        tell(looks, Told(Look(Stage.FAILED, notice=str(error))))
        return
    Thread(target=_heed, args=(orders, laboratory), daemon=True).start()
    _tell_until_over(looks, laboratory)
    os._exit(0)  # who listens would hold an ordinary end up


def _private_output() -> IO[bytes]:
    """Where looks go; what a scenario prints goes to the standard error instead."""
    looks = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    return looks


def _heed(orders: IO[bytes], laboratory: Laboratory) -> None:
    acts = {
        Word.PAUSE: laboratory.pause,
        Word.RESUME: laboratory.resume,
        Word.CANCEL: laboratory.cancel,
    }
    while True:
        try:
            word: Word = heard(orders)
        except (EOFError, OSError):
            os._exit(1)
        acts[word]()


def _tell_until_over(looks: IO[bytes], laboratory: Laboratory) -> None:
    told: Look | None = None
    rows = 0
    while told is None or not told.is_over:
        look = laboratory.newest
        if look is not told:
            new = tuple(laboratory.rows[rows:])
            tell(looks, replace(_shortened(look, told), rows=new))
            told, rows = look, rows + len(new)
        laboratory.wait(GLANCE)
    laboratory.close()


def _shortened(look: Look, before: Look | None) -> Told:
    """Without what was told before."""
    same = before is not None and look.found is before.found
    return Told(look.without_findings(), as_before=True) if same else Told(look)


if __name__ == "__main__":
    main()
