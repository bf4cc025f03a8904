"""A study over MPI: mpiexec -n 65 python -m mpi4py.futures mpi_study.py"""

import numpy as np
from mpi4py.futures import MPIPoolExecutor

import brinell


def job(force: float) -> brinell.JobLike:
    ball = brinell.sphere(radius=5, material="52100")
    block = brinell.block(width=20, depth=10, material="S355")
    return brinell.job(ball, block, analysis="axisymmetric", force=force)


if __name__ == "__main__":
    with MPIPoolExecutor() as executor:
        table = brinell.sweep(
            job, {"force": np.linspace(100, 2000, 1000)}, executor=executor, study="study"
        )
    print(table[["force", "peak_pressure", "status"]])
