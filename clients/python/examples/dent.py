# %% [markdown]
# # A dent and its residual stress
#
# A hard ball is pressed into a steel block and taken away. Flow theory follows the loads as a
# history and knows what is left.

# %%
import brinell

client = brinell.Client()
ball = brinell.cylinder(radius=5, material=brinell.rigid)
block = brinell.block(width=20, depth=10, material=brinell.steels["42CrMo4"])
job = brinell.job(
    ball,
    block,
    analysis="axisymmetric",
    theory="flow",
    history=[{"force": 2000}, {"force": 0}],
    fields=True,
)
result = client.solve(job, progress=True)
result

# %%
print(f"The dent is {1e3 * result.dent_depth:.1f} µm deep.")
result.plot.dent()

# %% [markdown]
# The loop of force over approach encloses the work that the dent has cost.

# %%
result.plot.load_approach()

# %% [markdown]
# Below the dent the steel stays under pressure, which is why shot peening works. The line over
# depth runs where the pressure was largest, and that is not the middle here: steel that has
# yielded carries most of the load nearer to the rim.

# %%
pressure = result.steps[0].pressure
pressure.x[pressure.pressure.argmax()]

# %%
result.plot.residual_stress()

# %%
result.plot.field("sigma_x")

# %% [markdown]
# The other way round: which force leaves a dent of 10 µm?

# %%
wanted = brinell.job(
    ball, block, analysis="axisymmetric", theory="flow", target={"dent_depth": 0.010}
)
found = client.solve(wanted)
print(f"{found.target['force']:.0f} N leave {1e3 * found.target['reached']:.2f} µm")
