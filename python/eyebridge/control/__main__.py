"""python3 -m eyebridge.control FILE [ARGUMENTS]: how `eyebridge run` starts a control file."""

import sys
import traceback

from .runner import leave, main

if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit("usage: python3 -m eyebridge.control FILE [ARGUMENTS]")
    code = 1
    try:
        code = main(sys.argv[1:])
    except Exception:
        traceback.print_exc()
    finally:
        # Not sys.exit(): a routine that never returns has a thread that cannot be waited for, and windows
        # look at what Python would take away.
        leave(code)
