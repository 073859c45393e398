# SPDX-License-Identifier: GPL-3.0-or-later
"""Provides functions for all `dev` commands: a clean environment, apt packages, Pythons, venvs and stamps.

The results do not depend on the caller's PATH and HOME, except that Pythons are searched there.
"""

import hashlib
import os
import platform
import pwd
import shutil
import subprocess
import sys
import time
from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"
DEBIAN_PYTHON = Path("/usr/bin/python3").resolve()  # such as "/usr/bin/python3.11", which Debian's Blender uses
DEBIAN_VERSION = DEBIAN_PYTHON.name.removeprefix("python")
CORES = len(os.sched_getaffinity(0))
FAST_TO_COMPILE = "-Og -DNDEBUG"  # for builds that only show that sources and scripts are complete
TIME_STAMP = "315532800"  # time of files in archives: the beginning of 1980, the earliest that a zip can store
SYSTEM_PATH = "/usr/local/sbin:/usr/sbin:/sbin:/usr/bin:/bin"  # dpkg needs the sbin folders
CALLERS_PATH = os.environ.get("PATH", "")


class StepError(Exception):
    """A step failed. The message is one sentence for the user."""


class NotTestedError(Exception):
    """This machine lacks something that a step needs. The message is a clause that names what is missing."""


def say(text: str) -> None:
    print(f"dev: {text}", flush=True)


def clean_environment(**more: str) -> dict[str, str]:
    """Return the caller's environment variables with the system's PATH and `more`, but without settings of Python."""
    kept = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "VIRTUAL_ENV", "PYENV"))}
    settings = {
        "PATH": SYSTEM_PATH,
        "DEBIAN_FRONTEND": "noninteractive",
        "PIP_DISABLE_PIP_VERSION_CHECK": "1",
        "PIP_ROOT_USER_ACTION": "ignore",
        "PYTHONNOUSERSITE": "1",
        "PYTHONDONTWRITEBYTECODE": "1",
        "CXX": "/usr/bin/g++",  # the same name in all builds, so that all builds share the objects of ccache
        "CCACHE_DIR": str(BUILD / "ccache"),
        "CCACHE_BASEDIR": str(BUILD),  # different build folders share objects, even of files that CMake writes there
        # Without this setting, ccache would store no object that uses precompiled headers.
        "CCACHE_SLOPPINESS": "pch_defines,time_macros",
        "CMAKE_CXX_COMPILER_LAUNCHER": "ccache",
    }
    return kept | settings | more


def check_system() -> None:
    """Raise StepError on a system without the apt and Python of Debian 12 or 13."""
    if DEBIAN_VERSION in ("3.11", "3.13") and shutil.which("dpkg-query", path=SYSTEM_PATH):
        return
    name = platform.freedesktop_os_release()["PRETTY_NAME"]
    raise StepError(
        f"{name} lacks apt with Python 3.11 or 3.13, which Debian 12 and 13 have: work in one of them, for example with"
        " `docker run -it -v .:/wirewarp -w /wirewarp debian:13`"
    )


def run(command: Sequence[str | Path], **more: str) -> None:
    """Run a command in the repository and show its output; `more` are environment variables."""
    done = subprocess.run([str(c) for c in command], cwd=ROOT, env=clean_environment(**more))
    if done.returncode:
        raise StepError(failure(command, done.returncode))


def run_at_once(commands: Sequence[tuple[Sequence[str | Path], dict[str, str]]]) -> None:
    """Run commands at the same time, each with its environment variables, then show their outputs one by one.

    When all commands have ended, raises StepError for the first that failed.
    """
    with ThreadPoolExecutor(len(commands)) as threads:
        done = list(threads.map(_captured, commands))
    for each in done:
        print(each.stdout, end="", flush=True)
    for (command, _), each in zip(commands, done, strict=True):
        if each.returncode:
            raise StepError(failure(command, each.returncode))


def _captured(job: tuple[Sequence[str | Path], dict[str, str]]) -> subprocess.CompletedProcess[str]:
    """Run a command. Its output and errors are captured together."""
    command, more = job
    return subprocess.run(
        [str(c) for c in command],
        cwd=ROOT,
        env=clean_environment(**more),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    )


def run_quietly(what: str, command: Sequence[str | Path], **more: str) -> None:
    """Print what a command does, run it, and show its output only if it fails."""
    begin = time.monotonic()
    say(what)
    done = _captured((command, more))
    if done.returncode:
        print("\n".join(done.stdout.splitlines()[-60:]), flush=True)
        raise StepError(failure(command, done.returncode))
    say(f"  done in {time.monotonic() - begin:.0f} s")


def output_of(command: Sequence[str | Path], **more: str) -> str:
    """Return the output of a command. If the command fails, show the end of its output."""
    words = [str(c) for c in command]
    done = subprocess.run(words, cwd=ROOT, env=clean_environment(**more), capture_output=True, text=True)
    if done.returncode:
        print(done.stdout[-2000:] + done.stderr[-2000:], flush=True)  # only the end, because gcov prints megabytes
        raise StepError(failure(command, done.returncode))
    return done.stdout


def failure(command: Sequence[str | Path], code: int) -> str:
    words = [str(c) for c in command]
    return f"exit code {code} from: {' '.join(words[:6])}{' ...' if len(words) > 6 else ''}"


def fingerprint(paths: Iterable[Path], *more: str) -> str:
    """Return a hash of the files, of all files in the folders, and of `more`."""
    digest = hashlib.sha256("\0".join(more).encode())
    for path in paths:
        files = sorted(p for p in path.rglob("*") if p.is_file()) if path.is_dir() else [path]
        for file in files:
            if "__pycache__" not in file.parts:
                digest.update(str(file.relative_to(ROOT)).encode() + b"\0" + file.read_bytes())
    return digest.hexdigest()


def is_current(stamp: str, key: str) -> bool:
    """Return whether the last set_current() for this stamp had this key."""
    file = BUILD / "stamps" / stamp
    return file.is_file() and file.read_text() == key


def set_current(stamp: str, key: str) -> None:
    file = BUILD / "stamps" / stamp
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(key)


def require_apt(*names: str) -> None:
    """Install the missing Debian packages. Raises StepError with the command if the user may not install packages."""
    query = ["dpkg-query", "-W", "-f", "${Package} ${db:Status-Status}\n", *names]
    listed = subprocess.run(query, capture_output=True, text=True, env=clean_environment()).stdout.splitlines()
    installed = {line.split()[0] for line in listed if line.endswith(" installed")}
    missing = [name for name in names if name not in installed]
    if not missing:
        return
    install = ["apt-get", "install", "-y", "--no-install-recommends", *missing]
    sudo = [] if os.geteuid() == 0 else ["sudo"]
    if sudo and not may_use_sudo():
        raise StepError("run this first, as root, then try again:\n    apt-get update && " + " ".join(install))
    run_quietly("apt-get update", [*sudo, "apt-get", "update", "-q"])
    run_quietly("apt-get install " + " ".join(missing), [*sudo, "env", "DEBIAN_FRONTEND=noninteractive", *install])


def may_use_sudo() -> bool:
    """Return whether sudo needs no password, or somebody can type it."""
    if not shutil.which("sudo", path=SYSTEM_PATH):
        return False
    return sys.stdin.isatty() or subprocess.run(["sudo", "-n", "true"], capture_output=True).returncode == 0


def find_python(version: str) -> Path | None:
    """Return a CPython of this version: Debian's, or one on the caller's PATH or in pyenv, or None."""
    name = f"python{version}"
    homes = {Path(pwd.getpwuid(os.getuid()).pw_dir), Path(os.environ.get("HOME") or "/"), Path("/root")}
    pyenvs = [Path(os.environ["PYENV_ROOT"])] if "PYENV_ROOT" in os.environ else []
    pyenvs += [home / ".pyenv" for home in sorted(homes)]
    candidates = [Path("/usr/bin") / name]
    candidates += [Path(folder) / name for folder in CALLERS_PATH.split(":") if folder]
    candidates += [Path("/usr/local/bin") / name]
    for pyenv in pyenvs:
        if os.access(pyenv / "versions", os.R_OK):
            candidates += sorted((pyenv / "versions").glob(f"{version}*/bin/{name}"), reverse=True)
    return next((c for c in candidates if os.access(c, os.X_OK) and is_python(c, version)), None)


def require_python(version: str) -> Path:
    python = find_python(version)
    if not python:
        raise NotTestedError(f"there is no CPython {version} with headers on PATH or in pyenv")
    return python


def is_python(candidate: Path, version: str) -> bool:
    """Return whether the candidate is a CPython of this version with headers.

    Runs the candidate, because pyenv can have a shim with this name, but not this version.
    """
    question = (
        "import pathlib, sys, sysconfig; print('%d.%d' % sys.version_info[:2], sys.implementation.name,"
        " pathlib.Path(sysconfig.get_path('include'), 'Python.h').exists())"
    )
    answer = subprocess.run([candidate, "-c", question], capture_output=True, text=True, env=clean_environment())
    return answer.stdout.split() == [version, "cpython", "True"]


def venv(name: str, python: Path, *requirements: str) -> Path:
    """Return the Python of the venv build/venvs/NAME with these packages. It is made again if the packages change."""
    folder = (BUILD / "venvs" / name).resolve()  # several clones may share the folder through a link
    interpreter = folder / "bin" / "python"
    key = fingerprint([], str(python), str(folder), *requirements)
    if not (interpreter.exists() and is_current(f"venv-{name}", key)):
        if python == DEBIAN_PYTHON:
            require_apt("python3-venv")
        shutil.rmtree(folder, ignore_errors=True)
        folder.parent.mkdir(parents=True, exist_ok=True)
        run_quietly(f"venv build/venvs/{name}", [python, "-m", "venv", folder])
        pip_install(interpreter, f"pip install {' '.join(requirements)}", *requirements)
        set_current(f"venv-{name}", key)
    return interpreter


def pip_install(interpreter: Path, what: str, *arguments: str | Path) -> None:
    run_quietly(what, [interpreter, "-m", "pip", "install", "--quiet", "--prefer-binary", *arguments])
