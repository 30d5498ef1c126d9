"""How fast the studio is on this machine: figures that need a window, measured in a process of their own, off screen.

``python -m app.editor.bench GROUP...`` prints the figures of each group as JSON; `understudy bench` calls it and knows
their goals. What is measured is the real window on the real engine, acted on as a user acts.
"""
