"""Runs the Python blocks of a README, one after the other, as one who follows it.

python clients/python/scripts/run_readme.py README
"""

import re
import sys
from pathlib import Path

text = Path(sys.argv[1]).read_text("utf-8")
blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
assert len(blocks) > 3
names: dict[str, object] = {}
for block in blocks:
    exec(compile(block, sys.argv[1], "exec"), names)
print(f"{len(blocks)} blocks of the README have run")
