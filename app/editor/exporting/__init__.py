"""Exporting an arm or a behavior into one file that runs without the project, and importing such a file."""
