"""The hooks that pip calls (PEP 517): a wheel with an installation of EyeBridge in it, and the sources for one."""

import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import sysconfig

from metadata import Metadata
from source_archive import SourceArchive, tracked_files
from wheel_file import WheelFile

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMPONENTS = ("runtime", "development", "python")


def _tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{python}-{python}-{platform}"


def _run(*words):
    print("+", *words, flush=True)
    subprocess.run(words, check=True)


def _installed():
    """Builds and installs; returns the folder that becomes the wheel. The installation's prefix is its folder eyebridge."""
    # The same flags as in the preset `release`: after ./run the compiler's cache has nearly all objects.
    build = ROOT / "build" / f"wheel-{_tag()}"
    _run(
        "cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=12",
        "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG", "-DCMAKE_C_FLAGS_RELEASE=-O2 -DNDEBUG", "-DCMAKE_INSTALL_LIBDIR=lib", "-DEYEBRIDGE_PYTHON_DIR=..",
        "-DEYEBRIDGE_WITH_TESTS=OFF", "-DEYEBRIDGE_WITH_BENCH=OFF", "-DEYEBRIDGE_WITH_GUI=OFF", "-DEYEBRIDGE_WITH_CORTEX=OFF",
        f"-DPython_EXECUTABLE={sys.executable}", *shlex.split(os.environ.get("CMAKE_ARGS", "")),
    )  # fmt: skip
    jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count() or 1)
    _run("cmake", "--build", build, "-j", jobs, "--target", "installable")
    if not list((build / "python" / "eyebridge").glob("_core*.so")):
        raise RuntimeError("the module eyebridge was not built; expected python3-dev and pybind11-dev (apt install)")
    folder = build / "wheel"
    shutil.rmtree(folder, ignore_errors=True)
    for component in COMPONENTS:
        _run("cmake", "--install", build, "--prefix", folder / "eyebridge", "--component", component, "--strip")
    return folder


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Builds everything and packs it; returns the wheel's name."""
    metadata = Metadata(ROOT)
    folder = _installed()
    name = f"{metadata.stem}-{_tag()}.whl"
    info = f"{metadata.stem}.dist-info"
    with WheelFile(os.path.join(wheel_directory, name), info) as wheel:
        wheel.add_folder(folder)
        wheel.add_file(ROOT / "LICENSE", f"{info}/LICENSE")
        wheel.add_text(f"{info}/METADATA", metadata.text())
        wheel.add_text(f"{info}/entry_points.txt", metadata.entry_points())
        wheel.add_text(
            f"{info}/WHEEL",
            f"Wheel-Version: 1.0\nGenerator: eyebridge\nRoot-Is-Purelib: false\nTag: {_tag()}\n",
        )
    return name


def build_sdist(sdist_directory, config_settings=None):
    """Packs the files that git knows, as they are now, with their commit; returns the archive's name."""
    metadata = Metadata(ROOT)
    name = f"{metadata.stem}.tar.gz"
    files, commit = tracked_files(ROOT)
    with SourceArchive(os.path.join(sdist_directory, name), metadata.stem) as archive:
        for file in files:
            if file == "cmake/commit.txt":  # as `git archive` does: see cmake/EyebridgeCommit.cmake
                archive.add_text(file, f"{commit}\n")
            else:
                archive.add_file(ROOT / file, file)
        archive.add_text("PKG-INFO", metadata.text())
    return name
