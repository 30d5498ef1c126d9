"""What the selected node does and why."""
