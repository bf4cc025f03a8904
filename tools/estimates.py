#!/usr/bin/env python3
"""Compares estimates of memory and result size of jobs with measured values.

usage: tools/estimates.py [--binary target/release/brinell] [--largest 160] [--generated 200]

With `--generated N`, solves N random jobs of the whole format instead of the table, the same ones
each time. A service with one worker and without a cache solves each job; the memory is the largest
resident size of the process less its size after a small job. Prints a table in Markdown and fails
if a job takes more than 1.2 times its estimate.
"""

import argparse, json, random, sqlite3, sys

from harness import EXAMPLES, Service

parser = argparse.ArgumentParser()
parser.add_argument("--binary", default="target/release/brinell")
parser.add_argument("--largest", type=int, default=160)
parser.add_argument("--generated", type=int)
parser.add_argument("--seed", type=int, default=41)
parser.add_argument("--job-timeout", default="600s")
args = parser.parse_args()


def job(example, elements, forces=None, fields=False, **more):
    made = {
        **EXAMPLES[example],
        "mesh": {"elements_per_half_width": elements},
        "output": {"fields": fields, "subsurface": True},
        **more,
    }
    if forces:
        made["load"] = {"forces": [300 + 10 * step for step in range(forces)]}
    return made


def different(made):
    made = json.loads(json.dumps(made))
    made["lower"]["material"]["plasticity"]["yield_stress"] = 501.0
    return made


TABLE = [
    ("equal bodies", job("two_cylinders", 20)),
    ("equal bodies", job("two_cylinders", 80)),
    ("equal bodies, fields", job("two_cylinders", 80, fields=True)),
    ("different bodies, fields", different(job("two_cylinders", 80, fields=True))),
    ("40 loads, fields", job("two_cylinders", 80, 40, True)),
    ("1000 loads, fields", job("two_cylinders", 5, 1000, True)),
    ("secant stiffness", job("two_cylinders", 40, solver={"coupling": "secant_stiffness"})),
    (
        "flow theory, fields",
        {
            **job("two_cylinders", 20, fields=True),
            "solver": {"theory": "flow"},
            "load": {"history": [{"force": 300.0}, {"force": 612.0}, {"force": 0.0}]},
        },
    ),
    *[
        (name.replace("_", " "), {**example, "output": {"fields": True}})
        for name, example in EXAMPLES.items()
    ],
    ("different bodies, fields", different(job("two_cylinders", args.largest, fields=True))),
]


SHAPES = [
    {"type": "parabola", "radius": 15.0, "width": 20.0, "depth": 20.0},
    {"type": "ellipse", "semi_axis_x": 20.0, "semi_axis_y": 12.0},
    {"type": "power", "exponent": 4.0, "scale": 8.0, "width": 10.0, "depth": 10.0},
    {"type": "wedge", "angle": 10.0, "tip_radius": 2.0, "width": 20.0, "depth": 20.0},
    {"type": "groove", "radius": 40.0, "width": 30.0, "depth": 20.0},
    {
        "type": "profile",
        "points": [[-10.0, -4.0], [-3.0, -0.4], [0.0, 0.0], [3.0, -0.4], [10.0, -4.0]],
        "depth": 15.0,
    },
    {"type": "punch", "width": 6.0, "edge_radius": 0.5, "depth": 10.0},
]


def three_dimensional():
    """A ball on a half-space that yields where Hertz's peak pressure is some times the yield stress. Not every one is a valid job."""
    radius, strength, ratio = (
        random.uniform(2, 20),
        random.uniform(300, 1500),
        random.uniform(1, 6),
    )
    rigid, flow, count = random.random() < 0.5, random.random() < 0.3, random.randint(2, 6)
    steel = {"young_modulus": 210000.0, "poisson_ratio": 0.3}
    modulus = 210000 / 0.91 / (1 if rigid else 2)
    force = (ratio * strength) ** 3 * 31.0 * radius**2 / (6 * modulus**2)
    steps = [{"force": force * (step + 1) / count} for step in range(count)]
    made = {
        "analysis": "three_dimensional",
        "upper": {
            "shape": {"type": "sphere", "radius": radius},
            "material": {"rigid": True} if rigid else steel,
        },
        "lower": {
            "shape": {"type": "flat"},
            "material": {
                **steel,
                "plasticity": {
                    "law": "bilinear",
                    "yield_stress": strength,
                    "tangent_modulus": random.choice([0.0, 5000.0, 50000.0]),
                },
            },
        },
        "load": {"history": [*steps, {"force": 0.0}]}
        if flow
        else random.choice([{"force": force}, {"forces": [step["force"] for step in steps]}]),
        "mesh": {"elements_per_half_width": random.choice([4, 6, 8, 12])},
        "output": {"fields": random.random() < 0.5, "subsurface": True},
    }
    if flow:
        made["solver"] = {"theory": "flow"}
    return (
        f"ball at {ratio:.1f} yield stresses{' flow' * flow} {count}{' fields' * made['output']['fields']}",
        made,
    )


def generated():
    """An example with another shape, load, mesh, coupling, theory and output. Not every one is a valid job."""
    if random.random() < 0.15:
        return three_dimensional()
    # A hardness test has the load of its scale.
    examples = [example for example in EXAMPLES.items() if "hardness" not in example[1]["load"]]
    name, example = random.choice(examples)
    made = json.loads(json.dumps(example))
    force = random.uniform(0.5, 1.5) * (
        example["load"].get("force") or example["load"].get("forces", [2000.0])[-1]
    )
    if example["analysis"] == "plane_strain" and random.random() < 0.4:
        shape = random.choice(SHAPES)
        side = "lower" if shape["type"] == "groove" else "upper"
        name += " " + shape["type"]
        made[side] = {
            "shape": shape,
            "material": {"rigid": True} if shape["type"] == "punch" else made[side]["material"],
        }
    count = random.randint(2, 40)
    steps = [force * (step + 1) / count for step in range(count)]
    flow = random.random() < 0.5
    loads = [
        {"force": force},
        {"forces": steps},
        {"onset": True},
        {"target": {"peak_pressure": random.uniform(1000, 2500)}},
    ]
    if flow:
        loads = [
            {"history": [{"force": one} for one in [*steps, force / 2, 0.0]]},
            {"target": {"permanent_approach": random.uniform(0.0003, 0.002)}},
            *loads[:2],
        ]
    made["load"] = random.choice(loads)
    made["mesh"] = {
        "elements_per_half_width": random.choice(
            [5, 8, 12, 16, 20, 30] if count > 10 else [12, 20, 30, 40, 60]
        )
    }
    made["solver"] = {
        "theory": "flow" if flow else "deformation",
        "contact": random.choice(["active_set", "simplex"]),
    }
    if flow and random.random() < 0.5:
        made["solver"]["increments"] = random.randint(1, 100)
    if not flow:
        made["solver"]["coupling"] = random.choice(
            ["accelerated", "accelerated", "strong", "weak", "secant_stiffness"]
        )
    made["output"] = {"fields": random.random() < 0.5, "subsurface": random.random() < 0.5}
    return (
        f"{name} {'flow' if flow else made['solver']['coupling']} {next(iter(made['load']))} {count}{' fields' * made['output']['fields']}",
        made,
    )


random.seed(args.seed)
JOBS = TABLE if args.generated is None else (generated() for _ in range(100 * args.generated))
print(
    "| job | elements | equations | estimate [MiB] | peak [MiB] | ratio | result, estimate [MiB] | result [MiB] | ratio |"
)
print("|---|--:|--:|--:|--:|--:|--:|--:|--:|")
worst, left, ratios = 0.0, args.generated or len(TABLE), []
for name, made in JOBS:
    if not left:
        break
    with Service(
        args.binary,
        "--workers",
        "1",
        "--factor-cache",
        "0",
        "--max-job-memory",
        "16384",
        "--memory-limit",
        "16384",
        "--job-timeout",
        args.job_timeout,
    ) as service:
        code, answer = service.ask("POST", "/v1/validate", made)
        if code == 422 and args.generated:
            continue
        estimate = answer["estimate"] if code == 200 else sys.exit(f"{name}: {answer}")
        left -= 1
        # What the process takes for its first job whatever that is.
        service.wait(service.submit(job("two_cylinders", 4, fields=True)))
        before = service.memory()
        document = service.wait(service.submit(made))
        peak = service.memory("VmHWM") - before
        with sqlite3.connect(f"file:{service.data}/brinell.db?mode=ro", uri=True) as database:
            stored = database.execute("SELECT stored_bytes FROM jobs ORDER BY id DESC").fetchone()[
                0
            ]
    if document["status"] not in ("succeeded", "not_converged"):
        if not args.generated:
            sys.exit(f"{name}: {document['status']}")
        # Its result is not kept; its memory is that of other jobs.
        stored = 0
        name += f", {document['status']}"
    ratio, size = peak / estimate["bytes"], stored / estimate["result_bytes"]
    worst = max(worst, ratio, size)
    ratios.append((ratio, size))
    mesh = made.get("mesh", {}).get("elements_per_half_width", "")
    print(
        f"| {name} | {mesh} | {estimate['equations']} | {estimate['bytes'] / 2**20:.0f} | {peak / 2**20:.0f} | {ratio:.2f} | "
        f"{estimate['result_bytes'] / 2**20:.2f} | {stored / 2**20:.2f} | {size:.2f} |",
        flush=True,
    )
for what, of in (
    ("memory", sorted(ratio for ratio, _ in ratios)),
    ("result", sorted(size for _, size in ratios)),
):
    above = sum(one > 1.2 for one in of)
    print(
        f"{what}: median {of[len(of) // 2]:.2f}, worst {of[-1]:.2f} times the estimate; {above} of {len(of)} above 1.2"
    )
sys.exit(f"the worst is {worst:.2f} times its estimate" if worst > 1.2 else 0)
