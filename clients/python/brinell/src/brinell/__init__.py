"""Contact of two bodies that are pressed together so hard that they yield.

```python
import brinell

client = brinell.Client()
roller = brinell.cylinder(radius=20, material=brinell.steels["52100"])
result = client.solve(brinell.job(roller, roller, analysis="plane_strain", force=2000))
result["peak_pressure"]
```
"""

from __future__ import annotations

from importlib.metadata import PackageNotFoundError, version

from . import hardening
from ._build import job, material, rigid
from ._builders import (
    bilinear,
    block,
    cone,
    curved,
    cylinder,
    ellipse,
    flat,
    groove,
    hole,
    ludwik,
    parabola,
    power,
    profile,
    punch,
    ramberg_osgood,
    roller,
    sphere,
    swift,
    table,
    voce,
    wedge,
)
from ._client import AsyncClient, AsyncJob, AsyncResult, Client, Job
from ._core import Event
from ._errors import (
    BrinellError,
    Fault,
    InvalidJob,
    JobFailed,
    NotFound,
    QuotaExceeded,
    ServerDied,
    ServerNotFound,
    ServiceError,
    StillRunning,
    Unauthorized,
    Unavailable,
)
from ._fatigue import Fatigue
from ._fields import BodyFields, Fields
from ._grid import over_grid
from ._hardness import brinell_test, rockwell_c, vickers
from ._identify import Identification, identify
from ._many import map, sweep
from ._materials import Materials, materials, steels
from ._plain import JobLike, Quantity
from ._plain import document_of as document
from ._result import Result
from ._rows import Row
from ._step import Pressure, Remark, Step, Verdict
from ._study import Study, open_study
from ._surface import Surface, surface
from ._trace import Trace, trace

try:
    __version__ = version("brinell")
except PackageNotFoundError:  # pragma: no cover - run from its source without being installed
    __version__ = "0"

__all__ = [
    "AsyncClient",
    "AsyncJob",
    "AsyncResult",
    "BodyFields",
    "BrinellError",
    "Client",
    "Event",
    "Fatigue",
    "Fault",
    "Fields",
    "Identification",
    "InvalidJob",
    "Job",
    "JobFailed",
    "JobLike",
    "Materials",
    "NotFound",
    "Pressure",
    "Quantity",
    "QuotaExceeded",
    "Remark",
    "Result",
    "Row",
    "ServerDied",
    "ServerNotFound",
    "ServiceError",
    "Step",
    "StillRunning",
    "Study",
    "Surface",
    "Trace",
    "Unauthorized",
    "Unavailable",
    "Verdict",
    "bilinear",
    "block",
    "brinell_test",
    "cone",
    "curved",
    "cylinder",
    "document",
    "ellipse",
    "flat",
    "groove",
    "hardening",
    "hole",
    "identify",
    "job",
    "ludwik",
    "map",
    "material",
    "materials",
    "open_study",
    "over_grid",
    "parabola",
    "power",
    "profile",
    "punch",
    "ramberg_osgood",
    "rigid",
    "rockwell_c",
    "roller",
    "sphere",
    "steels",
    "surface",
    "sweep",
    "swift",
    "table",
    "trace",
    "vickers",
    "voce",
    "wedge",
]
