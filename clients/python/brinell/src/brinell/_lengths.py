"""Units of length by the names that instruments and people give them."""

from __future__ import annotations

# What one of each is in mm.
LENGTHS = {
    "km": 1e6,
    "m": 1e3,
    "cm": 10.0,
    "mm": 1.0,
    "µm": 1e-3,
    "um": 1e-3,
    "micron": 1e-3,
    "microns": 1e-3,
    "micrometer": 1e-3,
    "micrometers": 1e-3,
    "Mikrometer": 1e-3,
    "millimeter": 1.0,
    "Millimeter": 1.0,
    "nanometer": 1e-6,
    "nanometers": 1e-6,
    "Nanometer": 1e-6,
    "meter": 1e3,
    "meters": 1e3,
    "nm": 1e-6,
    "Å": 1e-7,
    "pm": 1e-9,
    "in": 25.4,
    "inch": 25.4,
    "inches": 25.4,
    "mil": 25.4e-3,
    "thou": 25.4e-3,
}


def length_in_mm(name: str) -> float:
    """One of this unit in mm; raises `ValueError` for a name that is no unit of length."""
    plain = name.strip().strip("[]()").strip().replace("μ", "µ").replace("Å", "Å")
    if plain in LENGTHS:
        return LENGTHS[plain]
    raise ValueError(f"{name!r} is no unit of length known here ({', '.join(LENGTHS)})")


def is_length(name: str) -> bool:
    """Whether a name is a unit of length."""
    try:
        length_in_mm(name)
    except ValueError:
        return False
    return True
