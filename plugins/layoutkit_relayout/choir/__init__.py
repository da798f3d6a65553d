"""Words of coupled floors, drawn together: their lines meet at the sizes of the input.

Where floors are coupled by alignments alone, hardly any two words drawn by themselves fit each other. At its
input size each letter has one width, so that a word's lines are known from its letters. All words are then
written at once, from left to right, always the one that is furthest behind: a letter may stand where it is in
line with, or apart from, whatever it overlaps. Where that leads nowhere is remembered. What comes out is a
proposal, which sizing stretches to the length that is asked for, or refuses; no proof rests on it.
"""

from layoutkit_relayout.choir.choir import Choir
from layoutkit_relayout.choir.voices import Voice, fixed

__all__ = ["Choir", "Voice", "fixed"]
