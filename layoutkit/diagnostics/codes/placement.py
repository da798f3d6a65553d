"""Placement by example: shapes that go nowhere, and why (LK864 to LK877)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code
from layoutkit.diagnostics.diagnostic import Severity

CODES = (
    Code(
        "LK864",
        "shape that goes nowhere",
        "No place that was found is like the shape's own to the degree that is asked for; or shapes would "
        "overlap there what the shape does not overlap, or other shapes. So it is of shapes that are carried "
        "over: about no corner, or where there is no room.",
        "Surroundings that have little in common, or rooms that are full.",
        "Lower the threshold, or allow overlaps, as the hint says.",
        severity=Severity.NOTE,
    ),
    Code(
        "LK865",
        "propagation that makes no sense",
        "There is no shape to propagate, it has no size, or a setting is of no use as it stands.",
        "A misspelt name or label, a number out of its range, an array with one end, or one with a tiny "
        "spacing.",
        "Do as the hint says.",
    ),
    Code(
        "LK866",
        "shape beside nothing",
        "No polygon is near enough to the shape to be related to it, so no place is like its own.",
        "A scene of only the shapes that are to be propagated, or a shape far outside.",
        "Propagate a shape that stands in a polygon, or beside one.",
        severity=Severity.WARNING,
    ),
    Code(
        "LK867",
        "no polygon like that around a shape",
        "A shape goes to polygons with the labels of the one that it stands in, and the scene has none.",
        "Rooms that are labelled by one name here and by another there, or not at all.",
        "Label alike what is alike in both scenes.",
        severity=Severity.WARNING,
    ),
    Code(
        "LK868",
        "array without an end",
        "An array runs along one polygon. No place that was found for its last shape is nearest to the same "
        "polygon as one for its first.",
        "A first and a last shape that stand beside different polygons.",
        "Choose a first and a last shape beside one polygon, or lower the threshold.",
        severity=Severity.WARNING,
    ),
    Code(
        "LK869",
        "no polygon to carry by",
        "Local coordinates are those of the polygon that shapes stand in, and they stand in none.",
        "A scene without rooms, or a shape outside of all.",
        "Propagate it by relationships.",
        severity=Severity.WARNING,
    ),
    Code(
        "LK871",
        "no examples",
        "There is nothing to learn from, or it is not clear what.",
        "A misspelt label; scenes whose placements have several labels, or none.",
        "Do as the hint says.",
    ),
    Code(
        "LK872",
        "setting of learning that makes no sense",
        "A number is out of its range, or a relationship function is not known or needs a direction.",
        "A misspelt name; a tolerance of 0.",
        "Do as the hint says.",
    ),
    Code(
        "LK873",
        "example beside nothing",
        "Nothing stands near enough to an example to be related to it, so nothing is learned from it.",
        "A shape far outside of everything.",
        "Show shapes that stand in a polygon, or beside one.",
        severity=Severity.WARNING,
    ),
    Code(
        "LK874",
        "examples in other units",
        "The examples and the scene are in different units; sizes are taken as they stand.",
        "Examples from a photo in pixels, a scene in metres.",
        "Scale one of them, if sizes are to agree.",
        severity=Severity.WARNING,
    ),
    Code(
        "LK875",
        "nothing placed",
        "No place in the scene is enough like those of the examples.",
        "Labels that are called otherwise; a threshold that is too high.",
        "Do as the hint says.",
        severity=Severity.WARNING,
    ),
    Code(
        "LK876",
        "area looked at coarsely",
        "An area is so large for the shape that the points that are looked at are far apart.",
        "A park for a bench; a polygon about a whole town.",
        "Cut it into smaller polygons, or raise the tolerance.",
        severity=Severity.WARNING,
    ),
    Code(
        "LK877",
        "shapes larger than every placement",
        "Placements are to be filled with shapes of one size, and that is larger than each of them. None is "
        "filled: they stand as they were found.",
        "A size in other units.",
        "Choose a smaller size, or leave it away.",
        severity=Severity.NOTE,
    ),
)
