# %% [markdown]
# # First contact
#
# Two steel rollers are pressed together until they yield. Figures are in mm, N and MPa; the
# force of a long roller is per millimetre of its length.

# %%
import brinell

client = brinell.Client()
roller = brinell.cylinder(radius=20, material=brinell.steels["S355"])
result = client.solve(brinell.job(roller, roller, analysis="plane_strain", force=500))
result

# %% [markdown]
# The elastic pressure of Hertz stands beside it. The error bars say what the mesh may have done
# to each figure.

# %%
result.plot.pressure()
print(f"{result.peak_pressure:.0f} MPa instead of {result.hertz['peak_pressure']:.0f} MPa")

# %% [markdown]
# The material gives way below the surface, where the shear stress is largest.

# %%
result.plot.depth("equivalent_plastic_strain", body="lower")
result.subsurface.query("body == 'lower'").head()

# %% [markdown]
# With `fields=True` the result has the stresses of both bodies.

# %%
detailed = client.solve(
    brinell.job(roller, roller, analysis="plane_strain", force=500, fields=True)
)
detailed.plot.field("von_mises")

# %% [markdown]
# A mistake is found before anything is sent, and every one of them is named.

# %%
try:
    brinell.block(width=-10, depth=0, material=brinell.steels["S355"])
except brinell.InvalidJob as error:
    print(error)
