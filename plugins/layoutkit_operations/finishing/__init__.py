"""Finishing: sites become worlds, and the facades on surfaces become part of their solids' meshes."""
