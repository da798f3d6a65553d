"""A city of houses by `layoutkit replay`: how long it takes, and what a hundred machines would take."""
