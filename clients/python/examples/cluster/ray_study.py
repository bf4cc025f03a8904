"""A study on a cluster of Ray: ray job submit -- python ray_study.py"""

import functools
from collections.abc import Callable
from concurrent.futures import Executor, Future
from typing import Any

import numpy as np
import ray

import brinell

# A function goes to the cluster once.
remote = functools.cache(ray.remote)


class RayExecutor(Executor):
    """Tasks of one core each, in the processes that Ray keeps."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        return remote(fn).remote(*args, **kwargs).future()


def job(force: float) -> brinell.JobLike:
    ball = brinell.sphere(radius=5, material="52100")
    block = brinell.block(width=20, depth=10, material="S355")
    return brinell.job(ball, block, analysis="axisymmetric", force=force)


if __name__ == "__main__":
    ray.init()
    table = brinell.sweep(
        job, {"force": np.linspace(100, 2000, 1000)}, executor=RayExecutor(), study="study"
    )
    print(table[["force", "peak_pressure", "status"]])
