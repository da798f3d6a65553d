"""Where the files that come with the program are: in a checkout, or in an installed wheel."""

from __future__ import annotations

from pathlib import Path

_PACKAGE = Path(__file__).parent


def shipped(folder: str) -> Path:
    """Return a folder that comes with the program: ``schemas`` or ``facades``.

    A wheel has it inside the package; a checkout, and an editable install, has it beside the package.

    Raises
    ------
    FileNotFoundError
        If it is in neither place: the installation is incomplete.
    """
    for place in (_PACKAGE / "_shipped" / folder, _PACKAGE.parent / folder):
        if place.is_dir():
            return place
    raise FileNotFoundError(f"the folder {folder!r} did not come with this installation of layoutkit")
