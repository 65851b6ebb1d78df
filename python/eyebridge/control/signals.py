"""Ctrl-C and SIGTERM while a run goes on.

Python runs what handles a signal in its main thread, between two steps of Python there: a main thread that waits for the world's next
step, which a person may have paused, or for windows, would not notice. So the main thread does nothing else than wait here.
"""

import contextlib
import signal
import socket
import threading

HANDLED = signal.SIGINT, signal.SIGTERM


def watched(work, told):
    """work() in a thread of its own, and its result; `told(count)` is called with each signal meanwhile, from the first, 1, on."""
    count = 0
    results = []
    failures = []

    def handle(_number, _frame):
        nonlocal count
        count += 1
        told(count)

    # A signal just before a thread's join() begins to wait would be heard when the wait is over; a byte is there to be read.
    heard, bell = socket.socketpair()
    bell.setblocking(False)

    def run():
        try:
            results.append(work())
        except BaseException as failure:
            failures.append(failure)
        with contextlib.suppress(OSError):  # full of signals: heard anyway; or nobody listens any more
            bell.send(b"\0")

    thread = threading.Thread(target=run, name="world", daemon=True)
    before = {number: signal.signal(number, handle) for number in HANDLED}
    bell_before = signal.set_wakeup_fd(bell.fileno(), warn_on_full_buffer=False)
    try:
        thread.start()
        while not (results or failures):
            heard.recv(1)
        thread.join()
    finally:
        signal.set_wakeup_fd(bell_before)
        for number, handler in before.items():
            signal.signal(number, handler)
        heard.close()
        bell.close()
    if failures:
        raise failures[0]
    return results[0]
