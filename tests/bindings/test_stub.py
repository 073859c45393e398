# SPDX-License-Identifier: GPL-3.0-or-later
"""The type stubs name what there is."""

import ast
import inspect
from pathlib import Path

import pytest
import wirewarp
from wirewarp import _errors, _wirewarp

PACKAGE = Path(wirewarp.__file__).parent


def stub(name: str) -> ast.Module:
    return ast.parse((PACKAGE / name).read_text())


def names(body: list[ast.stmt]) -> set[str]:
    """What the statements define, but for __init__."""
    found = set()
    for node in body:
        if isinstance(node, ast.ClassDef | ast.FunctionDef):
            found.add(node.name)
        elif isinstance(node, ast.AnnAssign):
            found.add(node.target.id)
        elif isinstance(node, ast.Assign):
            found |= {target.id for target in node.targets}
    return found - {"__init__"}


def public(value) -> set[str]:
    return {name for name in vars(value) if not name.startswith("_")}


CLASSES = {node.name: node for node in stub("_wirewarp.pyi").body if isinstance(node, ast.ClassDef)}


def test_the_stub_names_what_the_module_has():
    assert names(stub("_wirewarp.pyi").body) == public(_wirewarp) | {"__version__"}


@pytest.mark.parametrize("name", CLASSES)
def test_the_stub_of_a_class_names_its_attributes(name):
    assert names(CLASSES[name].body) == public(getattr(_wirewarp, name))


def test_the_stub_knows_the_default_options():
    (init,) = (
        node for node in CLASSES["Options"].body if isinstance(node, ast.FunctionDef) and node.name == "__init__"
    )
    defaults = {
        arg.arg: ast.literal_eval(value) for arg, value in zip(init.args.kwonlyargs, init.args.kw_defaults, strict=True)
    }
    options = wirewarp.Options()
    assert defaults == {name: getattr(options, name) for name in options.to_dict()}


def test_the_stub_of_the_errors_names_every_code_and_attribute():
    classes = {node.name: node for node in stub("_errors.pyi").body if isinstance(node, ast.ClassDef)}
    assert names(classes["ErrorCode"].body) == {code.name for code in _errors.ErrorCode} | {"meaning", "remedy"}
    error = wirewarp.FlattenError("cancelled", "Cancelled.")
    assert names(classes["FlattenError"].body) == set(vars(error)) | {"to_dict"}


def test_the_package_exports_what_it_names():
    assert set(wirewarp.__all__) == {
        name for name, value in vars(wirewarp).items() if not name.startswith("_") and not inspect.ismodule(value)
    } | {"__version__"}
    assert (PACKAGE / "py.typed").exists()


@pytest.mark.parametrize("name", sorted(set(wirewarp.__all__) - {"__version__"}))
def test_everything_public_is_documented(name):
    assert inspect.getdoc(getattr(wirewarp, name))
