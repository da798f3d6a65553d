"""How fast large layout documents are checked, and in how much memory, beside xmllint.

    python -m benchmarks.validation [--megabytes 100] [--shapes again,different] [--folder DIR] [--json FILE]

Each document is checked in processes of their own: by `xmllint --schema`, which reads it into memory, by
`xmllint --stream --schema`, and by `layoutkit.documents.check`, which finds all that the schema does, and
also sizes that are missing or do not add up, and replicas of nothing. What it takes to hold a layout against
its facade is measured apart: the same document once more, naming a facade. The first line is what a process
takes to start, with a document of a few lines.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path

#: Those of `benchmarks.large`.
SHAPES = ("again", "written", "different", "line", "comments")

ROOT = Path(__file__).resolve().parents[1]
SCHEMA = ROOT / "schemas/layoutkit.xsd"
#: Checks the document that is named, with the kinds that are built in.
_CHECK = """
import sys
from layoutkit.constraints import BUILT_IN
from layoutkit.documents import check
found = check(sys.argv[1], {kind.kind: kind for kind in BUILT_IN})
print(*found[:3], sep="\\n")
sys.exit(bool(found))
"""
CONTENDERS = {
    "xmllint": ["xmllint", "--noout", "--schema", str(SCHEMA)],
    "xmllint --stream": ["xmllint", "--noout", "--stream", "--schema", str(SCHEMA)],
    "layoutkit": [sys.executable, "-c", _CHECK],
}


@dataclass(frozen=True)
class Run:
    """What a process took: seconds on the clock and of the processors, greatest memory."""

    contender: str
    shape: str
    megabytes: float
    seconds: float
    processor: float
    memory: float


def run(contender: str, shape: str, path: Path) -> Run:
    """Run a contender on a document, which it has to accept.

    Raises
    ------
    RuntimeError
        If it does not.
    """
    start = time.perf_counter()
    process = subprocess.Popen(
        [*CONTENDERS[contender], str(path)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, cwd=ROOT
    )
    assert process.stdout is not None
    with process.stdout as output:
        said = output.read().decode()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    seconds = time.perf_counter() - start
    if status:
        raise RuntimeError(f"{contender} does not accept {path}: {said[:1000]}")
    processor, memory = used.ru_utime + used.ru_stime, used.ru_maxrss / 1024
    return Run(contender, shape, path.stat().st_size / 1e6, seconds, processor, memory)


def runs(shapes: Sequence[str], megabytes: float, folder: Path) -> Iterator[Run]:
    """Yield the runs of all contenders on each shape, then of layouts that name a facade."""
    size = int(megabytes * 1e6)
    yield from _each("small", folder, size=1)
    for shape in shapes:
        yield from _each(shape, folder, size)
    path = folder / "named.xml"
    for share in (0.01, 0.1, 1.0):  # its time and memory grow with the number of regions
        _write(path, "written", int(share * size), "facade.xml")
        yield run("layoutkit", "written, with its facade", path)
    path.unlink()


def _each(shape: str, folder: Path, size: int) -> Iterator[Run]:
    path = folder / f"{shape}.xml"
    _write(path, shape if shape in SHAPES else "written", size)
    for contender in CONTENDERS:
        yield run(contender, shape, path)
    path.unlink()


def _write(path: Path, shape: str, size: int, facade: str = "") -> None:
    """Write a document in a process of its own: what a process needed counts for those that it starts."""
    command = [sys.executable, "-m", "benchmarks.large", shape, str(size), str(path.resolve())]
    subprocess.run([*command, *([facade] if facade else [])], cwd=ROOT, check=True)


def line(found: Run) -> str:
    """Return a row of the table."""
    return (
        f"| {found.shape} | {found.megabytes:.1f} MB | {found.contender} | {found.seconds:.2f} s "
        f"| {found.processor:.2f} s | {found.memory:.0f} MB |"
    )


@contextmanager
def _folder(given: Path | None) -> Iterator[Path]:
    if given is not None:
        given.mkdir(parents=True, exist_ok=True)
        yield given
        return
    with tempfile.TemporaryDirectory() as made:
        yield Path(made)


def main() -> None:
    parser = argparse.ArgumentParser(description="checks large layout documents, beside xmllint")
    parser.add_argument("--megabytes", type=float, default=100.0)
    parser.add_argument("--shapes", default=",".join(SHAPES))
    parser.add_argument("--folder", type=Path, help="where the documents are written for the time being")
    parser.add_argument("--json", type=Path, help="write all figures to this file")
    arguments = parser.parse_args()
    print("| shape | size | contender | time | processor | memory |\n|---|---|---|---|---|---|")
    found = []
    with _folder(arguments.folder) as folder:
        for one in runs(arguments.shapes.split(","), arguments.megabytes, folder):
            found.append(one)
            print(line(one), flush=True)
    for shape in arguments.shapes.split(","):
        times = {r.contender: r.seconds for r in found if r.shape == shape}
        print(f"{shape}: {times['layoutkit'] / times['xmllint']:.2f} times as long as xmllint", end=", ")
        print(f"{times['layoutkit'] / times['xmllint --stream']:.2f} as xmllint --stream")
    if arguments.json:
        arguments.json.write_text(json.dumps([asdict(one) for one in found], indent=1) + "\n")


if __name__ == "__main__":
    main()
