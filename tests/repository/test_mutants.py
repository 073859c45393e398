# SPDX-License-Identifier: GPL-3.0-or-later
"""./dev mutants changes the right places of a source."""

import pytest

from tools import mutants

SOURCES = {
    "a.cpp": ('#include <a + b>\n// a < b\nstd::vector<int> f() { return g("a + b") && -1 <= 2; }\n', ["&&", "<="]),
    "a.py": ('"""a < b"""\nx = f"a + b" if y and z >= 1 else w  # a == b\n', ["and", ">="]),
}


@pytest.mark.parametrize("name", SOURCES)
def test_operators_are_changed_but_not_in_comments_and_texts(tmp_path, name):
    text, operators = SOURCES[name]
    (tmp_path / name).write_text(text)
    found = list(mutants._mutants_of(tmp_path / name))
    assert [mutant.operator for mutant in found] == operators
    assert found[0].text() == text.replace("&&", "||").replace(" and ", " or ")
