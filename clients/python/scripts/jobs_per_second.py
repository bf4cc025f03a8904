"""Measures small jobs a second: `solve` in a loop, `map` of a client, and executors.

python clients/python/scripts/jobs_per_second.py JOBS PROCESSES...
python clients/python/scripts/jobs_per_second.py study

The rows of the table have the way, the processes, the jobs, the rate, and the rate over that of
loops of `solve` in as many processes. The client's `map` solves all jobs, the other ways half of
them. What client and server take after 500 jobs and at the end stands below.
BRINELL_PROGRAM names the program. `study` opens one of 100 000 results.
"""

import os
import re
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import AbstractContextManager, contextmanager
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import brinell
from brinell._records import Files, Records, digest_of

STUDY = 100_000
# Jobs after which caches and pools have their size.
WARM = 500


def small(number: int) -> Any:
    """A job of milliseconds, another for each number."""
    law = {"law": "bilinear", "yield_stress": 500 + 0.01 * number, "tangent_modulus": 2000}
    steel = {"young_modulus": 210000, "poisson_ratio": 0.3, "plasticity": law}
    body = {"shape": {"type": "cylinder", "radius": 20}, "material": steel}
    return {
        "analysis": "plane_strain",
        "upper": body,
        "lower": body,
        "load": {"force": 612.6},
        "mesh": {"elements_per_half_width": 5},
    }


def loop(numbers: Iterable[int]) -> None:
    with brinell.Client(workers=1) as client:
        for number in numbers:
            assert client.solve(small(number)).converged


def loops(count: int, processes: int) -> None:
    with pool(processes) as executor:
        list(executor.map(loop, [range(k, count, processes) for k in range(processes)]))


def by_client(count: int, processes: int) -> None:
    with brinell.Client(workers=processes) as client:
        assert client._server is not None
        pids = {"client": os.getpid(), "server": client._server.pid}
        for number, (_, result) in enumerate(client.map(map(small, range(count))), 1):
            assert result.converged
            if number in (WARM, count):
                sizes = [f"{name} {resident(pid)} MiB" for name, pid in pids.items()]
                print(f"after {number} jobs:", *sizes, file=sys.stderr, flush=True)


def resident(pid: int) -> int:
    """The memory of a process [MiB]."""
    (size,) = re.findall(r"VmRSS:\s+(\d+) kB", Path(f"/proc/{pid}/status").read_text())
    return int(size) >> 10


def by_executor(
    make: Callable[[int], AbstractContextManager[Executor]],
) -> Callable[[int, int], None]:
    def run(count: int, processes: int) -> None:
        with make(processes) as executor:
            check(brinell.map(map(small, range(count)), executor=executor), count)

    return run


def check(pairs: Iterable[tuple[Any, brinell.Result]], count: int) -> None:
    assert sum(result.converged for _, result in pairs) == count


def pool(processes: int) -> Executor:
    return ProcessPoolExecutor(processes, mp_context=get_context("spawn"))


@contextmanager
def dask(processes: int) -> Iterator[Executor]:
    from distributed import Client, LocalCluster

    options = {"threads_per_worker": 1, "host": "127.0.0.1", "dashboard_address": None}
    with LocalCluster(n_workers=processes, **options) as cluster, Client(cluster) as client:
        yield client.get_executor()


def empty(count: int, processes: int) -> None:
    with dask(processes) as executor:
        list(executor.map(abs, range(count)))


def study() -> None:
    """Opens a study of many results, made of one."""
    with tempfile.TemporaryDirectory() as folder, brinell.Client() as client:
        list(client.map([small(0)], study=folder))
        files = Files(folder, make=False)
        (name,) = files.results()
        lines = files.read(name)
        version = name.split("-", 1)[1]
        for number in range(1, STUDY):
            with open(f"{folder}/{digest_of(number)}-{version}", "wb") as file:
                file.write(lines)
        start = time.perf_counter()
        opened = brinell.open_study(folder)
        print(f"open_study of {len(opened)} results: {time.perf_counter() - start:.2f} s")
        start = time.perf_counter()
        Records(folder, "0")
        print(f"to go on with it: {time.perf_counter() - start:.2f} s")
        start = time.perf_counter()
        rows = len(opened.table)
        print(f"its table of {rows} rows: {time.perf_counter() - start:.1f} s")


def main() -> None:
    count, *processes = map(int, sys.argv[1:])
    others = {"`ProcessPoolExecutor`": by_executor(pool), "Dask": by_executor(dask)}
    ways = {"loops of `solve`": loops, "`client.map`": by_client, **others}
    ways["Dask, empty tasks"] = empty
    print("| way | processes | jobs | jobs/s | over loops | load |\n|---|--:|--:|--:|--:|--:|")
    for number in processes:
        rates: list[float] = []
        for way, run in ways.items():
            jobs = count if run is by_client else count // 2
            start = time.perf_counter()
            run(jobs, number)
            rates.append(jobs / (time.perf_counter() - start))
            row = f"{rates[-1]:.1f} | {rates[-1] / rates[0]:.2f} | {os.getloadavg()[0]:.1f}"
            print(f"| {way} | {number} | {jobs} | {row} |", flush=True)


if __name__ == "__main__":
    study() if sys.argv[1:] == ["study"] else main()
