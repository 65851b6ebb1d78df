"""An sdist is a .tar.gz of the source with one folder in it."""

import gzip
import io
import os
import subprocess
import tarfile


def tracked_files(root):
    """Files that git knows below `root`, and their commit, which ends in -modified if they differ from it."""

    def git(*words):
        command = ["git", "-c", "safe.directory=*", "--no-optional-locks", "-C", str(root), *words]
        try:
            return subprocess.run(command, check=True, capture_output=True, text=True).stdout
        except FileNotFoundError:
            raise RuntimeError("an sdist has the files that git knows: expected git (apt install git)") from None
        except subprocess.CalledProcessError as error:
            raise RuntimeError(f"an sdist has the files that git knows, but git says of {root}: {error.stderr.strip()}") from None

    top = git("rev-parse", "--show-toplevel").strip()
    if not os.path.samefile(top, root):
        raise RuntimeError(f"an sdist has the files that git knows, but {root} is only a folder in the repository {top}")
    commit = git("rev-parse", "--verify", "HEAD").strip()
    if git("status", "--porcelain", "--untracked-files=no"):
        commit += "-modified"
    files = [file for file in git("ls-files", "-z").split("\0") if file and os.path.lexists(root / file)]
    return files, commit


class SourceArchive:
    """Writes one sdist; use it with `with`. Same contents, same bytes."""

    def __init__(self, path, folder):
        self._file = open(path, "wb")
        self._zip = gzip.GzipFile("", "wb", fileobj=self._file, mtime=0)
        self._tar = tarfile.open(fileobj=self._zip, mode="w", format=tarfile.PAX_FORMAT)
        self._folder = folder

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        for file in (self._tar, self._zip, self._file):
            file.close()

    def add_file(self, path, name):
        """The file `path` as `name`, executable if it is."""
        with open(path, "rb") as file:
            self._add(name, file.read(), 0o755 if os.access(path, os.X_OK) else 0o644)

    def add_text(self, name, text):
        """A file with this text."""
        self._add(name, text.encode(), 0o644)

    def _add(self, name, data, mode):
        entry = tarfile.TarInfo(f"{self._folder}/{name}")
        entry.size, entry.mode, entry.mtime = len(data), mode, 315532800  # 1980, as in a wheel
        self._tar.addfile(entry, io.BytesIO(data))
