"""Measures small jobs a second: `solve` in a loop, `map` of a client, and executors.

python clients/python/scripts/jobs_per_second.py JOBS PROCESSES...

A line has the way, the processes, the rate, and the rate over that of loops of `solve` in as many
processes; BRINELL_PROGRAM names the program. The last lines are of a study of 100 000 results.
"""

import os
import sys
import tempfile
import time
from collections.abc import Callable, Iterable
from concurrent.futures import Executor, ProcessPoolExecutor
from multiprocessing import get_context
from typing import Any

import brinell
from brinell._records import Files, Records, digest_of

STUDY = 100_000


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
        check(client.map(map(small, range(count))), count)


def by_executor(make: Callable[[int], Executor]) -> Callable[[int, int], None]:
    def run(count: int, processes: int) -> None:
        with make(processes) as executor:
            check(brinell.map(map(small, range(count)), executor=executor), count)

    return run


def check(pairs: Iterable[tuple[Any, brinell.Result]], count: int) -> None:
    assert sum(result.converged for _, result in pairs) == count


def pool(processes: int) -> Executor:
    return ProcessPoolExecutor(processes, mp_context=get_context("spawn"))


def by_dask(count: int, processes: int) -> None:
    from distributed import Client, LocalCluster

    options = {"threads_per_worker": 1, "host": "127.0.0.1", "dashboard_address": None}
    with LocalCluster(n_workers=processes, **options) as cluster, Client(cluster) as dask:
        check(brinell.map(map(small, range(count)), executor=dask.get_executor()), count)


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
    ways = {"map of a client": by_client, "processes": by_executor(pool), "dask": by_dask}
    for number in processes:
        rates = {}
        for way, run in {"loops of solve": loops, **ways}.items():
            start = time.perf_counter()
            run(count, number)
            rates[way] = count / (time.perf_counter() - start)
            ratio = rates[way] / rates["loops of solve"]
            load = os.getloadavg()[0]
            print(f"{way}, {number}: {rates[way]:.1f}/s, {ratio:.2f}; load {load:.1f}", flush=True)
    study()


if __name__ == "__main__":
    main()
