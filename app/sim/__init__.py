"""Worlds: scenarios, what agents sense and do in them, physics, and engines that step them.

May import `app.core` only; numba only in the kernel modules. No clock, no global random numbers, no Qt.
"""
