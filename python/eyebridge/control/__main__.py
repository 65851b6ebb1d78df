"""python3 -m eyebridge.control FILE [ARGUMENTS]: how `eyebridge run` starts a control file."""

import os
import sys

from .runner import main

if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit("usage: python3 -m eyebridge.control FILE [ARGUMENTS]")
    code = main(sys.argv[1:])
    sys.stdout.flush()
    sys.stderr.flush()
    # Not sys.exit(): a routine that never returns has a thread that cannot be waited for.
    os._exit(code)
