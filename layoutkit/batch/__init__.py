"""Batches: many tasks into one folder, by one process or many machines, and the same bytes whichever way.

A `Plan` is a list of tasks. A task's work is a pure function: the bytes and plain data that it needs go in,
files as bytes come out. So a task can be done anywhere (`runners`, `processes`, `cluster`), again if a worker
dies, and in any order. Only `carry_out` writes, and a journal in the folder says what is done: a run that is
killed goes on from there.

>>> plan = Plan("replay", tasks, options={"seed": 3})
>>> report = carry_out(plan, folder, Processes(4))
"""

from layoutkit.batch.engine import Report, Watching, carry_out
from layoutkit.batch.plan import Plan
from layoutkit.batch.runners import InProcess, Runner
from layoutkit.batch.task import Finished, Reread, Shared, Source, Task, failed

__all__ = [
    "Finished",
    "InProcess",
    "Plan",
    "Report",
    "Reread",
    "Runner",
    "Shared",
    "Source",
    "Task",
    "Watching",
    "carry_out",
    "failed",
]
