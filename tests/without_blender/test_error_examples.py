# SPDX-License-Identifier: GPL-3.0-or-later
"""The page on errors shows every sentence that the add-on has."""

import importlib.util
import inspect
import re
from pathlib import Path

import pytest

FILE = Path(__file__).resolve().parents[2] / "docs" / "error_examples.py"


@pytest.fixture(scope="module")
def examples():
    spec = importlib.util.spec_from_file_location("error_examples", FILE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_each_example_makes_a_sentence_of_its_own(addon, examples):
    modules = addon.core.library(), addon.solve.error_sentences
    sentences = [examples.example_sentence(*modules, each) for each in examples.EXAMPLES]
    assert all(sentences) and len(set(sentences)) == len(sentences)


def test_each_code_and_reason_has_an_example(addon, examples):
    found = {(code, arguments.get("reason")) for code, arguments, *_ in examples.EXAMPLES}
    for code, function in addon.solve.error_sentences.SENTENCES.items():
        reasons = re.findall(r'case "(\w+)"', inspect.getsource(function))
        for reason in reasons or [None]:
            assert (code, reason) in found
