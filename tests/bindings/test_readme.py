# SPDX-License-Identifier: GPL-3.0-or-later
"""The example in the README runs and prints what the README says."""

import re
from pathlib import Path

README = Path(__file__).resolve().parents[2] / "README.md"


def test_the_python_example_prints_what_the_readme_says(capsys):
    code, output = re.search(r"```python\n(.*?)```\s*```\n(.*?)```", README.read_text(), re.DOTALL).groups()
    exec(code, {})
    assert capsys.readouterr().out == output
