"""A set of words as overlapping sequences: which ones, together, cover exactly these words.

Each next sequence of a chain overlaps the one before, so all that they hand over is what they share: a
*joint*, a run of symbols at the end of one and the beginning of the other. A joint stands for one role only,
that is, one state of the set's automaton; other places where the same symbols stand lie inside sequences.
Symbols that stand in one place of a pattern are joints of their own. Others serve in one of their roles, or
together with those before them; or do not, and then there are no such sequences.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice, product

from layoutkit.constraints.covering import Covering, Piece
from layoutkit.constraints.language import DEAD, Language, TooManyStates, language

#: Longer runs are not tried as joints.
_LONGEST_JOINT = 4
#: Nor are more joints than these: many long ones are a sign that none of them helps.
_MOST_JOINTS = 60
#: Nor more choices of roles than these.
_MOST_CHOICES = 64
#: More sequences than these, or more symbols in all, are more than anyone would read.
_MOST_PIECES, _MOST_SYMBOLS = 4000, 20000

Run = tuple[str, ...]


class Inexpressible(ValueError):  # noqa: N818 - says what is the matter
    """No overlapping sequences were found that cover exactly the words of a set.

    Attributes
    ----------
    excess
        A word that is not in the set, though it looks like one wherever one looks; empty if there is none.
    """

    def __init__(self, excess: Run = ()) -> None:
        super().__init__(f"sequences would also admit {' '.join(excess)!r}" if excess else "")
        self.excess = excess


def chained(words: Language) -> tuple[Piece, ...]:
    """Return sequences that cover the words of a set, and no others.

    Few long ones where that saves more than one, else pairs of neighbours, which are easier to edit.

    Raises
    ------
    Inexpressible
        If none are found.
    TooManyStates
        If there are too many.
    """
    kinds = _Kinds(words)
    many = False
    for joints in _choices(kinds):
        try:
            drafts = _all_between(kinds, joints)
        except TooManyStates:
            many = True
            continue
        if drafts is not None and _exact(kinds, joints, drafts):
            return tuple(kinds.merged(_fewer(kinds, joints, drafts)))
    if many:
        raise TooManyStates(f"more than {_MOST_PIECES} sequences")
    raise Inexpressible(_excess(kinds))


@dataclass(frozen=True, slots=True)
class _Draft:
    """A sequence of kinds of symbols."""

    run: Run
    at_start: bool = False
    at_end: bool = False


@dataclass(frozen=True, slots=True)
class _Joint:
    """Where one sequence may go on behind another.

    Attributes
    ----------
    run
        What a sequence ends with.
    state
        The state of the set's automaton behind it.
    shared
        What the next one begins with: the run, or its last symbols.
    """

    run: Run
    state: int
    shared: Run


#: The beginning of all words, from which the first sequences go out.
_START = _Joint((), 0, ())
Joints = tuple[_Joint, ...]


class _Kinds:
    """A set of words over kinds of symbols, each kind for symbols that may always take each other's place.

    Attributes
    ----------
    words
        The set, over one symbol of each kind.
    members
        The symbols of each kind, by that one; symbols that no word has are left out.
    """

    def __init__(self, words: Language) -> None:
        columns: dict[tuple[int, ...], list[str]] = {}
        for column, letter in enumerate(words.letters):
            columns.setdefault(tuple(row[column] for row in words.following), []).append(letter)
        used = {column: letters for column, letters in columns.items() if set(column) != {DEAD}}
        self.members = {letters[0]: frozenset(letters) for letters in used.values()}
        following = tuple(zip(*used, strict=True)) if used else ((),)
        self.words = Language(tuple(self.members), following, words.accepting)

    def merged(self, drafts: Sequence[_Draft]) -> list[Piece]:
        """Return sequences of symbols; those that differ in one place only become one."""
        pieces = [Piece(tuple(self.members[k] for k in d.run), d.at_start, d.at_end) for d in drafts]
        count = len(pieces) + 1
        while len(pieces) < count:
            count = len(pieces)
            for place in range(max((len(p.sets) for p in pieces), default=0)):
                pieces = _merged_at(place, pieces)
        return pieces


def _merged_at(place: int, pieces: Sequence[Piece]) -> list[Piece]:
    """Unite sequences that differ in one place only."""
    together: dict[object, Piece] = {}
    for piece in pieces:
        key: object = piece
        if place < len(piece.sets):
            before, behind = piece.sets[:place], piece.sets[place + 1 :]
            key = before, behind, piece.at_start, piece.at_end
            if key in together:
                united = together[key].sets[place] | piece.sets[place]
                piece = replace(piece, sets=(*before, united, *behind))
        together[key] = piece
    return list(together.values())


def _choices(kinds: _Kinds) -> Iterator[Joints]:
    """Yield sets of joints to try: single symbols, then longer and longer runs.

    Of runs all, then no more than are needed. What begins with a whole run may also overlap in a part of it,
    and so go on where it should not; where that happens, sequences that share one symbol only may do.
    """
    yield _constant(kinds, 1)
    yield from islice(_roles(kinds), _MOST_CHOICES)
    for length in range(2, _LONGEST_JOINT + 1):
        every = _constant(kinds, length)
        if len(every) > _MOST_JOINTS:
            return
        for joints in (every, _needed(kinds, every), _needed(kinds, every[::-1])):
            yield joints
            yield tuple(replace(joint, shared=joint.run[-1:]) for joint in joints)


def _roles(kinds: _Kinds) -> Iterator[Joints]:
    """Yield choices of one role for each symbol; of several, those in which it may come again, or none."""
    words = kinds.words
    reachable = _reachable(words)
    roles: list[list[_Joint | None]] = []
    for column, kind in enumerate(words.letters):
        states = dict.fromkeys(row[column] for row in words.following if row[column] != DEAD)
        again = [s for s in states if any(words.following[t][column] == s for t in reachable[s])]
        joints = [_Joint((kind,), state, (kind,)) for state in (again if len(states) > 1 else states)]
        roles.append([*joints, None] if len(states) > 1 else [*joints])
    if any(len(some) > 1 for some in roles):
        for chosen in product(*roles):
            yield tuple(joint for joint in chosen if joint is not None)


def _reachable(words: Language) -> list[frozenset[int]]:
    """Return, for each state, those that some word leads to from it, itself included."""
    found = []
    for state in range(len(words.following)):
        seen, pending = {state}, [state]
        while pending:
            for after in words.following[pending.pop()]:
                if after != DEAD and after not in seen:
                    seen.add(after)
                    pending.append(after)
        found.append(frozenset(seen))
    return found


def _constant(kinds: _Kinds, longest: int) -> Joints:
    """Return the runs of up to a length that have one role only, so that all words go on alike behind them.

    A run that ends in a shorter one is left out.
    """
    words = kinds.words
    found: dict[Run, _Joint] = {}
    pending: list[tuple[Run, frozenset[int]]] = [((), frozenset(range(len(words.following))))]
    for run, before in pending:
        for column, kind in enumerate(words.letters):
            after = frozenset(words.following[state][column] for state in before) - {DEAD}
            longer = (*run, kind)
            if not after or any(longer[i:] in found for i in range(1, len(longer))):
                continue
            if len(after) == 1:
                found[longer] = _Joint(longer, min(after), longer)
            elif len(longer) < longest:
                pending.append((longer, after))
    return tuple(found.values())


def _between(kinds: _Kinds, joints: Joints) -> list[_Draft] | None:
    """Return the sequences from joint to joint; None if there is no end of them, or too many."""
    try:
        return _all_between(kinds, joints)
    except TooManyStates:
        return None


def _all_between(kinds: _Kinds, joints: Joints) -> list[_Draft] | None:
    """Return the sequences from joint to joint; None if there is no end of them.

    Raises
    ------
    TooManyStates
        If they are too many.
    """
    ends = frozenset((joint.run, joint.state) for joint in joints)
    found: list[_Draft] = []
    symbols = 0
    for joint in (_START, *joints):
        for draft in _from(kinds.words, joint, ends):
            if draft is None:
                return None
            found.append(draft)
            symbols += len(draft.run)
            if len(found) > _MOST_PIECES or symbols > _MOST_SYMBOLS:
                raise TooManyStates(f"more than {_MOST_PIECES} sequences")
    return found


def _from(words: Language, joint: _Joint, ends: frozenset[tuple[Run, int]]) -> Iterator[_Draft | None]:
    """Yield the sequences that begin with a joint, or at the start; None where there is no end of them.

    Parameters
    ----------
    ends
        Runs and states of the joints that they may end in.
    """
    longest = max((len(run) for run, _ in ends), default=1)
    at_start = joint is _START
    # Each with all of the joint's run, by whose symbols the next joint may be known.
    pending: list[tuple[Run, int, frozenset[tuple[int, Run]]]] = [(joint.run, joint.state, frozenset())]
    unshared = len(joint.run) - len(joint.shared)
    while pending:
        run, state, passed = pending.pop()
        if words.accepting[state]:
            yield _Draft(run[unshared:], at_start, at_end=True)
        for column in reversed(range(len(words.letters))):
            after = words.following[state][column]
            if after == DEAD:
                continue
            longer = (*run, words.letters[column])
            here = (after, longer[-longest:])
            if any((longer[-n:], after) in ends for n in range(1, min(longest, len(longer)) + 1)):
                yield _Draft(longer[unshared:], at_start)
            elif here in passed:
                yield None
                return
            else:
                pending.append((longer, after, passed | {here}))


def _exact(kinds: _Kinds, joints: Joints, drafts: Sequence[_Draft]) -> bool:
    """Tell whether sequences cover the set's words only.

    Where joints are single symbols that stand inside no sequence, these overlap in them and nowhere else.
    Others may overlap in other ways, too, so that one has to look.
    """
    single = {joint.run[0] for joint in joints if len(joint.run) == 1}
    if len(single) == len(joints) and all(single.isdisjoint(_inside(draft)) for draft in drafts):
        return True
    pieces = tuple(Piece(tuple(frozenset({k}) for k in d.run), d.at_start, d.at_end) for d in drafts)
    try:
        return language(Covering(pieces), kinds.words.letters) == kinds.words
    except TooManyStates:
        return False


def _inside(draft: _Draft) -> Run:
    first, last = 0 if draft.at_start else 1, len(draft.run) if draft.at_end else -1
    return draft.run[first:last]


def _needed(kinds: _Kinds, joints: Joints) -> Joints:
    """Leave out joints, in order, as long as there is an end of the sequences between those left."""
    left = joints
    for joint in joints:
        fewer = tuple(other for other in left if other != joint)
        if _between(kinds, fewer) is not None:
            left = fewer
    return left


def _fewer(kinds: _Kinds, joints: Joints, drafts: list[_Draft]) -> list[_Draft]:
    """Leave out joints, the last ones first, as long as fewer or shorter sequences come of it."""
    best, left = drafts, joints
    for joint in reversed(joints):
        fewer = tuple(other for other in left if other != joint)
        found = _between(kinds, fewer)
        if found is not None and _cost(found) < _cost(best) and _exact(kinds, fewer, found):
            best, left = found, fewer
    count, least = len(kinds.merged(drafts)), len(kinds.merged(best))
    return best if least < count - 1 or least == 1 else drafts


def _cost(drafts: Sequence[_Draft]) -> tuple[int, int]:
    return len(drafts), sum(len(draft.run) for draft in drafts)


class _Windows:
    """Accepts the words that look like those of a set through every window of so many symbols.

    Meets `layoutkit.constraints.word_rules.Automaton`; a state is the last symbols read, and whether they
    are all that is read.
    """

    def __init__(self, words: Language, length: int) -> None:
        self._words, self._length = words, length

    def start(self) -> tuple[Run, bool]:
        """Return that nothing is read."""
        return (), True

    def step(self, state: tuple[Run, bool], symbol: str) -> tuple[Run, bool] | None:
        """Return the last symbols, if some word of the set has them there."""
        run, whole = (*state[0], symbol), state[1]
        if not self._after(run, whole):
            return None
        return (run[1:], False) if len(run) >= self._length else (run, whole)

    def accepts(self, state: tuple[Run, bool]) -> bool:
        """Tell whether some word of the set ends so."""
        return any(self._words.accepting[after] for after in self._after(*state))

    def _after(self, run: Run, whole: bool) -> set[int]:
        before = (0,) if whole else range(len(self._words.following))
        return {self._words.after(run, state) for state in before} - {DEAD}


def _excess(kinds: _Kinds) -> Run:
    try:
        return language(_Windows(kinds.words, _LONGEST_JOINT), kinds.words.letters).without(kinds.words) or ()
    except TooManyStates:
        return ()
