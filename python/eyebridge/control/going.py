"""keep_going: whether a control file shall go on."""

CHECK_COST = 0.001  # seconds: a loop of nothing else must not stand still


class KeepGoing:
    """True until somebody stops the run: Ctrl-C, the last window closed, the time limit. `while keep_going():`; as a value,
    `while keep_going:`, too."""

    def __init__(self, turns):
        self._turns = turns
        self._is_on = True

    def __call__(self):
        self._turns.spend(CHECK_COST)
        return self._is_on

    __bool__ = __call__

    def stop(self):
        """From now on False, for all routines."""
        self._is_on = False

    @property
    def is_on(self):
        """The same without its time."""
        return self._is_on
