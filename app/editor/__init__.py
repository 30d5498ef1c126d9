"""Everything Qt: the studio's window, and the figures that go into files.

The only package that may import Qt and pyqtgraph. It knows `app.engine` and what is below; nothing below knows it.

`studio` is what every part of the window is given: the `document` (the project with its history; one writer), the
`bridge` (the engine: commands in, snapshots out), the `selection`, the `actions`, the `theme` and the `settings`.
Each panel is a package of its own and knows the studio, never another panel.
"""
