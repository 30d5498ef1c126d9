"""What compiled code may expect of the processor."""

from typing import Any

import numba
from llvmlite import binding  # type: ignore[import-untyped] # it ships no types

#: Its stubs leave out most of the settings.
_settings: Any = numba.config

_WIDE = "avx512"


def avoid_wide_vectors() -> None:
    """Compile without AVX-512 unless the user has said what to compile for; to be called before anything is compiled.

    The loops of a world are a few dozen steps long. With vectors of eight numbers they take as long as with vectors of
    four, what is left over is more, and now and then, depending on where columns lie, a tick takes twice the time.
    """
    if _settings.CPU_NAME is None and _settings.CPU_FEATURES is None:
        features = binding.get_host_cpu_features()
        features.update({name: False for name in features if name.startswith(_WIDE)})
        _settings.CPU_FEATURES = features.flatten()
