"""What a user types to have this program do something in a terminal."""

from pathlib import Path
from shlex import join

#: What starts the program from a clone; where it was installed, there is none.
RUN = Path(__file__).resolve().parents[3] / "run"


def command(*words: str, run: Path = RUN) -> str:
    """A line that a shell takes as it is: this clone's own `run` with these words, or the program that was installed."""
    return join((str(run) if run.is_file() else "understudy", *words))
