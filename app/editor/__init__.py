"""Everything that draws: figures now, the studio's window later.

The only package that may import Qt and pyqtgraph. It knows `app.engine` and what is below; nothing below knows it.
"""
