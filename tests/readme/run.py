#!/usr/bin/env python3
"""run.py: types the commands of README.md and of docs/ on this machine, in order, in this folder, and looks at what each does.

For a machine of its own (tests/machines/readme): it installs packages and stands in for devices in /dev.
"""

import glob
import os
import re
import select
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import commands
import pages

LIMIT = 1200  # seconds for one command
PATIENCE = 60  # seconds until what stands beside the computer is there
DISPLAY = ":97"


class Failed(Exception):
    pass


def windows():
    tree = subprocess.run(["xwininfo", "-root", "-tree", "-display", DISPLAY], capture_output=True, text=True)
    return re.findall(r'"([^"]*)"', tree.stdout)


def is_there(what):
    kind, _, name = what.partition(":")
    if kind == "file":
        return Path(name).exists()
    return any(name in title for title in windows())


def wait_for(what, process, patience=PATIENCE):
    end = time.monotonic() + patience
    while not is_there(what):
        if process.poll() is not None:
            raise Failed(f"ended ({process.returncode}) before {what} was there")
        if time.monotonic() > end:
            raise Failed(f"{what} is not there after {patience} s")
        select.select([], [], [], 0.05)


def end(process, number=signal.SIGTERM):
    """Ends it with all that it started."""
    try:
        os.killpg(process.pid, number)
    except ProcessLookupError:
        pass


class Reader:
    """The shell of somebody who types the commands: what one exports, the next one has."""

    def __init__(self):
        self.environment = dict(os.environ)
        self.beside = {}  # what stands beside the computer, by its command
        self.screen = self.start(f"exec Xvfb {DISPLAY} -screen 0 1600x1200x24 -nolisten tcp", subprocess.DEVNULL)

    def start(self, command, output):
        return subprocess.Popen(["bash", "-c", command], stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                                env=self.environment, start_new_session=True)

    def put_beside(self, row):
        if not row.beside or row.beside in self.beside:
            return
        process = self.beside[row.beside] = self.start(row.beside, subprocess.DEVNULL)
        wait_for(row.shows, process)

    def type(self, command, stop=""):
        """Its exit code and its output."""
        with tempfile.NamedTemporaryFile() as output, tempfile.NamedTemporaryFile() as exported:
            process = self.start(f'{command}\nstatus=$?\nenv -0 >{exported.name}\nexit $status', output)
            try:
                if stop:
                    self.stop(process, stop, output)
                status = process.wait(LIMIT)
            except subprocess.TimeoutExpired:
                raise Failed(f"has not ended after {LIMIT} s\n{Path(output.name).read_text(errors='replace')}") from None
            finally:
                end(process, signal.SIGKILL)
            variables = Path(exported.name).read_text().split("\0")
            if variables != [""] and not stop:  # nothing: it was killed
                self.environment = dict(variable.split("=", 1) for variable in variables if variable)
            # A shell that Ctrl-C has ended, too, counts as one that tells of it: 130.
            return (128 - status if status < 0 else status), Path(output.name).read_text(errors="replace")

    def stop(self, process, stop, output):
        """Ctrl-C, as soon as that is there or, for `prints:`, stands in its output."""
        if stop.startswith("prints:"):
            deadline = time.monotonic() + LIMIT
            while not re.search(stop[7:], Path(output.name).read_text(errors="replace")):
                if process.poll() is not None or time.monotonic() > deadline:
                    return
                select.select([], [], [], 0.05)
        else:
            wait_for(stop, process, LIMIT)
        end(process, signal.SIGINT)

    def try_row(self, row):
        if row.before:
            status, output = self.type(f"set -e\n{row.before}")
            if status != 0:
                raise Failed(f"what must be there before cannot be made:\n{output}")
        self.put_beside(row)
        began = time.time()
        typed = row.first + (row.typed or row.command)
        # With a display every run would open windows, which stay until somebody closes them.
        if "window:" in row.stop + row.shows:
            typed = f"DISPLAY={DISPLAY} {typed}"
        if row.within:
            typed = f"{row.within} bash -c '{typed.replace(chr(39), chr(39) + chr(92) + chr(39) + chr(39))}'"
        status, output = self.type(typed, row.stop)
        if status != row.exit:
            raise Failed(f"exit code {status}, expected {row.exit}\n{output}")
        if row.prints and not re.search(row.prints, output):
            raise Failed(f"nothing like {row.prints!r} in its output\n{output}")
        for name in row.leaves:
            if not any(os.lstat(path).st_ctime >= began - 1 for path in glob.glob(name)):
                raise Failed(f"leaves no new {name}\n{output}")


def main():
    if sys.argv[1:] not in ([], ["--compare"]):
        sys.exit(f"run.py: found {' '.join(sys.argv[1:])}, expected nothing or --compare: without it, it types every command")
    root = Path.cwd()
    rows = {(row.page, row.command): row for row in commands.ROWS}
    on_pages = pages.all_commands(root)
    differences = [f"{page}: {command}\n    no row in tests/readme/commands.py" for page, command in on_pages if (page, command) not in rows]
    differences += [f"{page}: {command}\n    is not on the page" for page, command in rows if (page, command) not in on_pages]
    if differences:
        sys.exit("\n".join(["tests/readme: pages and rows differ:"] + differences))
    if "--compare" in sys.argv:
        print(f"{len(rows)} commands on {len({page for page, _ in on_pages})} pages, a row for each")
        return

    # A shell starts background jobs with SIGINT and SIGQUIT ignored, and every command here would inherit that.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.signal(signal.SIGQUIT, signal.SIG_DFL)
    reader, failed, elsewhere = Reader(), 0, 0
    for page, command in on_pages:
        row, began = rows[page, command], time.monotonic()
        if row.elsewhere:
            elsewhere += 1
            print(f"elsewhere  {page}: {command}\n           {row.elsewhere}", flush=True)
            continue
        try:
            reader.try_row(row)
            print(f"{time.monotonic() - began:7.1f} s  {page}: {command}", flush=True)
        except Failed as problem:
            failed += 1
            text = "\n".join(str(problem).splitlines()[-40:])
            print(f"   FAILED  {page}: {command}\n{text}", flush=True)
    for process in [*reader.beside.values(), reader.screen]:
        end(process)
    print(f"{len(on_pages) - failed - elsewhere} commands do what the pages say, {failed} do not, {elsewhere} are run elsewhere")
    sys.exit(1 if failed else 0)


main()
