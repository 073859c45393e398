# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the core and tests it, with unit tests and with random input."""

from tools import core_coverage
from tools.environment import BUILD, CORES, DEBIAN_PYTHON, ROOT, require_apt, run, run_quietly, venv
from tools.old_glibc import openmesh_source
from tools.package import BUILD_APT

CORE_APT = (*BUILD_APT, "libopenmesh-dev")
NATIVE_APT = (*CORE_APT, "libgtest-dev", "libnlopt-dev")
FUZZ_APT = (*CORE_APT, "clang", "libclang-rt-dev")
ATHERIS = ("atheris==3.0.0", "numpy==1.26.4")  # atheris is libFuzzer for Python
FEW_CASES, MANY_CASES = 250, 10_000
TEST_SECONDS = 1500  # limit for a part of the tests; under the sanitizers, a part takes half a minute of one core
# The address sanitizer records this many callers of each allocation. Recording 30, the default, would take up to a
# tenth of the time of the tests.
FEW_CALLERS = {"ASAN_OPTIONS": "malloc_context_size=5"}
FUZZ_SECONDS = {"flatten": 600, "reader": 120}


def build_native(preset: str, *targets: str, **definitions: str) -> None:
    """Build these targets, or all targets if none is named. definitions: CMake variables."""
    defined = [f"-D{name}={value}" for name, value in definitions.items()]
    run_quietly(f"configuring build/{preset}", ["cmake", "--preset", preset, *defined])
    only = ["--target", *targets] if targets else []
    run_quietly(f"building build/{preset}", ["cmake", "--build", "--preset", preset, "-j", str(CORES), *only])


def run_native_tests(preset: str) -> None:
    """Run the tests in parts. Show the output of parts that fail, and the seconds of each part."""
    run(["ctest", "--preset", preset, "-j", str(CORES), "--timeout", str(TEST_SECONDS)], **FEW_CALLERS)


def native_tests() -> None:
    """Test the core with the OpenMesh that the wheels use, so that ccache then has the objects to build the wheels."""
    require_apt(*NATIVE_APT)
    build_native("release", "wirewarp_tests", FETCHCONTENT_SOURCE_DIR_OPENMESH=str(openmesh_source()))
    run_native_tests("release")


def instrumented_native_tests() -> None:
    """Test the core under the sanitizers, with Debian's OpenMesh, and show the coverage."""
    require_apt(*NATIVE_APT)
    build_native("asan")
    core_coverage.begin()
    run_native_tests("asan")
    core_coverage.show()


def random_cases(count: int = FEW_CASES) -> None:
    require_apt(*NATIVE_APT)
    build_native("asan", "wirewarp_random_cases")
    core_coverage.begin()  # deletes counts of an earlier build, with which new counts cannot be merged
    run([BUILD / "asan" / "wirewarp_random_cases", "0", str(count)], **FEW_CALLERS)


def fuzz(is_short: bool) -> None:
    """Run many random cases, then two fuzzers: on flatten(), and on the add-on's reader of wires.

    Interesting inputs are kept in build/fuzz, and the next run starts from them.
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
