# SPDX-License-Identifier: GPL-3.0-or-later
"""The zips of each platform contain its own wheels, and the manifest lists exactly what is inside."""

import tomllib
import zipfile
from pathlib import Path

import pytest

from tools.environment import StepError
from tools.zips import VERSION, extension_zips, store_zips, write_zips

LINUX = ("cp311-cp311-manylinux_2_28_x86_64", "cp313-cp313-manylinux_2_28_x86_64")
OTHERS = {
    "cp311-cp311-win_amd64": "windows-x64",
    "cp311-cp311-macosx_11_0_arm64": "macos-arm64",
    "cp311-cp311-macosx_10_15_x86_64": "macos-x64",
}


def make_wheels(folder: Path, *tags: str) -> None:
    for tag in tags:
        with zipfile.ZipFile(folder / f"wirewarp-{VERSION}-{tag}.whl", "w") as wheel:
            wheel.writestr("wirewarp/_wirewarp.so", tag)
            wheel.writestr(f"wirewarp-{VERSION}.dist-info/METADATA", "")


@pytest.fixture
def libraries(tmp_path):
    """Return a function that makes wheels of two packages: clipper has one for each Python, and writer has only one."""
    folder = tmp_path / "libraries"
    folder.mkdir()

    def found(platform: str, tag: str) -> list[Path]:
        paths = [folder / f"clipper-1-{tag}-{tag}-{platform}.whl", folder / "writer-2-py3-none-any.whl"]
        for path in paths:
            with zipfile.ZipFile(path, "w") as wheel:
                package = path.name.split("-")[0]
                # ZipInfo has a fixed time, so a wheel that is written again has the same bytes.
                wheel.writestr(zipfile.ZipInfo(f"{package}/__init__.py"), tag)
                wheel.writestr(zipfile.ZipInfo(f"{package}.dist-info/METADATA"), "")
        return paths

    return found


def manifest_of(path: Path) -> tuple[dict, set[str]]:
    with zipfile.ZipFile(path) as archive:
        assert {name.split("/")[0] for name in archive.namelist()} == {"wirewarp_addon"}
        names = {name.removeprefix("wirewarp_addon/") for name in archive.namelist()}
        return tomllib.loads(archive.read("wirewarp_addon/blender_manifest.toml").decode()), names


def test_each_platform_has_an_extension_with_only_its_wheels(tmp_path, libraries):
    make_wheels(tmp_path, *LINUX, *OTHERS)
    written = {path.name for path in write_zips(tmp_path, libraries)}
    platforms = {"linux-x64", *OTHERS.values()}
    assert written == {f"wirewarp-{VERSION}-{kind}{p}.zip" for p in platforms for kind in ("", "legacy-")}
    for tags, platform in ((LINUX, "linux-x64"), *(([tag], platform) for tag, platform in OTHERS.items())):
        manifest, names = manifest_of(tmp_path / f"wirewarp-{VERSION}-{platform}.zip")
        assert manifest["platforms"] == [platform]
        own = [f"./wheels/wirewarp-{VERSION}-{tag}.whl" for tag in tags]
        clippers = [f"./wheels/clipper-1-{tag}-{tag}-{platform}.whl" for tag in (tag[:5] for tag in tags)]
        assert set(manifest["wheels"]) == {*own, *clippers, "./wheels/writer-2-py3-none-any.whl"}
        assert len(manifest["wheels"]) == len(set(manifest["wheels"]))
        assert {name for name in names if name.endswith(".whl")} == {wheel[2:] for wheel in manifest["wheels"]}


def test_the_store_gets_no_zip_that_it_refuses(tmp_path, libraries):
    make_wheels(tmp_path, *LINUX, "cp311-cp311-manylinux_2_28_aarch64", *OTHERS)
    write_zips(tmp_path, libraries)
    arm = tmp_path / f"wirewarp-{VERSION}-linux-arm64.zip"
    assert arm in extension_zips(tmp_path)  # the project's own repository offers it
    assert store_zips(tmp_path) == [path for path in extension_zips(tmp_path) if path != arm]


def test_without_a_wheel_for_python_3_13_newer_blenders_are_left_out(tmp_path, libraries):
    make_wheels(tmp_path, LINUX[0], "cp311-cp311-win_amd64", "cp313-cp313-win_amd64")
    write_zips(tmp_path, libraries)
    linux, _ = manifest_of(tmp_path / f"wirewarp-{VERSION}-linux-x64.zip")
    windows, _ = manifest_of(tmp_path / f"wirewarp-{VERSION}-windows-x64.zip")
    assert linux["blender_version_max"] == "5.1.0"
    assert "blender_version_max" not in windows


def test_the_legacy_zip_contains_the_unpacked_library(tmp_path, libraries):
    make_wheels(tmp_path, *LINUX)
    write_zips(tmp_path, libraries)
    with zipfile.ZipFile(tmp_path / f"wirewarp-{VERSION}-legacy-linux-x64.zip") as archive:
        assert archive.read("wirewarp_addon/_core/wirewarp/_wirewarp.so").decode() == LINUX[0]
        assert archive.read("wirewarp_addon/_core/libraries/clipper/__init__.py").decode() == "cp311"
        assert "wirewarp_addon/_core/libraries/writer/__init__.py" in archive.namelist()
        assert not [name for name in archive.namelist() if "dist-info" in name or "manifest" in name]


def test_the_same_wheels_give_the_same_bytes(tmp_path, libraries):
    make_wheels(tmp_path, *LINUX)
    first = [path.read_bytes() for path in write_zips(tmp_path, libraries)]
    assert [path.read_bytes() for path in write_zips(tmp_path, libraries)] == first


@pytest.mark.parametrize("tag", ["cp311-cp311-linux_x86_64", "cp311-cp311-musllinux_1_2_x86_64"])
def test_a_wheel_that_would_run_on_some_systems_only_is_refused(tmp_path, tag, libraries):
    make_wheels(tmp_path, tag)
    with pytest.raises(StepError, match=f"{tag}.whl is for a platform that Blender does not name"):
        write_zips(tmp_path, libraries)


def test_a_folder_without_wheels_is_refused(tmp_path, libraries):
    with pytest.raises(StepError, match="there is no wheel of WireWarp"):
        write_zips(tmp_path, libraries)
