"""``python -m understudy``, and ``python -m app`` from a clone."""

import sys

from .cli import main

if __name__ == "__main__":  # worker processes import this module, too
    sys.exit(main())
