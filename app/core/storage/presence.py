"""Whether something is at a place. Where the system refuses to say, as on a drive that is gone, nothing is there."""

from pathlib import Path


def file_is_there(path: Path) -> bool:
    """Whether there is a file."""
    try:
        return path.is_file()
    except OSError:
        return False


def folder_is_there(path: Path) -> bool:
    """Whether there is a folder."""
    try:
        return path.is_dir()
    except OSError:
        return False
