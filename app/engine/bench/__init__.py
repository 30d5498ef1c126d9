"""How fast Understudy is on this machine: figures with goals, each measured by a plain function (`table` lists them).

Whatever else the machine does makes a figure worse and never better, so the least of several times counts; two things
that are compared take turns. Only work done is timed here: how it is shown, and how the program is called, comes in from
outside.
"""
