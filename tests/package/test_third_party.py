# SPDX-License-Identifier: GPL-3.0-or-later
"""THIRD_PARTY.md lists all code of others in each zip, with its license."""

import email
import re

import pytest
from zips_in_dist import ROOT, ZIPS, files_of, wheels_of

# If a compiled file contains the text of a library, it contains the library.
MARKS = {
    "OpenMesh": b"OpenMesh",
    "pybind11": b"pybind11",
    "Eigen": b"Eigen",
    "HarfBuzz": b"hb_buffer_t",
    "Clipper": b"ClipperLib",
    "libstdc++": b"terminate called recursively",
    "libc++": b"libc++abi",
    "libunwind": b"libunwind: ",
    "mingw-w64": b"Mingw-w64",
    "zlib": b"deflate 1.",
    "OpenMP": b"__kmpc_fork_call",
}
HEADINGS = re.findall(r"^## (.+)$", (ROOT / "THIRD_PARTY.md").read_text(), re.MULTILINE)
zips = pytest.mark.parametrize("path", ZIPS, ids=lambda path: path.name)


def table() -> dict[str, str]:
    """Return the license of each library."""
    lines = (ROOT / "THIRD_PARTY.md").read_text().splitlines()
    rows = [line.strip("|").split("|") for line in lines if line[:1] == "|"]
    found = {}
    for names, _, license in rows[2:]:
        for name in re.sub(r"\]\(.*?\)|\[", "", names).split(","):  # without the addresses of links
            found[re.match(r"\s*([\w+-]+)", name)[1]] = license.strip()
    return found


def compiled(path) -> dict[str, bytes]:
    """Return the compiled files of a zip, including compiled files in its wheels."""
    files = dict(files_of(path))
    for wheel in wheels_of(path).values():
        files |= wheel
    return {name: content for name, content in files.items() if re.search(r"\.(so|pyd|dll|dylib)(\.|$)", name)}


def test_every_license_is_a_link_or_is_below():
    for name, text in table().items():
        is_below = text.endswith(", below") and text.removesuffix(", below") in HEADINGS
        assert is_below or re.search(r"\]\(https://", text), name


@zips
def test_the_file_is_inside(path):
    assert files_of(path)["THIRD_PARTY.md"] == (ROOT / "THIRD_PARTY.md").read_bytes()


@zips
def test_packages_are_listed_under_their_license(path):
    packages = {name.removeprefix("wheels/").split("-")[0] for name in wheels_of(path)} | {
        name.split("/")[2] for name in files_of(path) if name.startswith("_core/libraries/")
    }
    assert packages - {"wirewarp"} <= set(table())
    for name, files in wheels_of(path).items():
        (metadata,) = (content for each, content in files.items() if each.endswith(".dist-info/METADATA"))
        said = email.message_from_bytes(metadata)
        package = name.removeprefix("wheels/").split("-")[0]
        if package != "wirewarp":
            license = said["License-Expression"] or said["License"] or " ".join(said.get_all("Classifier", []))
            word = re.match(r"\[?(\w+)", table()[package])[1]  # BSD, MIT or Apache
            assert word in license, (package, license)


@zips
def test_libraries_in_compiled_files_are_listed(path):
    assert compiled(path)
    found = {name for name, mark in MARKS.items() if any(mark in content for content in compiled(path).values())}
    assert found >= {"OpenMesh", "pybind11"}  # every zip contains both, so the search for marks works
    assert found <= set(table())


@zips
def test_no_compiled_file_comes_from_elsewhere(path):
    """Some wheels have shared libraries in a folder PACKAGE.libs, which this test does not allow."""
    for name in compiled(path):
        package = name.removeprefix("_core/").removeprefix("libraries/").split("/")[0]
        assert package in {"wirewarp", *table()}, name
