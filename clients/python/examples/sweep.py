# %% [markdown]
# # A sweep in pandas
#
# How much of Hertz's pressure is left, for forces and yield stresses. `sweep` solves the job at
# every point of a grid and answers with a table.

# %%
import matplotlib.pyplot as plt
import numpy as np

import brinell

client = brinell.Client()


def contact(force: float, yield_stress: float) -> brinell.JobLike:
    """Two equal rollers of a steel that hardens a little."""
    law = brinell.bilinear(yield_stress=yield_stress, tangent_modulus=2100)
    steel = brinell.material(young_modulus=210000, poisson_ratio=0.3, plasticity=law)
    roller = brinell.cylinder(radius=20, material=steel)
    return brinell.job(roller, roller, analysis="plane_strain", force=force)


table = client.sweep(
    contact, {"force": np.linspace(100, 600, 11), "yield_stress": [300, 400, 500]}
)
table[
    ["force", "yield_stress", "peak_pressure", "hertz_peak_pressure", "max_plastic_strain"]
].head()

# %%
table["ratio"] = table["peak_pressure"] / table["hertz_peak_pressure"]
ax = table.pivot(index="force", columns="yield_stress", values="ratio").plot(marker="o")
ax.set(xlabel="force [N/mm]", ylabel="peak pressure / Hertz's")

# %% [markdown]
# Over the yield stress, the three curves are nearly one: plane strain begins to yield at 1.79
# times it.

# %%
fig, ax = plt.subplots(layout="constrained")
for yield_stress, group in table.groupby("yield_stress"):
    ax.plot(
        group["hertz_peak_pressure"] / yield_stress,
        group["ratio"],
        "o-",
        label=f"{yield_stress:.0f} MPa",
    )
ax.axvline(1.79, color="0.7", linewidth=0.8)
ax.set(xlabel="Hertz's peak pressure / yield stress", ylabel="peak pressure / Hertz's")
ax.legend(title="yield stress", frameon=False)

# %% [markdown]
# A sweep over a dict sets values by JSON pointer; a tuple of pointers gets the same value at
# each.

# %%
both = ("/upper/shape/radius", "/lower/shape/radius")
client.sweep(contact(300, 400), {both: [10, 20, 40]})[[both[0], "peak_pressure", "half_width"]]
