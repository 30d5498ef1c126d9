"""The main window: docks around the canvas, menus, tool bar, status bar, messages. It knows all panels, by a table."""
