"""At first sight: whether it is plain, before any word is chosen, that a search finds nothing."""

from __future__ import annotations

import numpy as np

from layoutkit_relayout.search.outlook import Outlook
from layoutkit_relayout.search.search import Search


def refuted(search: Search) -> bool:
    """Tell whether no layout can be, by the sizes that regions can have and the words that fit into them.

    That is proved, and costs no more than a table for each group of regions that every layout reaches. Where
    words have to be tried, or sizes found, it is not told.
    """
    model, candidates = search.model, search.candidates
    outlook = Outlook(model, search.size, {})
    groups = dict.fromkeys(model.group_of[path] for path in outlook.undecided)
    asked = {group: outlook.question(group) for group in groups}
    possible = outlook.counted() and outlook.agreed() and None not in asked.values()
    possible = possible and not any(
        question is not None and candidates.fitting(group, question, question.members[:1], np.inf).empty
        for group, question in asked.items()
    )
    return not possible and model.exact and candidates.exact
