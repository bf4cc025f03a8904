# %% [markdown]
# # A yield stress from a load-approach curve
#
# A press has measured force over approach of two rollers. Which yield stress and hardening
# explain it? `scipy.optimize.least_squares` changes both; `client.map` solves the jobs of a
# Jacobian side by side.

# %%
import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import least_squares

import brinell

client = brinell.Client()
approaches = np.linspace(0.01, 0.05, 5)


def contact(yield_stress: float, tangent_modulus: float) -> brinell.JobLike:
    """Two rollers, pressed together as far as the press did."""
    law = brinell.bilinear(yield_stress=yield_stress, tangent_modulus=tangent_modulus)
    steel = brinell.material(young_modulus=210000, poisson_ratio=0.3, plasticity=law)
    roller = brinell.cylinder(radius=20, material=steel)
    return brinell.job(
        roller, roller, analysis="plane_strain", approaches=approaches, elements_per_half_width=10
    )


def forces(result: brinell.Result) -> np.ndarray:
    """The force at each approach."""
    return np.array([step.force for step in result.steps])


# %% [markdown]
# The measurement is made up here: a known steel, and half a per cent of noise.

# %%
noise = np.random.default_rng(1).normal(1.0, 0.005, len(approaches))
measured = forces(client.solve(contact(430, 9000))) * noise

# %%
SCALE = np.array([500.0, 10000.0])
STEP = 0.02


def residuals(at: np.ndarray) -> np.ndarray:
    """How far the forces are off, relative."""
    return forces(client.solve(contact(*(at * SCALE)))) / measured - 1


def jacobian(at: np.ndarray) -> np.ndarray:
    """Central differences; the four jobs are solved together."""
    moves = [sign * STEP * row for row in np.eye(2) for sign in (1, -1)]
    solved = [forces(r) for _, r in client.map(contact(*((at + move) * SCALE)) for move in moves)]
    return (
        np.stack([(solved[2 * k] - solved[2 * k + 1]) / (2 * STEP) for k in range(2)], 1)
        / measured[:, None]
    )


fit = least_squares(
    residuals, x0=[0.6, 0.5], jac=jacobian, bounds=([0.2, 0.0], [2.0, 5.0]), xtol=1e-3
)
yield_stress, tangent_modulus = fit.x * SCALE
print(f"yield stress {yield_stress:.0f} MPa, tangent modulus {tangent_modulus:.0f} MPa")

# %% [markdown]
# How well does the curve determine them? The covariance says it.

# %%
variance = 2 * fit.cost / (len(approaches) - 2)
deviations = np.sqrt(np.diag(np.linalg.inv(fit.jac.T @ fit.jac)) * variance) * SCALE
print(f"± {deviations[0]:.0f} MPa and ± {deviations[1]:.0f} MPa")

# %%
fitted = forces(client.solve(contact(yield_stress, tangent_modulus)))
fig, ax = plt.subplots(layout="constrained")
ax.plot(approaches, measured, "o", label="measured")
ax.plot(approaches, fitted, label=f"yield stress {yield_stress:.0f} MPa")
ax.set(xlabel="approach [mm]", ylabel="force [N/mm]")
ax.legend(frameon=False)
