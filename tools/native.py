# SPDX-License-Identifier: GPL-3.0-or-later
"""Building and testing the core, with expected input and with random one."""

from tools import core_coverage
from tools.environment import BUILD, DEBIAN_PYTHON, ROOT, require_apt, run, run_quietly, venv
from tools.package import BUILD_APT

CORE_APT = (*BUILD_APT, "libopenmesh-dev")
NATIVE_APT = (*CORE_APT, "libgtest-dev", "libnlopt-dev", "nlohmann-json3-dev")
FUZZ_APT = (*CORE_APT, "clang", "libclang-rt-14-dev")
ATHERIS = ("atheris==3.0.0", "numpy==1.26.4")  # libFuzzer for Python
FEW_CASES, MANY_CASES = 1_000, 10_000
FLATTEN_SECONDS, READER_SECONDS = 600, 120


def build_native(preset: str, *targets: str) -> None:
    run_quietly(f"configuring build/{preset}", ["cmake", "--preset", preset])
    only = ["--target", *targets] if targets else []
    run_quietly(f"building build/{preset}", ["cmake", "--build", "--preset", preset, *only])


def native_tests(preset: str) -> None:
    require_apt(*NATIVE_APT)
    build_native(preset)
    run(["ctest", "--preset", preset, "-j2", "--progress"])


def instrumented_native_tests() -> None:
    """Under the sanitizers, with the core's coverage."""
    core_coverage.begin()
    native_tests("asan")
    core_coverage.show()


def random_cases(count: int = FEW_CASES) -> None:
    """The first so many random cases, under the sanitizers."""
    require_apt(*NATIVE_APT)
    build_native("asan", "wirewarp_random_cases")
    run([BUILD / "asan" / "wirewarp_random_cases", "0", str(count)])


def fuzz() -> None:
    """Many random cases, then inputs that a fuzzer finds, to flatten() and to the add-on's reader of wires.

    What a fuzzer has found interesting is kept in build/fuzz, and is where the next run begins.
    """
    random_cases(MANY_CASES)
    require_apt(*FUZZ_APT)
    build_native("fuzz", "wirewarp_fuzz")
    corpora = {name: BUILD / "fuzz" / f"{name}_corpus" for name in ("flatten", "reader")}
    for corpus in corpora.values():
        corpus.mkdir(exist_ok=True)
    longest = ["-max_len=600", "-len_control=0"]  # bytes; a mesh of 5 by 5 quads with wires takes about 400
    options = [*longest, "-timeout=60", "-print_final_stats=1", f"-artifact_prefix={BUILD / 'fuzz'}/"]
    run([BUILD / "fuzz" / "wirewarp_fuzz", f"-max_total_time={FLATTEN_SECONDS}", *options, corpora["flatten"]])
    python = venv("fuzz", DEBIAN_PYTHON, *ATHERIS)
    reader = ROOT / "tests" / "fuzz" / "fuzz_wire_reader.py"
    run([python, reader, f"-max_total_time={READER_SECONDS}", *options, corpora["reader"]])
