"""What the user set for the program as a whole, kept in a file of the user's configuration."""

from collections.abc import Mapping
from datetime import datetime
from pathlib import Path
from typing import Any

from PySide6.QtCore import QByteArray, QObject, QSettings, Signal

from ..core.storage import folder_is_there
from .theme import ThemeMode

#: Seconds between autosaves, and how many recent projects are remembered.
AUTOSAVE, MOST_RECENT = 30, 10
#: Sizes of text and controls that can be chosen, in percent.
SIZES = (100, 110, 125, 150, 175, 200)


class Settings(QObject):
    """Settings that survive the program.

    Signals:
        changed: One of them is another, by its name.
    """

    changed = Signal(str)

    def __init__(self, path: Path, state: Path | None = None) -> None:
        """Settings kept in the file *path*; one that does not exist means all defaults.

        Args:
            state: The folder for what is kept from one start to the next without being a setting, such as unsaved work;
                one beside the file if it is not given.
        """
        super().__init__()
        self.state = state or path.parent / "state"
        self._stored = QSettings(str(path), QSettings.Format.IniFormat)

    @property
    def theme(self) -> ThemeMode:
        """Light, dark, or as the system has it."""
        found = str(self._stored.value("theme", ThemeMode.SYSTEM))
        return ThemeMode(found) if found in set(ThemeMode) else ThemeMode.SYSTEM

    @theme.setter
    def theme(self, mode: ThemeMode) -> None:
        self._set("theme", str(mode))

    @property
    def size_percent(self) -> int:
        """How large text and controls are, 100 being as large as the system has it; from the next start on."""
        found = _whole(self._stored.value("size_percent"), 100)
        return min(max(found, SIZES[0]), SIZES[-1])

    @size_percent.setter
    def size_percent(self, percent: int) -> None:
        self._set("size_percent", percent)

    @property
    def autosave_seconds(self) -> int:
        """Seconds between autosaves; 0 never saves by itself."""
        return _whole(self._stored.value("autosave_seconds"), AUTOSAVE)

    @autosave_seconds.setter
    def autosave_seconds(self, seconds: int) -> None:
        self._set("autosave_seconds", seconds)

    @property
    def learns_by_itself(self) -> bool:
        """Whether edits of examples are learned from in the background."""
        return _whole(self._stored.value("learns_by_itself"), 1) != 0

    @learns_by_itself.setter
    def learns_by_itself(self, on: bool) -> None:
        self._set("learns_by_itself", int(on))

    @property
    def recent(self) -> tuple[Path, ...]:
        """Folders of projects opened before, the latest first."""
        found = self._stored.value("recent", [])
        return tuple(Path(str(path)) for path in (found if isinstance(found, list) else [found]) if path)

    @property
    def recent_times(self) -> Mapping[Path, str]:
        """When the recent projects were opened or saved last, in ISO form."""
        found = self._stored.value("recent_times", [])
        times = [str(time) for time in (found if isinstance(found, list) else [found])]
        return dict(zip(self.recent, times, strict=False))

    def remember(self, folder: Path) -> None:
        """Put a folder first among the recent ones."""
        times = self.recent_times
        now = datetime.now().astimezone().isoformat(timespec="seconds")
        self._keep_recent(
            [(folder, now), *((path, times.get(path, "")) for path in self.recent if path != folder)]
        )

    def forget(self, folder: Path) -> None:
        """Take a folder out of the recent ones."""
        times = self.recent_times
        self._keep_recent([(path, times.get(path, "")) for path in self.recent if path != folder])

    def _keep_recent(self, entries: list[tuple[Path, str]]) -> None:
        entries = entries[:MOST_RECENT]
        self._stored.setValue("recent_times", [time for _, time in entries])
        self._set("recent", [str(path) for path, _ in entries])

    @property
    def projects_folder(self) -> Path:
        """Where the user keeps projects."""
        found = str(self._stored.value("projects_folder", ""))
        return Path(found) if found and folder_is_there(Path(found)) else Path.home()

    @projects_folder.setter
    def projects_folder(self, folder: Path) -> None:
        self._set("projects_folder", str(folder))

    @property
    def keys(self) -> Mapping[str, str]:
        """Shortcuts that differ from the action's own, by the action's id; an empty one means none."""
        self._stored.beginGroup("keys")
        found = {name: str(self._stored.value(name)) for name in self._stored.allKeys()}
        self._stored.endGroup()
        return found

    def set_key(self, action: str, keys: str | None) -> None:
        """Give an action another shortcut; None gives it its own back."""
        if keys is None:
            self._stored.remove(f"keys/{action}")
            self.changed.emit("keys")
        else:
            self._set(f"keys/{action}", keys, "keys")

    def bytes_of(self, name: str) -> QByteArray:
        """A piece of state of the window; empty if it was never kept."""
        found = self._stored.value(f"window/{name}")
        return found if isinstance(found, QByteArray) else QByteArray()

    def keep(self, name: str, state: QByteArray) -> None:
        """Keep a piece of state of the window."""
        self._stored.setValue(f"window/{name}", state)

    def flag(self, name: str, *, default: bool = False) -> bool:
        """A switch by its name, such as whether a hint was dismissed."""
        return _whole(self._stored.value(f"flags/{name}"), int(default)) != 0

    def set_flag(self, name: str, *, on: bool) -> None:
        """Turn a switch."""
        self._set(f"flags/{name}", int(on), name)

    @property
    def lesson_step(self) -> int:
        """Where the guided first lesson was left."""
        return _whole(self._stored.value("lesson_step"), 0)

    @lesson_step.setter
    def lesson_step(self, step: int) -> None:
        self._set("lesson_step", step)

    def sync(self) -> None:
        """Write what has changed to the file now."""
        self._stored.sync()

    def _set(self, key: str, value: Any, name: str = "") -> None:
        self._stored.setValue(key, value)
        self.changed.emit(name or key)


def _whole(found: object, default: int) -> int:
    try:
        return int(str(found))
    except ValueError:
        return default
