# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that a module for another system needs nothing that the system lacks. Prints a line for each fault.

    python -m tools.module_needs PLATFORM MODULE VERSION LIBSYSTEM

Linkers do not find all faults.
"""

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import lief

LIEF = "lief==1.0.0"
PYTHONS_OWN = re.compile(r"_{0,3}Py[A-Z_]")  # Python's functions and objects; macOS puts a "_" before them
MACHINES = {
    "linux-x64": "X86_64",
    "linux-arm64": "AARCH64",
    "windows-x64": "AMD64",
    "macos-arm64": "ARM64",
    "macos-x64": "X86_64",
}
GLIBC = r"lib(c|m|pthread|dl)\.so\.\d+|ld-linux-.*"
WINDOWS = r"KERNEL32\.dll|api-ms-win-crt-.*\.dll"  # Windows 10 and later contain the C runtime
MACOS = r"/usr/lib/libSystem\.B\.dylib"


def faults(platform: str, module: Path, oldest: tuple[int, ...], system: Path) -> list[str]:
    """Return one sentence for each fault.

    oldest: oldest version of glibc or macOS on which the module must work, unused for Windows.
    system: the file libSystem.tbd, which lists the names in macOS' libSystem.
    """
    import lief  # imported here, because only the Python that runs this program has lief

    lief.logging.disable()
    binary = lief.parse(str(module))
    if isinstance(binary, lief.ELF.Binary):
        machine, allowed, libraries = binary.header.machine_type, GLIBC, binary.libraries
        found = elf_faults(binary, oldest)
    elif isinstance(binary, lief.MachO.Binary):
        machine, allowed = binary.header.cpu_type, MACOS
        libraries = [library.name for library in binary.libraries if library.command.name != "ID_DYLIB"]
        found = macho_faults(binary, oldest, system)
    elif isinstance(binary, lief.PE.Binary):
        version = re.sub(r"_wirewarp\.cp(\d+)-.*", r"\1", module.name)
        machine, allowed = binary.header.machine, rf"{WINDOWS}|python{version}\.dll"
        libraries = [library.name for library in binary.imports]
        found = []
    else:
        return [f"{module.name} is not a module of a known system"]
    if machine.name != MACHINES[platform]:
        found.append(f"is made for {machine.name}")
    found += [f"needs the library {name}" for name in libraries if not re.fullmatch(allowed, name)]
    return [f"{module.name} {fault}" for fault in found]


def elf_faults(binary: "lief.ELF.Binary", oldest: tuple[int, ...]) -> list[str]:
    found = []
    for library in binary.symbols_version_requirement:
        for version in library.get_auxiliary_symbols():
            name, _, number = version.name.partition("_")
            if name == "GLIBC" and tuple(map(int, number.split("."))) > oldest:
                found.append(f"needs {version.name} of {library.name}")
    for symbol in list(binary.dynamic_symbols)[1:]:  # the first symbol is empty
        has_version = symbol.has_version and symbol.symbol_version.has_auxiliary_version
        is_defined = symbol.shndx != 0
        if not (is_defined or has_version or symbol.binding.name == "WEAK" or is_pythons(symbol.name)):
            found.append(f"needs {symbol.name}, which no library has")
    return found


def macho_faults(binary: "lief.MachO.Binary", oldest: tuple[int, ...], system: Path) -> list[str]:
    # For macOS, the linker accepts every undefined name, because it may be Python's.
    offered = set(re.findall(r"[\w$]+", system.read_text()))
    found = [
        f"needs {symbol.name}, which no library has"
        for symbol in binary.imported_symbols
        if not (symbol.name in offered or is_pythons(symbol.name))
    ]
    if tuple(binary.build_version.minos[: len(oldest)]) > oldest:
        found.append(f"needs macOS {'.'.join(map(str, binary.build_version.minos))}")
    if binary.header.cpu_type.name == "ARM64" and not binary.has_code_signature:
        found.append("has no signature, without which ARM loads nothing")
    return found


def is_pythons(name: str) -> bool:
    return PYTHONS_OWN.match(name) is not None


if __name__ == "__main__":
    platform, module, oldest, system = sys.argv[1:]
    for fault in faults(platform, Path(module), tuple(map(int, oldest.split("."))), Path(system)):
        print(fault)
