"""Teaching: the panel with the behaviors as buttons, and what it takes to teach, test, ask and correct."""
