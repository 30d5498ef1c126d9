"""Figures that go into files: charts of experiments and pictures of runs, as pixels, SVG and PDF.

Values first (`figures`, `curves`), painting after; nothing here is a widget.
"""
