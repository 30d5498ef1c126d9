"""Projects on disk as the window handles them: new, open, save, recent, autosave, recovery, two windows on one project."""
