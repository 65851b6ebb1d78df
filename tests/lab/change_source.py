#!/usr/bin/env python3
"""Changes an unpacked linux-source-6.1 or -6.12 for the lab; ends with a message when it is not as expected.

change_source.py FOLDER BYTES: FOLDER holds the source; BYTES is the room for floating-point and vector registers.
"""

import pathlib
import re
import sys

OLD_ROOM = 2696  # bytes: x87, xmm, ymm, zmm, mask and protection key registers


def change(path: pathlib.Path, pattern: str, replacement: str, flags: int = 0) -> None:
    text = path.read_text()
    changed, count = re.subn(pattern, replacement, text, flags=flags)
    if count != 1:
        sys.exit(f"{path}: {count} places look like {pattern!r}; expected one: not the source of 6.1 or 6.12?")
    path.write_text(changed)


def main() -> None:
    root = pathlib.Path(sys.argv[1])
    room = int(sys.argv[2])
    if room < OLD_ROOM or room % 64:
        sys.exit(f"{room} bytes for registers; expected a multiple of 64, at least {OLD_ROOM}")

    # Frame times of vivid and CAN time-outs are counted in ticks: 1 ms each instead of 10.
    change(root / "arch/um/Kconfig", r"(config HZ\n(?:\t.*\n)*?\tdefault) 100\n", r"\1 1000\n")

    # ptrace() refuses to set registers from a smaller area than the processor's: 2,696 bytes in Debian's source, 11,008 are
    # needed where there is AMX.
    change(root / "arch/x86/um/user-offsets.c", rf"(DEFINE_LONGS\(HOST_FP_SIZE, ){OLD_ROOM}\)", rf"\g<1>{room})")

    # shrink_dcache_parent() repeats its loop while another process frees some of the same directory entries. In simulated
    # time that loop never ends: no time passes, so the timer never lets the other process run. Sleep for one tick instead.
    # (Seen in /proc when a program with threads ended.)
    change(root / "fs/dcache.c", r"(\t\tcond_resched\(\);\n\t\tif \(!data\.found\)\n\t\t\tbreak;\n)",
           r"\1\t\tschedule_timeout_uninterruptible(1);\n")

    # A signal frame has room for xmm and ymm registers only, so a handler that uses AVX-512 spoils the program's: make the
    # frame larger, and copy all of it. The tiles of AMX, which come after that, stay out: no program in the guest can use
    # them (that takes arch_prctl() of the host), and a frame with them would not fit the usual signal stack, SIGSTKSZ.
    signal = root / "arch/x86/um/signal.c"
    state = r"struct _xstate"
    change(signal, rf"(\t{state} fpstate;\n)(\}};)",
           rf"\1\tchar more_fpstate[{OLD_ROOM} - sizeof(struct _xstate)];\n\2")
    change(signal, rf"(\(void \*\)sc\.fpstate,\s*)sizeof\({state}\)", rf"\g<1>{OLD_ROOM}")
    change(signal, rf"(copy_to_user\(to_fp, regs->regs\.fp, )sizeof\({state}\)", rf"\g<1>{OLD_ROOM}")


if __name__ == "__main__":
    main()
