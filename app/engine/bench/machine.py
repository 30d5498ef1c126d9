"""What figures were measured on."""

import os
import platform
from collections.abc import Mapping
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

#: Packages whose versions matter for speed.
PACKAGES = ("numba", "numpy", "pymunk")
#: With more processes than this waiting for each core, figures are worse than the machine.
BUSY = 0.5


def machine(cores: int) -> Mapping[str, str | int | float]:
    """The machine, and what it runs, in words and numbers."""
    return {
        "processor": _processor(),
        "cores": cores,
        "load": round(load(), 2),
        "system": f"{platform.system()} {platform.machine()}",
        "python": platform.python_version(),
        **{name: _version(name) for name in PACKAGES},
    }


def load() -> float:
    """How many processes wanted a core in the last minute; 0 where the system does not say."""
    return os.getloadavg()[0] if hasattr(os, "getloadavg") else 0.0


def is_busy(cores: int) -> bool:
    """Whether other programs make figures worse."""
    return load() > BUSY * cores


def _processor() -> str:
    """The processor's name, as Linux or Python know it."""
    known = Path("/proc/cpuinfo")
    if known.exists():
        for line in known.read_text(encoding="utf-8", errors="replace").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or "unknown"


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "none"
