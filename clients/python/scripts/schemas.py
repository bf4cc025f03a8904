"""Writes the interface document with the named schemas alone, and those that they refer to.

python clients/python/scripts/schemas.py NAME... > DOCUMENT
"""

import json
import re
import sys
from pathlib import Path


def main() -> None:
    path = Path(__file__).resolve().parents[3] / "api/openapi.json"
    document = json.loads(path.read_text("utf-8"))
    schemas = document["components"]["schemas"]
    kept: dict[str, object] = {}
    names = sys.argv[1:]
    while names:
        name = names.pop()
        if name not in kept:
            kept[name] = schemas[name]
            names += re.findall(r'"#/components/schemas/(\w+)"', json.dumps(schemas[name]))
    ordered = {name: schemas[name] for name in schemas if name in kept}
    parts = {"openapi": document["openapi"], "info": document["info"], "paths": {}}
    json.dump({**parts, "components": {"schemas": ordered}}, sys.stdout)


if __name__ == "__main__":
    main()
