"""Compiles the kernel of one scenario: the program that `app.engine.compiling` starts.

Arguments: the name, module and file of the scenario, the physics of its worlds, and the folder to put the kernel into.
"""

import os
import sys
from pathlib import Path
from shutil import rmtree
from threading import Thread

from ..core.errors import UnderstudyError
from ..sim.physics import in_physics
from .children import step_back
from .scenarios import found_again


def main(name: str, module: str, path: str, physics: str, folder: str) -> None:
    """Compile; what numba refuses leaves the reason in the folder instead of a kernel."""
    Thread(target=_watch_parent, args=(folder,), daemon=True).start()
    step_back(5)
    from ..sim.kernel import ahead  # noqa: PLC0415 - the watch is to be on while numba is imported

    try:
        ahead.load(in_physics(found_again(name, module, path), physics), Path(folder))
    except UnderstudyError as error:
        sys.exit(str(error))


def _watch_parent(folder: str) -> None:
    """End, and leave nothing behind, once the program that started this one is gone."""
    # Not by way of sys.stdin: whoever reads holds its lock, also at the end of the program.
    while os.read(sys.stdin.fileno(), 1):
        pass
    rmtree(folder, ignore_errors=True)
    os._exit(1)


if __name__ == "__main__":
    main(*sys.argv[1:])
