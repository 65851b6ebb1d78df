"""interact: what a control file says to the person who runs it, and asks."""

import sys


class Interact:
    """Prints and prompts in the terminal. interact("text") is interact.prompt("text")."""

    def __init__(self, turns, is_watched):
        self._turns = turns
        self._is_watched = is_watched  # time is real: the world goes on while somebody thinks

    def print(self, *values, sep=" ", end="\n"):
        """As print(), at once."""
        sys.stdout.write(sep.join(map(str, values)) + end)
        sys.stdout.flush()

    def prompt(self, question="", default=None):
        """Asks, and gives the line that was typed. Without an answer (Enter, or nobody is there) `default`; EOFError where
        there is none and nobody is there. While it waits the other routines go on, with --fast the world stands still."""
        self.print(question, end="")
        line = self._turns.outside(sys.stdin.readline, self._is_watched)
        answer = line.rstrip("\n")
        if answer or (line and default is None):
            return answer
        if default is None:
            raise EOFError(f"interact: nobody answers {question!r}, and it has no default")
        return default

    __call__ = prompt

    def confirm(self, question, default=None):
        """Asks for yes or no, again until it is one of them; `default` as prompt()."""
        words = {"y": True, "yes": True, "n": False, "no": False}
        preset = None if default is None else ("yes" if default else "no")
        while True:
            answer = self.prompt(f"{question} (yes/no) ", preset).strip().lower()
            if answer in words:
                return words[answer]
            self.print("Expected yes or no.")

    def wait(self, seconds):
        """Lets so much time of the world pass. time.sleep() does the same."""
        self._turns.spend(max(0.0, float(seconds)))
