"""Experiments: what is compared (`plan`), read from a file (`load`), run on threads (`runner`), kept (`store`), told (`report`).

An experiment is a value; its results are an SQLite file with one row a run, so that it can be stopped at any moment and
go on later. What a run gives depends on its settings and seed alone, never on when or beside what it ran.
"""
