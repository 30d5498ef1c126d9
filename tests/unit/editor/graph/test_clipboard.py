"""States in the clipboard outlive neither the program nor its end."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[4]
COPY = """
from PySide6.QtGui import QGuiApplication
from app.editor.graph.clipboard import CopiedStates, put, there
application = QGuiApplication(["copy", "-platform", "offscreen"])
assert there() is None
copied = CopiedStates("mine", "agent", "forage", ("wander",))
put(copied, "Wander")
assert there() == copied
"""


def test_a_program_that_has_copied_states_ends_well() -> None:
    ended = subprocess.run(
        [sys.executable, "-c", COPY], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert (ended.returncode, ended.stderr) == (0, "")
