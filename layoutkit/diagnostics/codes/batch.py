"""Batches: many tasks into one folder (LK89)."""

from __future__ import annotations

from layoutkit.diagnostics.codes.code import Code

CODES = (
    Code(
        "LK890",
        "results of another run",
        "The folder holds results of a run with other inputs or options, or by other releases of libraries.",
        "An option was changed between two runs into one folder.",
        "Name another folder with -o, or begin anew with --afresh.",
    ),
    Code(
        "LK891",
        "folder in use",
        "Another run is writing into the folder just now.",
        "The same command was started twice.",
        "Wait until the other run ends, or name another folder with -o.",
    ),
    Code(
        "LK892",
        "task that workers died of",
        "Several processes ended in the midst of the same task, which is not tried again.",
        "The task needs more memory than there is, and the system ended the process.",
        "Try fewer workers at a time, or a smaller task.",
    ),
    Code(
        "LK893",
        "no cluster",
        "No scheduler answers, it has no workers, or it is gone; or Dask is not installed.",
        "A misspelt address, or a scheduler that is not started yet.",
        "Start `dask scheduler` and `dask worker`, or use --scheduler local; the same command goes on.",
    ),
    Code(
        "LK894",
        "workers with other releases",
        "A worker has another release of layoutkit, of a plugin or of a library: its bytes may be others.",
        "Machines were not updated together.",
        "Install the same releases everywhere.",
    ),
    Code(
        "LK895",
        "processes that end at once",
        "Worker processes end before they have begun.",
        "The system has no room for another process, or Python cannot start there.",
        "Run without --workers to see what is wrong.",
    ),
    Code(
        "LK896",
        "input that changed",
        "An input is no longer what it was when the run began: results would be of two kinds.",
        "A document or photo was edited in the meantime.",
        "Run the command again, into another folder or with --afresh.",
    ),
)
