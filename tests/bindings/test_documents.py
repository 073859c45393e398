# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples for patterns run, and the table of options is complete."""

import json
import re
from pathlib import Path

import wirewarp
from patterns import flattened

DOCUMENTS = Path(__file__).resolve().parents[2] / "docs"


def test_the_examples_for_patterns_run(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    examples = re.findall(r"```python\n(.*?)```", (DOCUMENTS / "pattern.md").read_text(), re.DOTALL)
    assert len(examples) == 3
    names = {"result": flattened("Fitted top"), "json": json, "Path": Path}
    for code in examples:
        exec(code.replace("seconds=30", "seconds=0.1"), names)
    assert {path.name for path in tmp_path.iterdir()} == {"top.pdf", "top-marker.pdf", "top.json"}


def test_the_table_of_options_names_all_and_their_defaults():
    text = (DOCUMENTS / "python" / "options.md").read_text()
    written = dict(re.findall(r"^\| `(\w+)`[^|]*\|([^|]*)\|", text, re.MULTILINE))
    defaults = wirewarp.Options().to_dict()
    assert written.keys() == defaults.keys()
    for name, default in defaults.items():
        assert as_written(default) in written[name], name


def as_written(value: object) -> str:
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, list):
        return f"({', '.join(map(as_written, value))})"
    return f"{value:g}" if isinstance(value, float) else str(value)
