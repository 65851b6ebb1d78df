"""python3 -m eyebridge: the command line. It is also what pip installs as eyebridge, eyebridge-cc and the other commands."""

import os
import sys


def _folder():
    """The nearest folder `bin` above this package that has the command: in a wheel, an installation or a build folder."""
    here = os.path.dirname(os.path.abspath(__file__))
    above = here
    while True:
        folder = os.path.join(above, "bin")
        if os.access(os.path.join(folder, "eyebridge"), os.X_OK):
            return folder
        if above == os.path.dirname(above):
            sys.exit(f"eyebridge: found no bin/eyebridge in {here} or a folder above it: install EyeBridge again")
        above = os.path.dirname(above)


def main():
    """Becomes the program that has this one's name: `eyebridge`, or a compiler."""
    name = os.path.basename(sys.argv[0])
    program = os.path.join(_folder(), "eyebridge" if name == "__main__.py" else name)
    if sys.prefix != sys.base_prefix:
        # As where the virtual environment is active: robot programs in Python run in it.
        os.environ["VIRTUAL_ENV"] = sys.prefix
        os.environ["PATH"] = os.path.join(sys.prefix, "bin") + os.pathsep + os.environ.get("PATH", os.defpath)
    os.execv(program, [program, *sys.argv[1:]])


if __name__ == "__main__":
    main()
