"""The live picture of the world: agents, boxes, groups, trails; looking, selecting and dragging."""
