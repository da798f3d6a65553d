"""What kind of file a skin's picture is, by its first bytes."""

from __future__ import annotations


def media_type(data: bytes) -> str:
    """Return the media type of a picture.

    Raises
    ------
    ValueError
        If it is neither PNG nor JPEG, which is all that worlds have.
    """
    if data.startswith(b"\x89PNG\r\n\x1a\n"):
        return "image/png"
    if data.startswith(b"\xff\xd8\xff"):
        return "image/jpeg"
    raise ValueError("a skin's picture is neither PNG nor JPEG")


def suffix(data: bytes) -> str:
    """Return how the name of a picture's file ends."""
    return {"image/png": ".png", "image/jpeg": ".jpg"}[media_type(data)]
