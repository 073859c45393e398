# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds examples/cpp as its users do: with the installed library, and from its sources."""

import re
import shutil
from pathlib import Path

from tools.environment import BUILD, CORES, FAST_TO_COMPILE, ROOT, StepError, output_of, require_apt, run_quietly
from tools.native import NATIVE_APT, build_native
from tools.old_glibc import openmesh_source

FOLDER = BUILD / "example"


def example_tests() -> None:
    """Check that both programs print the lines in docs/cpp.md. Raises StepError if they do not."""
    require_apt(*NATIVE_APT)
    openmesh = {"FETCHCONTENT_SOURCE_DIR_OPENMESH": str(openmesh_source())}
    build_native("release", "wirewarp", **openmesh)
    shutil.rmtree(FOLDER, ignore_errors=True)
    prefix = FOLDER / "prefix"
    install: list[str | Path] = ["cmake", "--install", BUILD / "release", "--prefix", prefix]
    run_quietly("installing the library", [*install, "--component", "development"])
    elsewhere = prefix.rename(FOLDER / "moved")  # moved, because installed files must not depend on their path
    # The program is compiled for this processor, unlike the library. A program with AVX must still be able to free the
    # library's arrays.
    build_and_check("installed", CMAKE_PREFIX_PATH=str(elsewhere), CMAKE_CXX_FLAGS="-march=native")
    commands = (FOLDER / "installed" / "compile_commands.json").read_text()
    if "eigen3" in commands or "openmesh" in commands.lower():
        raise StepError("the installed library needs headers from elsewhere: see build/example/installed")
    flags = {"CMAKE_CXX_FLAGS_RELEASE": FAST_TO_COMPILE, "CMAKE_COMPILE_WARNING_AS_ERROR": "ON"}
    build_and_check("from-source", WIREWARP_FROM_SOURCE="ON", **flags, **openmesh)


def build_and_check(name: str, **definitions: str) -> None:
    definitions |= {"CMAKE_BUILD_TYPE": "Release", "CMAKE_EXPORT_COMPILE_COMMANDS": "ON"}
    defined = [f"-D{key}={value}" for key, value in definitions.items()]
    folder = FOLDER / name
    configure: list[str | Path] = ["cmake", "-G", "Ninja", "-S", ROOT / "examples" / "cpp", "-B", folder]
    run_quietly(f"configuring build/example/{name}", [*configure, *defined])
    build: list[str | Path] = ["cmake", "--build", folder, "-j", str(CORES), "--target", "flatten_dome"]
    run_quietly(f"building build/example/{name}", build)
    printed = output_of([folder / "flatten_dome"])
    expected = re.findall(r"```\n(rigid: .*?)```", (ROOT / "docs" / "cpp.md").read_text(), re.DOTALL)
    if [printed] != expected:
        raise StepError(f"build/example/{name}/flatten_dome prints other lines than docs/cpp.md contains:\n{printed}")
