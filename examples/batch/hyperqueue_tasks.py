# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens thousands of models as tasks of HyperQueue, on this computer or on a cluster (pip install hyperqueue):

python hyperqueue_tasks.py TASKS [--server DIR] IN... --out DIR [options of python -m wirewarp batch]

TASKS is the number of tasks that share the models. Use several tasks for each core, so that all cores finish at about
the same time. --server is the folder of a running server, whose workers may be jobs of Slurm or PBS. Without --server,
this program starts a server and a worker. Like batch, this program prints the lines of all models, and ends with the
exit code of the worst model.
"""

import argparse
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from hyperqueue import Client, Job, LocalCluster
from hyperqueue.cluster import WorkerConfig

BATCH = (sys.executable, "-m", "wirewarp", "batch")
TRIES = 3  # a task fails after it has lost this number of workers; until then, another worker continues the task


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tasks", type=int, metavar="TASKS")
    parser.add_argument("--server", type=Path, metavar="DIR")
    given, words = parser.parse_known_args()
    job = Job(name="wirewarp", default_workdir=Path.cwd(), max_fails=None)
    for part in range(1, given.tasks + 1):
        one = (*BATCH, *words, "--jobs", "1", "--part", f"{part}/{given.tasks}")
        job.program(one, stdout=None, stderr=None, crash_limit=TRIES)
    with connected(given.server) as client:
        # If a model is not ready to cut, its task fails. The other tasks continue.
        client.wait_for_jobs([client.submit(job)], raise_on_error=False)
    # print the lines of all models, and flatten refused, stopped and lost models again
    return subprocess.call([*BATCH, *words])


@contextmanager
def connected(server: Path | None) -> Iterator[Client]:
    if server:
        yield Client(server)
        return
    with LocalCluster() as cluster:
        cluster.start_worker(WorkerConfig())
        yield cluster.client()


if __name__ == "__main__":
    sys.exit(main())
