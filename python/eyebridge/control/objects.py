"""map_space.add_object("can", 1.0, 0.5): things of the world that a control file puts there, moves and takes away."""

from .robots import COMMAND_COST, READ_COST, finite


class WorldObject:
    """A ball, can, box or polygon of the world. LookupError once it was removed.

    Metres, radians, seconds, in the world; x, y of its middle.
    """

    def __init__(self, world, turns, number):
        self.number = number  # from 1, as the log calls it
        self._world = world
        self._turns = turns

    @property
    def pose(self):
        """x, y, theta."""
        self._turns.spend(READ_COST)
        return self._world.object_pose(self.number)

    @property
    def is_there(self):
        """False once it was removed."""
        self._turns.spend(READ_COST)
        return self._world.is_object_there(self.number)

    def move(self, x, y, theta=None):
        """Puts it somewhere, at rest, with its heading or another. No check: it may be put into a wall."""
        theta = self._world.object_pose(self.number)[2] if theta is None else finite("theta", theta)
        x, y = finite("x", x), finite("y", y)
        self._turns.spend(COMMAND_COST)
        self._world.set_object_pose(self.number, x, y, theta)

    def set_velocity(self, x, y):
        """Kicks it: metres a second along x and y. ValueError for what neither rolls nor slides by itself."""
        x, y = finite("x", x), finite("y", y)
        self._turns.spend(COMMAND_COST)
        self._world.set_object_velocity(self.number, x, y)

    def set_fixed(self, fixed=True):
        """Whether nothing pushes it away from now on. ValueError for what moves by itself."""
        self._turns.spend(COMMAND_COST)
        self._world.set_object_fixed(self.number, bool(fixed))

    def change(self, lines):
        """How it behaves from now on: lines that may follow its own in a .sim file ("mass 2", "path 100 loop 500 500",
        "still", "loose"; docs/worlds.md), millimetres there. ValueError for what cannot be."""
        self._turns.spend(COMMAND_COST)
        self._world.change_object(self.number, lines)

    def remove(self):
        """Takes it out of the world, for good."""
        self._turns.spend(COMMAND_COST)
        self._world.remove_object(self.number)

    def __eq__(self, other):
        return isinstance(other, WorldObject) and other.number == self.number

    def __hash__(self):
        return hash(self.number)

    def __repr__(self):
        return f"<object {self.number}>"
