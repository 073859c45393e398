# SPDX-License-Identifier: GPL-3.0-or-later
"""The zips in dist/ meet the rules that reviewers of Blender's extension platform check.

https://developer.blender.org/docs/features/extensions/moderation/guidelines/
https://docs.blender.org/manual/en/latest/advanced/extensions/
"""

import ast
import base64
import csv
import hashlib
import re

import pytest
from zips_in_dist import EXTENSIONS, at_import, files_of, imports, manifest_of, sources_of, wheels_of

PLATFORMS = {"linux-x64", "linux-arm64", "windows-x64", "windows-arm64", "macos-x64", "macos-arm64"}
IN_BLENDER = {  # packages that Blender's Python has
    *("numpy", "requests", "urllib3", "certifi", "charset_normalizer", "idna", "zstandard", "cython", "autopep8"),
    *("pycodestyle", "pip", "setuptools", "wheel", "attrs", "cattrs", "typing_extensions", "mathutils", "bpy"),
}
NETWORK = {"socket", "ssl", "urllib", "http", "ftplib", "smtplib", "asyncio", "xmlrpc", "webbrowser", "requests"}
THREADS = {"threading", "_thread", "concurrent", "multiprocessing", "queue"}
NATIVE = {"ctypes", "cffi"}
INSTALLERS = {"pip", "ensurepip", "venv", "site", "pkg_resources"}
# If the user has installed spyrrow, STARTER runs it in a process of its own. Blender never imports PROGRAM, which is
# the program of this process.
PROGRAM, STARTER = "wirewarp/pattern/nest/spyrrow_process.py", "wirewarp/pattern/nest/spyrrow_nesting.py"
TEXTS = {".py", ".md", ".toml", ""}  # "" is for LICENSE, which has no ending
ZSTANDARD = b"\x28\xb5\x2f\xfd"  # first bytes of Blender's compressed files
BINARIES = (".so", ".pyd", ".dll", ".dylib", ".a", ".lib", ".exe", ".pyc")
MOST_BYTES = 30e6  # a zip has about 9 MB; a much larger zip has debug symbols or unintended contents

extensions = pytest.mark.parametrize("path", EXTENSIONS, ids=lambda path: path.name)


def test_there_is_an_extension():
    assert EXTENSIONS, "run ./dev package first"


def sha256(content: bytes) -> str:
    """Return the hash in the form of a wheel's RECORD."""
    return "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


@extensions
def test_a_zip_is_for_one_platform_which_its_name_says(path):
    manifest = manifest_of(path)
    (platform,) = manifest["platforms"]
    assert platform in PLATFORMS
    assert path.name == f"{manifest['id']}-{manifest['version']}-{platform}.zip"


@extensions
def test_each_used_permission_and_no_other_is_declared(path):
    nodes = [node for tree in sources_of(path).values() for node in ast.walk(tree)]
    attributes = {node.attr for node in nodes if isinstance(node, ast.Attribute)}
    used = {"files"} if {"write_text", "write_bytes", "write"} & attributes else set()
    used |= {"clipboard"} if "clipboard" in attributes else set()
    assert set(manifest_of(path)["permissions"]) == used


@extensions
def test_all_files_are_in_one_folder_with_plain_names(path):
    names = list(files_of(path))
    assert all(name.isascii() and not re.search(r'[\\:*?"<>|\s]', name) for name in names)
    parts = {part for name in names for part in name.split("/")}
    assert not [part for part in parts if part.startswith(".") or part == "__pycache__"]
    assert len({name.lower() for name in names}) == len(names)
    assert {"__init__.py", "blender_manifest.toml", "LICENSE", "THIRD_PARTY.md"} <= set(names)
    assert b"GNU GENERAL PUBLIC LICENSE\n                       Version 3" in files_of(path)["LICENSE"]
    assert path.stat().st_size < MOST_BYTES


@extensions
def test_nothing_compiled_is_outside_of_wheels_and_nothing_is_obscure(path):
    for name, content in files_of(path).items():
        if name.endswith(".whl"):
            continue
        if name.startswith("samples/"):  # allowed, because Blender opens these files without running scripts in them
            assert name.endswith(".blend") and content.startswith((b"BLENDER", ZSTANDARD)), name
            continue
        assert "." + name.rpartition(".")[2] in TEXTS or "." not in name, name
        assert not name.endswith(BINARIES)
        assert max(map(len, content.decode("utf-8").splitlines()), default=0) < 1000, name  # so that people can read it


@extensions
def test_the_manifest_lists_the_wheels_and_each_is_for_this_platform(path):
    manifest = manifest_of(path)
    assert sorted(manifest["wheels"]) == sorted(f"./{name}" for name in wheels_of(path))
    system, machine = manifest["platforms"][0].split("-")
    words = {"linux": "manylinux", "windows": "win", "macos": "macosx"}
    machines = {"x64": ("x86_64", "amd64", "universal2"), "arm64": ("arm64", "aarch64", "universal2")}
    pythons: dict[str, set[str]] = {}
    for name in wheels_of(path):
        package, _, python, abi, platforms = name.removeprefix("wheels/").removesuffix(".whl").split("-")
        for each in platforms.split("."):
            assert each == "any" or (each.startswith(words[system]) and each.endswith(machines[machine])), name
        pythons.setdefault(package, set()).add("any" if python == "py3" or abi == "abi3" else python)
    for package, tags in pythons.items():
        assert tags in ({"any"}, pythons["wirewarp"]), package
    assert pythons["wirewarp"] == {"cp311", "cp313"} or "blender_version_max" in manifest


@extensions
def test_wheels_are_complete_and_contain_nothing_that_blender_has(path):
    for name, files in wheels_of(path).items():
        package = name.removeprefix("wheels/").split("-")[0]
        assert package.lower() not in IN_BLENDER
        tops = {each.split("/")[0] for each in files}
        assert {top.partition("-")[0].partition(".")[0].lower() for top in tops} == {package.lower()}, tops
        (record,) = (content for each, content in files.items() if each.endswith(".dist-info/RECORD"))
        digests = {each: digest for each, digest, _ in csv.reader(record.decode().splitlines())}
        assert set(digests) == set(files)
        assert all(digest == sha256(files[each]) for each, digest in digests.items() if digest), name  # all unmodified


@extensions
def test_no_network_no_threads_no_installers(path):
    for name, tree in sources_of(path).items():
        forbidden = NETWORK | THREADS | NATIVE | INSTALLERS | {"subprocess"}
        forbidden -= {PROGRAM: {"threading"}, STARTER: {"subprocess"}}.get(name, set())
        assert not forbidden & set(imports(tree)), name


@extensions
def test_paths_and_names_are_not_changed(path):
    """The add-on does not change sys.path or sys.modules, and writes nothing beside its own files.

    It finds its modules by __package__, whatever the name of its repository.
    """
    for name, tree in sources_of(path).items():
        if name in (PROGRAM, STARTER):
            continue
        names = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
        assert not names & {"__file__", "exec", "eval", "compile", "__import__", "globals"}, name
        used = {ast.unparse(node) for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
        assert not used & {"sys.path", "sys.modules", "sys.meta_path", "os.system", "os.chdir"}, name
        if name.split("/")[0] != "wirewarp":
            assert "__name__" not in names, name


@extensions
def test_importing_does_nothing(path):
    for name, tree in sources_of(path).items():
        used = {ast.unparse(node) for node in at_import(tree) if isinstance(node, ast.Attribute)}
        forbidden = ("bpy.ops", "bpy.data", "bpy.context", "bpy.app.handlers", "bpy.app.timers", "bpy.utils.register")
        assert not [each for each in used if each.startswith(forbidden)], name
        assert not [node for node in ast.walk(tree) if isinstance(node, ast.ExceptHandler) and node.type is None], name
