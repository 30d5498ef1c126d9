"""The agents and their controllers, as a tree."""
