# %% [markdown]
# # Three hardness profiles
#
# A case-hardened roller on a block of the same steel: how deep does the case have to be? The
# yield stress follows the hardness over depth; `utilization` is von Mises stress over it.

# %%
import matplotlib.pyplot as plt
import pandas as pd

import brinell

client = brinell.Client()
cases = {"0.3 mm": 0.3, "0.6 mm": 0.6, "1.2 mm": 1.2}


def contact(case_depth: float) -> brinell.JobLike:
    """A roller of 10 mm radius at a Hertz pressure of 2700 MPa."""
    hardness = {"surface": 700, "core": 350, "case_depth": case_depth}
    law = brinell.bilinear(
        yield_stress=916, tangent_modulus=2100, over_depth={"hardness": hardness}
    )
    steel = brinell.material(young_modulus=210000, poisson_ratio=0.3, plasticity=law)
    roller = brinell.cylinder(radius=10, material=steel)
    block = brinell.block(width=40, depth=20, material=steel)
    return brinell.job(roller, block, analysis="plane_strain", force=2000)


results = {
    name: result
    for name, (_, result) in zip(
        cases, client.map(map(contact, cases.values()), ordered=True), strict=True
    )
}
pd.DataFrame(
    {
        name: {
            "peak pressure [MPa]": result.peak_pressure,
            "largest plastic strain": result.max_plastic_strain,
            "largest utilization": result.subsurface["utilization"].max(),
        }
        for name, result in results.items()
    }
).T

# %% [markdown]
# A thin case leaves the core to the stress below it: where a curve reaches 1, the steel yields.

# %%
fig, ax = plt.subplots(layout="constrained")
for name, result in results.items():
    result.plot.depth("utilization", body="lower", ax=ax)
    ax.lines[-1].set(label=f"case {name}", color=f"C{len(ax.lines) - 1}")
ax.axhline(1.0, color="0.7", linewidth=0.8)
ax.legend(frameon=False)
