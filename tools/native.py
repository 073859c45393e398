# SPDX-License-Identifier: GPL-3.0-or-later
"""Building and testing the core, with expected input and with random one."""

from tools import core_coverage
from tools.environment import (
    BUILD,
    CORES,
    DEBIAN_PYTHON,
    ROOT,
    require_apt,
    run,
    run_quietly,
    venv,
)
from tools.old_glibc import openmesh_source
from tools.package import BUILD_APT

CORE_APT = (*BUILD_APT, "libopenmesh-dev")
NATIVE_APT = (*CORE_APT, "libgtest-dev", "libnlopt-dev")
FUZZ_APT = (*CORE_APT, "clang", "libclang-rt-14-dev")
ATHERIS = ("atheris==3.0.0", "numpy==1.26.4")  # libFuzzer for Python
FEW_CASES, MANY_CASES = 1_000, 10_000
TEST_SECONDS = 600  # ten times what a part of the tests takes under the sanitizers; the last test named is what hangs
FUZZ_SECONDS = {"flatten": 600, "reader": 120}


def build_native(preset: str, *targets: str, **definitions: str) -> None:
    """All targets, if none is named; definitions: variables of CMake."""
    defined = [f"-D{name}={value}" for name, value in definitions.items()]
    run_quietly(f"configuring build/{preset}", ["cmake", "--preset", preset, *defined])
    only = ["--target", *targets] if targets else []
    run_quietly(f"building build/{preset}", ["cmake", "--build", "--preset", preset, "-j", str(CORES), *only])


def run_native_tests(preset: str) -> None:
    """Shows what the parts of the tests print that fail, and the seconds of each part."""
    run(["ctest", "--preset", preset, "-j", str(CORES), "--timeout", str(TEST_SECONDS)])


def native_tests() -> None:
    """On the core as the wheels have it, with the same OpenMesh: then these need not compile it again."""
    require_apt(*NATIVE_APT)
    build_native("release", "wirewarp_tests", FETCHCONTENT_SOURCE_DIR_OPENMESH=str(openmesh_source()))
    run_native_tests("release")


def instrumented_native_tests() -> None:
    """Under the sanitizers, with the core's coverage, and with Debian's OpenMesh."""
    require_apt(*NATIVE_APT)
    build_native("asan")
    core_coverage.begin()
    run_native_tests("asan")
    core_coverage.show()


def random_cases(count: int = FEW_CASES) -> None:
    """The first so many random cases, under the sanitizers."""
    require_apt(*NATIVE_APT)
    build_native("asan", "wirewarp_random_cases")
    core_coverage.begin()  # or what an older build has counted is met
    run([BUILD / "asan" / "wirewarp_random_cases", "0", str(count)])


def fuzz(is_short: bool) -> None:
    """Many random cases, then inputs that a fuzzer finds, to flatten() and to the add-on's reader of wires.

    What a fuzzer has found interesting is kept in build/fuzz, and is where the next run begins.
    """
    share = 0.1 if is_short else 1
    random_cases(round(share * MANY_CASES))
    require_apt(*FUZZ_APT)
    build_native("fuzz", "wirewarp_fuzz")
    corpora = {name: BUILD / "fuzz" / f"{name}_corpus" for name in ("flatten", "reader")}
    for corpus in corpora.values():
        corpus.mkdir(exist_ok=True)
    longest = ["-max_len=600", "-len_control=0"]  # bytes; a mesh of 5 by 5 quads with wires takes about 400
    options = [*longest, "-timeout=60", "-print_final_stats=1", f"-artifact_prefix={BUILD / 'fuzz'}/"]
    time_of = {name: f"-max_total_time={share * seconds:.0f}" for name, seconds in FUZZ_SECONDS.items()}
    run([BUILD / "fuzz" / "wirewarp_fuzz", time_of["flatten"], *options, corpora["flatten"]])
    python = venv("fuzz", DEBIAN_PYTHON, *ATHERIS)
    reader = ROOT / "tests" / "fuzz" / "fuzz_wire_reader.py"
    run([python, reader, time_of["reader"], *options, corpora["reader"]])
