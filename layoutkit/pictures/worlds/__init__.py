"""Worlds as models for other programs: binary glTF and OBJ."""
