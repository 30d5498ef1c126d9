"""The guided first lesson: a small card that says what to do next, points at it, and goes on when it was done."""
