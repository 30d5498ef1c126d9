"""What is wrong with the project, and what can be done about it."""
