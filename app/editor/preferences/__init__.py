"""Preferences: looks, autosave, learning, and the keys of all actions; what is changed holds at once."""
