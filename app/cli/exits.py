"""What the program ends with."""

DONE = 0
#: The work ran, and something in it fell short.
FELL_SHORT = 1
#: The input was wrong; nothing was changed.
WRONG_INPUT = 2
#: The user stopped it; what was done until then is kept.
INTERRUPTED = 130
