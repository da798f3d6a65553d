"""Pictures of scenes: polygons and placements, heat maps over them, and what speaks for each placement."""
