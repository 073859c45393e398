# SPDX-License-Identifier: GPL-3.0-or-later
"""The type stubs have every name with its type, and the package has every field of the C++ headers."""

import ast
import inspect
import sys
import types
import typing
from pathlib import Path

import numpy as np
import pytest
import wirewarp
import wirewarp.pattern
from numpy.typing import NDArray
from surfaces import chain_edges, column_chain, spherical_patch
from wirewarp import _errors, _wirewarp

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "native" / "bindings"))

from write_docs import comments

PACKAGE = Path(wirewarp.__file__).parent
HEADERS = Path(__file__).resolve().parents[2] / "native" / "include"


def stub(name: str) -> ast.Module:
    return ast.parse((PACKAGE / name).read_text())


def names(body: list[ast.stmt]) -> set[str]:
    """Return the public names that the statements define."""
    found = set()
    for node in body:
        if isinstance(node, ast.ClassDef | ast.FunctionDef):
            found.add(node.name)
        elif isinstance(node, ast.AnnAssign):
            found.add(node.target.id)
        elif isinstance(node, ast.Assign):
            found |= {target.id for target in node.targets}
    return found - {"__init__", "_Result"}


def public(value) -> set[str]:
    return {name for name in vars(value) if not name.startswith("_")}


CLASSES = {node.name: node for node in stub("_wirewarp.pyi").body if isinstance(node, ast.ClassDef)}
FUNCTIONS = {node.name: node for node in stub("_wirewarp.pyi").body if isinstance(node, ast.FunctionDef)}


def test_the_stub_names_everything_in_the_module():
    assert names(stub("_wirewarp.pyi").body) == public(_wirewarp) | {"__version__"}


@pytest.mark.parametrize("name", CLASSES)
def test_the_stub_of_a_class_names_its_attributes(name):
    assert names(CLASSES[name].body) == public(getattr(_wirewarp, name))


def test_the_stub_knows_the_default_options():
    (init,) = (node for node in CLASSES["Options"].body if getattr(node, "name", "") == "__init__")
    pairs = zip(init.args.kwonlyargs, init.args.kw_defaults, strict=True)
    defaults = {argument.arg: ast.literal_eval(value) for argument, value in pairs}
    options = wirewarp.Options()
    assert defaults == {name: getattr(options, name) for name in options.to_dict()}


def test_the_stub_of_the_errors_names_every_code_and_attribute():
    classes = {node.name: node for node in stub("_errors.pyi").body if isinstance(node, ast.ClassDef)}
    codes = {code.name for code in _errors.ErrorCode}
    assert names(classes["ErrorCode"].body) == codes | {"meaning", "remedy", "arguments"}
    error = wirewarp.FlattenError("cancelled", "Cancelled.")
    assert names(classes["FlattenError"].body) == set(vars(error)) | {"to_dict"}


def test_the_package_exports_every_listed_name():
    modules = {name for name, value in vars(wirewarp).items() if inspect.ismodule(value)}
    assert set(wirewarp.__all__) == public(wirewarp) - modules | {"__version__"}
    assert (PACKAGE / "py.typed").exists()


@pytest.mark.parametrize("module", [wirewarp, wirewarp.pattern])
def test_everything_public_is_documented(module):
    names = set(module.__all__) - {"__version__"}
    assert {name for name in names if not inspect.getdoc(getattr(module, name))} == set()


def parameters(function: ast.FunctionDef) -> list[tuple[str, str]]:
    """Return (name, default) of each argument, with a star before keyword-only arguments."""
    arguments = function.args
    plain = [*arguments.posonlyargs, *arguments.args]
    defaults = [None] * (len(plain) - len(arguments.defaults)) + arguments.defaults
    star = [(ast.arg("*"), None)] if arguments.kwonlyargs else []
    by_keyword = zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True)
    pairs = [*zip(plain, defaults, strict=True), *star, *by_keyword]
    return [(arg.arg, ast.unparse(default) if default else "") for arg, default in pairs]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_stub_knows_the_parameters_of_a_function(name):
    signature = getattr(_wirewarp, name).__doc__.splitlines()[0]  # the docstring that pybind11 writes
    assert parameters(FUNCTIONS[name]) == parameters(ast.parse(f"def {signature}: ...").body[0])


def test_python_has_every_field_of_the_headers():
    documented = {name for file in HEADERS.rglob("*.h") for name, _ in comments(file.read_text())}
    bound = set(wirewarp.__all__) - {"Cache", "ErrorCode", "FlattenError"}
    fields = {tuple(name.split(".")) for name in documented if "." in name and name.split(".")[0] in bound}
    in_report = {("FlattenResult", name) for name in ("method", "reused_pieces", "seconds")}
    assert len(fields) > 50
    assert {(owner, name) for owner, name in fields - in_report if not hasattr(getattr(wirewarp, owner), name)} == set()


def fits(value: object, hint: object) -> bool:
    """Return whether a value has the type that the stub declares."""
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin is typing.Literal:
        return value in arguments
    if origin in (types.UnionType, typing.Union):
        return any(fits(value, each) for each in arguments)
    if isinstance(value, np.ndarray):
        # NDArray is compared as a whole, because typing does not resolve it since numpy 2.5.
        return hint == NDArray[value.dtype.type]
    if origin in (list, tuple):
        return isinstance(value, origin) and all(fits(each, arguments[0]) for each in value)
    if origin is dict:
        return isinstance(value, dict)
    return type(value).__name__ == hint.__name__  # by name, because the stub's classes are not those of the module


def all_within(value: object) -> list:
    """Return the object and all objects in its attributes, at any depth, whose class is in the stub."""
    if isinstance(value, list):
        return [inner for each in value for inner in all_within(each)]
    if type(value).__name__ not in CLASSES:
        return []
    return [value] + [inner for name in type(value)._fields for inner in all_within(getattr(value, name))]


def test_results_have_the_types_of_the_stub():
    vertices, faces = spherical_patch()
    wires = [wirewarp.Wire(column_chain(8, 8, 2)[1:4], 0.02)]  # its ends need helper wires
    seams = chain_edges(column_chain(8, 8, 4))
    result = wirewarp.flatten(vertices, faces, wires=wires, seams=seams, options=wirewarp.Options(method="wirewarp++"))
    typed = {"__package__": "wirewarp"}
    exec("from __future__ import annotations\n" + (PACKAGE / "_wirewarp.pyi").read_text(), typed)
    darts = wirewarp.propose_darts(vertices, faces, count=1)
    sources = wirewarp.cut_mesh(vertices, faces, darts[0].paths)[3]
    fewer = wirewarp.simplify_seams(vertices, faces, seams=seams)
    seen = all_within(result) + all_within(darts) + all_within(sources) + all_within(fewer)
    assert {type(each).__name__ for each in seen} == set(CLASSES) - {"Cache", "Cloth", "Ease", "Job", "Options", "Wire"}
    wrong = []
    for each in seen:
        kind = typed[type(each).__name__]
        hints = typing.get_type_hints(kind, typed)
        for name in type(each)._fields:
            (hint,) = typing.get_args(hints[name])  # the argument of Final
            if not fits(getattr(each, name), hint):
                wrong.append((kind.__name__, name, getattr(each, name), hint))
    assert wrong == []
