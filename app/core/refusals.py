"""What the operating system refuses, in words."""

import errno

_REASONS = {
    errno.EACCES: "permission denied",
    errno.EPERM: "permission denied",
    errno.EROFS: "the file system is read-only",
    errno.ENOSPC: "the disk is full",
    errno.EDQUOT: "the disk quota is used up",
    errno.ENAMETOOLONG: "the name is too long for this file system",
    errno.ENOTDIR: "a folder is expected, but a file is in its place",
    errno.EISDIR: "a file is expected, but a folder is in its place",
}


def reason(error: OSError) -> str:
    """Why the system refused."""
    return _REASONS.get(error.errno or 0) or error.strerror or type(error).__name__
