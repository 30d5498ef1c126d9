"""What the graph panel says below the graph, or in its place."""

NOTHING = "Choose a behavior in the library to see its states."
HINT = "Drop a behavior here to add a state. Drag from a state's handle to draw a transition. Right-click to prune."
LINKING = "Choose where the transition leads: a click, or arrow keys and Enter. Esc gives up."
EMPTY = "No states yet. Teach it, drop a behavior here, or use Add state in the context menu."
