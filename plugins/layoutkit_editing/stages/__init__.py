"""The stages of editing: grids are found, proposals made, and sessions made again."""
