"""What pyproject.toml says of the project, as wheels and sdists carry it; the version is CMake's."""

import re
import tomllib


class Metadata:
    """Of the source tree `root`."""

    def __init__(self, root):
        with open(root / "pyproject.toml", "rb") as file:
            self._project = tomllib.load(file)["project"]
        found = re.search(r"^project\(EyeBridge VERSION (\d+\.\d+\.\d+) ", (root / "CMakeLists.txt").read_text(), re.M)
        if not found:
            raise RuntimeError(f"{root}/CMakeLists.txt: expected a line `project(EyeBridge VERSION 1.2.3 ...`")
        self._version = found[1]
        self._readme = (root / self._project["readme"]).read_text()
        #: What the names of all that is made begin with.
        self.stem = f"{self._project['name']}-{self._version}"

    def text(self):
        """METADATA of a wheel, PKG-INFO of an sdist."""
        project = self._project
        lines = [
            "Metadata-Version: 2.1",
            f"Name: {project['name']}",
            f"Version: {self._version}",
            f"Summary: {project['description']}",
            f"License-File: {project['license']['file']}",
            f"Requires-Python: {project['requires-python']}",
            "Description-Content-Type: text/markdown",
        ]
        for extra, packages in project["optional-dependencies"].items():
            lines.append(f"Provides-Extra: {extra}")
            lines += [f'Requires-Dist: {package}; extra == "{extra}"' for package in packages]
        return "\n".join(lines) + "\n\n" + self._readme

    def entry_points(self):
        """The commands that pip makes."""
        return "[console_scripts]\n" + "".join(f"{name} = {place}\n" for name, place in self._project["scripts"].items())
