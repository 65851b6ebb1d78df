#!/usr/bin/env python3
"""Changes an unpacked linux-source-6.1 for the lab; ends with a message when it is not as expected.

change_source.py FOLDER
"""

import pathlib
import re
import sys


def change(path: pathlib.Path, pattern: str, replacement: str, flags: int = 0) -> None:
    text = path.read_text()
    changed, count = re.subn(pattern, replacement, text, flags=flags)
    if count != 1:
        sys.exit(f"{path}: {count} places look like {pattern!r}; expected one: not the 6.1 source?")
    path.write_text(changed)


def main() -> None:
    root = pathlib.Path(sys.argv[1])

    # Frame times of vivid and CAN time-outs are counted in ticks: 1 ms each instead of 10.
    change(root / "arch/um/Kconfig", r"(config HZ\n(?:\t.*\n)*?\tdefault) 100\n", r"\1 1000\n")

    # A signal frame has room for xmm and ymm registers only, so a handler that uses AVX-512 spoils
    # the program's: make the frame as large as the state that the kernel keeps, and copy all of it.
    signal = root / "arch/x86/um/signal.c"
    state = r"struct _xstate"
    change(signal, rf"(\t{state} fpstate;\n)(\}};)",
           r"\1\tchar more_fpstate[MAX_FP_NR * sizeof(long) - sizeof(struct _xstate)];\n\2")
    change(signal, rf"(\(void \*\)sc\.fpstate,\s*)sizeof\({state}\)", r"\1sizeof(regs->regs.fp)")
    change(signal, rf"(copy_to_user\(to_fp, regs->regs\.fp, )sizeof\({state}\)",
           r"\1sizeof(regs->regs.fp)")


if __name__ == "__main__":
    main()
