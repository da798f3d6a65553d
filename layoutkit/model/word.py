"""Words of region sets: how sequences are written."""

from __future__ import annotations

import re
from dataclasses import dataclass

from layoutkit.model.selection import SYMBOL, RegionSet

#: The beginning and the end of a composite region, as a sequence may name them.
START, END = "⊢", "⊣"

_TOKEN = re.compile(rf"\s*(?:(?P<start>⊢|\|-)|(?P<end>⊣|-\|)|\{{(?P<set>[^{{}}]*)\}}|(?P<name>@?{SYMBOL}))")


@dataclass(frozen=True, slots=True)
class Word:
    """A list of region sets, with a leading ⊢ or a trailing ⊣ where it is tied to an end.

    Written ``⊢ E F {G I @Door}``: symbols of the region's direct children, ``@`` before a label, braces
    around a set. ``|-`` and ``-|`` may be typed for ⊢ and ⊣.
    """

    sets: tuple[RegionSet, ...]
    at_start: bool = False
    at_end: bool = False

    @classmethod
    def parse(cls, text: str) -> Word:
        """Read a word.

        Raises
        ------
        ValueError
            If the text is not of that form; the message says where.
        """
        word = cls.context(text)
        if not word.sets:
            raise ValueError(f"the sequence {text!r} names no region")
        return word

    @classmethod
    def context(cls, text: str) -> Word:
        """Read what stands beside a region: a word, or no more than the end of the encompassing region.

        Raises
        ------
        ValueError
            If the text is of neither form, or empty.
        """
        sets: list[RegionSet] = []
        at_start = at_end = False
        position, text = 0, text.strip()
        while position < len(text):
            token = _TOKEN.match(text, position)
            if token is None:
                raise ValueError(f"unexpected {text[position:].split()[0]!r} in the sequence {text!r}")
            if at_end or (token["start"] and (sets or at_start)):
                raise ValueError(f"⊢ stands first and ⊣ last in a sequence, which {text!r} does not keep")
            if token["start"]:
                at_start = True
            elif token["end"]:
                at_end = True
            elif token["set"] is not None:
                sets.append(RegionSet.union(token["set"].split()))
            else:
                sets.append(RegionSet.parse(token["name"]))
            position = token.end()
        if not (sets or at_start or at_end):
            raise ValueError(f"the sequence {text!r} names no region")
        return cls(tuple(sets), at_start, at_end)

    def __str__(self) -> str:
        parts = [START] if self.at_start else []
        parts += [f"{{{' '.join(s.terms())}}}" if len(s.terms()) > 1 else str(s) for s in self.sets]
        return " ".join([*parts, *([END] if self.at_end else [])])
