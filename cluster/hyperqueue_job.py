#!/usr/bin/env python3
"""A study as a job of HyperQueue, on machines that share a folder.

    hq server start &
    hq worker start &            # on each machine, or by hq alloc
    python cluster/hyperqueue_job.py STUDY.toml FOLDER --parts 64

submits one task for each part of the shards and waits for them. Needs the package ``hyperqueue``
(PyPI). ``--local N`` starts a server and a worker of N cores on this machine instead. A part that was
ended goes on where it was when it is submitted again.
"""

import argparse
import os
import subprocess
import sys

from hyperqueue import Client, Job, LocalCluster
from hyperqueue.cluster import WorkerConfig


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("study", help="the study, a TOML file")
    parser.add_argument("folder", help="folder of the results, seen by all machines")
    parser.add_argument("--parts", type=int, required=True, help="tasks, each some of the shards")
    parser.add_argument("--program", default="slideline", help="path of slideline on the machines")
    parser.add_argument("--local", type=int, metavar="N", help="a cluster of N cores on this machine")
    return parser.parse_args()


def job(asked):
    """One task a part: the shards k with k mod parts = its number."""
    made = Job(max_fails=0)
    sweep = [asked.program, "sweep", os.path.abspath(asked.study), "--out", os.path.abspath(asked.folder), "--quiet"]
    for part in range(asked.parts):
        made.program([*sweep, "--shard", f"{part}/{asked.parts}"], name=f"part {part}")
    return made


def run(client, asked):
    client.wait_for_jobs([client.submit(job(asked))])


def main():
    asked = arguments()
    if asked.parts < 1:
        sys.exit("--parts is at least 1")
    if asked.local:
        with LocalCluster() as cluster:
            cluster.start_worker(WorkerConfig(cores=asked.local))
            run(cluster.client(), asked)
    else:
        run(Client(), asked)
    join = [asked.program, "sweep", asked.study, "--out", asked.folder, "--csv", "--quiet"]
    sys.exit(subprocess.run(join, check=False).returncode)


if __name__ == "__main__":
    main()
