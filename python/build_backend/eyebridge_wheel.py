"""The hooks that pip calls (PEP 517): a wheel with `eye`, `eyebridge` and the library that both need."""

import os
import pathlib
import subprocess
import sys
import sysconfig
import tomllib

from wheel_file import WheelFile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# libeyebridge, what it loads when it is asked for a video or for markers, and what it becomes for several robots.
LIBRARIES = ("libeyebridge.so.0", "libeyebridge_video.so", "libeyebridge_vision.so", "eyebridge-robots")
PACKED = (".py", ".pyi", ".typed")


def _project():
    with open(ROOT / "pyproject.toml", "rb") as file:
        return tomllib.load(file)["project"]


def _tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{python}-{python}-{platform}"


def _info(project):
    return f"{project['name']}-{project['version']}.dist-info"


def _metadata(project):
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {project['name']}",
        f"Version: {project['version']}",
        f"Summary: {project['description']}",
        f"Requires-Python: {project['requires-python']}",
    ]
    for extra, packages in project.get("optional-dependencies", {}).items():
        lines.append(f"Provides-Extra: {extra}")
        lines += [f'Requires-Dist: {package}; extra == "{extra}"' for package in packages]
    return "\n".join(lines) + "\n"


def _run(*words):
    print("+", *words, flush=True)
    subprocess.run(words, check=True)


def _build():
    """Builds the library and both packages; returns the folder of the build."""
    build = ROOT / "build" / f"wheel-{_tag()}"
    _run(
        "cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON",
        "-DCMAKE_UNITY_BUILD_BATCH_SIZE=12", "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG",
        "-DCMAKE_C_FLAGS_RELEASE=-O2 -DNDEBUG", "-DEYEBRIDGE_WITH_TESTS=OFF", "-DEYEBRIDGE_WITH_BENCH=OFF",
        f"-DPython_EXECUTABLE={sys.executable}",
    )  # fmt: skip
    jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count() or 1)
    _run("cmake", "--build", build, "-j", jobs, "--target", "python_packages")
    if not list((build / "python" / "eyebridge").glob("_core*.so")):
        raise RuntimeError("the module eyebridge was not built; expected python3-dev and pybind11-dev (apt install)")
    return build


def _files(build):
    """What goes into the wheel: pairs of a file and its name there."""
    for package in ("eye", "eyebridge", "eyebridge/control"):
        for path in sorted((ROOT / "python" / package).iterdir()):
            if path.suffix in PACKED:
                yield path, f"{package}/{path.name}"
    for path in sorted((build / "python" / "eyebridge").glob("_co*.so")):  # _core, _control
        yield path, f"eyebridge/{path.name}"
    for name in LIBRARIES:
        path = (build / "lib" / name).resolve()
        if path.exists():
            yield path, f"eyebridge/{name}"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Builds everything and packs it; returns the wheel's name."""
    project = _project()
    build = _build()
    name = f"{project['name']}-{project['version']}-{_tag()}.whl"
    with WheelFile(os.path.join(wheel_directory, name), _info(project)) as wheel:
        for path, inside in _files(build):
            wheel.add_file(path, inside)
        wheel.add_text(f"{_info(project)}/METADATA", _metadata(project))
        wheel.add_text(
            f"{_info(project)}/WHEEL",
            f"Wheel-Version: 1.0\nGenerator: eyebridge\nRoot-Is-Purelib: false\nTag: {_tag()}\n",
        )
    return name


def build_sdist(sdist_directory, config_settings=None):
    """Not offered: the tree itself is what pip installs from."""
    raise RuntimeError("EyeBridge is installed from its source tree: pip install .")
