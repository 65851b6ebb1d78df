"""A wheel is a zip file with a list of its files and their hashes (PEP 427)."""

import base64
import hashlib
import os
import zipfile


class WheelFile:
    """Writes one wheel; use it with `with`. Same contents, same bytes."""

    def __init__(self, path, info):
        self._zip = zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED)
        self._info = info
        self._record = []

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        if kind is None:
            record = f"{self._info}/RECORD"
            self._put(record, ("".join(self._record) + f"{record},,\n").encode(), 0o644)
        self._zip.close()

    def add_file(self, path, name):
        """The file `path` as `name`, executable if it is."""
        with open(path, "rb") as file:
            self._add(name, file.read(), 0o755 if os.access(path, os.X_OK) else 0o644)

    def add_folder(self, folder):
        """All files of `folder`. Links become what they point to; those for the linker, lines that name the library."""
        for path in sorted(folder.rglob("*")):
            name = path.relative_to(folder).as_posix()
            if path.is_symlink() and path.suffix == ".so":
                self.add_text(name, f"INPUT({os.readlink(path)})\n")
            elif path.is_file():
                self.add_file(path, name)

    def add_text(self, name, text):
        """A file with this text."""
        self._add(name, text.encode(), 0o644)

    def _add(self, name, data, mode):
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        self._record.append(f"{name},sha256={digest},{len(data)}\n")
        self._put(name, data, mode)

    def _put(self, name, data, mode):
        entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
        entry.compress_type = zipfile.ZIP_DEFLATED
        entry.external_attr = (0o100000 | mode) << 16
        self._zip.writestr(entry, data)
