"""python3 -m eye PROGRAM [ARGUMENTS], or python3 FOLDER/eye PROGRAM: how `eyebridge run` starts a robot program.

As python3 PROGRAM, but with this `eye` and with its time from the first line on: whatever lies beside the program, and
whatever it imports before `eye`.
"""

import sys
import types

import eye  # noqa: F401


def run_program(arguments):
    """Becomes the program arguments[0]."""
    path = arguments[0]
    sys.argv[:] = arguments
    sys.path[0] = path.rpartition("/")[0] or "."
    main = types.ModuleType("__main__")
    main.__file__ = path
    main.__builtins__ = __builtins__
    try:
        with open(path, "rb") as file:
            code = compile(file.read(), path, "exec")
        sys.modules["__main__"] = main  # and it stays: threads may go on when its last line is done
        exec(code, main.__dict__)
    except Exception as error:
        # From the program's own line on, as if python3 had started it.
        trace = error.__traceback__
        while trace is not None and trace.tb_frame.f_code.co_filename == __file__:
            trace = trace.tb_next
        sys.excepthook(type(error), error.with_traceback(trace), trace)
        sys.exit(1)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit("usage: python3 -m eye PROGRAM [ARGUMENTS]")
    run_program(sys.argv[1:])
