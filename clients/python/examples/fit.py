# %% [markdown]
# # A yield stress from a load-approach curve
#
# A press has measured the approach of two rollers under several forces. Which yield stress and
# hardening explain it? `brinell.identify` changes both, and the compliance of the press too
# if it is asked for. Each of its sweeps solves the jobs of a Jacobian side by side.

# %%
import matplotlib.pyplot as plt
import numpy as np

import brinell

client = brinell.Client()
forces = np.linspace(200, 2000, 10)


def contact(yield_stress: float, tangent_modulus: float) -> brinell.JobLike:
    """Two rollers, pressed together as the press did."""
    law = brinell.bilinear(yield_stress=yield_stress, tangent_modulus=tangent_modulus)
    steel = brinell.material(young_modulus=210000, poisson_ratio=0.3, plasticity=law)
    roller = brinell.cylinder(radius=20, material=steel)
    return brinell.job(
        roller, roller, analysis="plane_strain", forces=forces, elements_per_half_width=10
    )


# %% [markdown]
# The measurement is made up here: a known steel, and half a per cent of scatter.

# %%
scatter = np.random.default_rng(1).normal(1.0, 0.005, len(forces))
approaches = np.array([step.approach for step in client.solve(contact(430, 9000)).steps])
measured = np.column_stack([approaches * scatter, forces])

# %% [markdown]
# The job brings where to start from. A name is set in both bodies.

# %%
found = brinell.identify(
    measured,
    contact(300, 5000),
    free=["yield_stress", "tangent_modulus"],
    client=client,
    scatter="relative",
)
print(found)

# %% [markdown]
# How well does the curve determine them? The deviations say it, and the correlation: a higher
# yield stress with less hardening gives nearly the same curve.

# %%
print(f"correlation {found.correlation[0, 1]:.2f}, after {found.sweeps} sweeps")

# %%
fig, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
found.plot(left)
left.set_ylabel("force [N/mm]")
found.plot_residuals(right)
right.set_xlabel("force [N/mm]")
