"""Which names may become file and folder names.

A project travels by git between systems, so a name must be allowed on all of them.
"""

import unicodedata

#: Leaves room for an ending, and for the suffix of a file while it is written, within the usual 255 bytes.
LONGEST = 120
FORBIDDEN = '/\\:*?"<>|'
DEVICES = frozenset(
    ["con", "prn", "aux", "nul", *(f"com{n}" for n in range(1, 10)), *(f"lpt{n}" for n in range(1, 10))]
)
#: ``examples/moments`` holds snapshots, so no type's examples can be there.
MOMENTS = "moments"


def file_name_problem(name: str) -> str:
    """Why *name* cannot be the name of a file or folder; empty if it can."""
    if not name:
        return "it is empty"
    if bad := [character for character in name if character in FORBIDDEN or _invisible(character)]:
        return f"it holds {bad[0]!r}; {' '.join(FORBIDDEN)} and control characters are not allowed"
    if name.startswith(".") or name.endswith((".", " ")):
        return "it begins with a dot, or ends with a dot or a space"
    if name.split(".", maxsplit=1)[0].lower() in DEVICES:
        return "some systems keep it for a device"
    if len(name.encode()) > LONGEST:
        return f"it is longer than {LONGEST} bytes"
    return ""


def readable(name: str) -> str:
    """The *name* of a file as text that can be kept: bytes in it that are no text are marked, each as �."""
    return name.encode(errors="surrogateescape").decode(errors="replace")


def type_name_problem(name: str) -> str:
    """Why a node type cannot be called *name*; empty if it can."""
    if folded(name) == MOMENTS:
        return "the folder examples/moments is for snapshots"
    return file_name_problem(name)


def folded(name: str) -> str:
    """What *name* is on a file system that ignores case and the ways to write an accent."""
    return unicodedata.normalize("NFC", name).casefold()


def _invisible(character: str) -> bool:
    return unicodedata.category(character) in {"Cc", "Cs", "Zl", "Zp"}
