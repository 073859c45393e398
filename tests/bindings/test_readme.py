# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of the page on Python run in order, and print the lines that the page shows."""

import re
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "docs" / "python" / "index.md"


def test_the_python_examples_print_the_lines_on_the_page(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    examples = re.findall(r"```python\n(.*?)```\s*```\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    names = {}
    for code, output in examples:
        exec(code, names)
        assert capsys.readouterr().out == output
    assert len(examples) == 2
