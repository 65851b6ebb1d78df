"""Ctrl-C and SIGTERM while a run goes on.

Python runs what handles a signal in its main thread, between two steps of Python there: a main thread that waits for the world's next
step, which a person may have paused, or for windows, would not notice. So the main thread does nothing else than wait here.
"""

import signal
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

    def run():
        try:
            results.append(work())
        except BaseException as failure:
            failures.append(failure)

    thread = threading.Thread(target=run, name="world", daemon=True)
    before = {number: signal.signal(number, handle) for number in HANDLED}
    try:
        thread.start()
        thread.join()
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    if failures:
        raise failures[0]
    return results[0]
