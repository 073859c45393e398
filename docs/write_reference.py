# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the reference of the Python package as HTML into a folder, with pdoc.

The types of wirewarp come from the stub, because pdoc would otherwise show pybind11's signatures and getters. The
modules wirewarp.pattern and wirewarp.report are Python and have their own types.

Usage: python write_reference.py FOLDER
"""

import inspect
import re
import sys
from pathlib import Path
from typing import Any

import pdoc.doc
import pdoc.render
import wirewarp
import wirewarp.pattern
import wirewarp.report


class Plain(str):
    """An annotation that is shown without quotes."""

    __repr__ = str.__str__


def read_stub() -> dict[str, Any]:
    source = Path(wirewarp.__file__).with_name("_wirewarp.pyi").read_text()
    defined: dict[str, Any] = {"__package__": "wirewarp"}
    exec("from __future__ import annotations\n" + source, defined)
    return defined


def plain(signature: inspect.Signature) -> inspect.Signature:
    parameters = []
    for each in signature.parameters.values():
        is_typed = each.annotation is not inspect.Parameter.empty
        parameters.append(each.replace(annotation=Plain(each.annotation)) if is_typed else each)
    returned = signature.return_annotation
    return signature.replace(
        parameters=parameters,
        return_annotation=inspect.Signature.empty if returned == "None" else Plain(returned),
    )


def describe_function(function: pdoc.doc.Function, stub: Any) -> None:  # noqa: ANN401
    """Remove the signature with which pybind11 starts the docstring."""
    _, _, function.docstring = function.docstring.partition("\n")
    function.signature = plain(inspect.signature(stub))


def describe_class(kind: pdoc.doc.Class, stub: Any) -> None:  # noqa: ANN401
    if "__init__" not in vars(stub):  # only the library creates such objects
        kind.members.pop("__init__", None)
    for name, member in kind.members.items():
        bound, typed = getattr(kind.obj, name, None), getattr(stub, name, None)
        if isinstance(bound, property):
            member.docstring = bound.__doc__ or ""
            is_getter = isinstance(typed, property)
            of_what = typed.fget.__annotations__["return"] if is_getter else stub.__annotations__[name]
            member.annotation_str = ": " + re.sub(r"^Final\[(.*)\]$", r"\1", of_what)
        elif isinstance(member, pdoc.doc.Function) and inspect.isfunction(typed):
            describe_function(member, typed)


def main() -> None:
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    module, stub = pdoc.doc.Module(wirewarp), read_stub()
    for name, member in module.members.items():
        if isinstance(member, pdoc.doc.Class) and name in stub and name != "FlattenError":
            describe_class(member, stub[name])
        elif isinstance(member, pdoc.doc.Function):
            describe_function(member, stub[name])
    codes = module.members["ErrorCode"]
    for code in wirewarp.ErrorCode:
        arguments = f"\n\nArguments: {code.arguments}." if code.arguments else ""
        codes.members[code.name].docstring = f"{code.meaning} {code.remedy}{arguments}"
    pdoc.render.configure(docformat="markdown", show_source=False)
    described = {each.__name__: pdoc.doc.Module(each) for each in (wirewarp.pattern, wirewarp.report)}
    modules = {"wirewarp": module, **described}
    (folder / "wirewarp").mkdir(exist_ok=True)
    (folder / "index.html").write_text(pdoc.render.html_index(modules))
    for name, each in modules.items():
        (folder / f"{name.replace('.', '/')}.html").write_text(pdoc.render.html_module(each, modules))


if __name__ == "__main__":
    main()
