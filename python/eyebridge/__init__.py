"""Worlds and robots for Python: load a scenario, step it, read sensors and pictures as numpy arrays.

    import eyebridge

    with eyebridge.Simulation(eyebridge.load_scenario("worlds/maze-8.maz"), seed=7) as sim:
        robot = sim.robots[0]
        while sim.time < 60 and robot.psd(1) > 0.1:
            robot.set_speed(0.3)
            sim.step()
        print(sim.poses)

Metres, radians, seconds; x forward, y left, angles counter-clockwise. The same calls with the same seed give the same
bits. Any thread may call; calls on one simulation wait for each other, and let other threads of the program run. Signatures,
ranges and failures: __init__.pyi; training: Episode and VectorEnv. For robot programs, which know nothing of a simulation, there is `eye`.
"""

from ._core import (
    Camera,
    ConfigError,
    DStarLite,
    DynamicWindow,
    GridSlam,
    LandmarkEkf,
    MonteCarlo,
    OccupancyGrid,
    PurePursuit,
    Robot,
    RobotMapper,
    ScanMatcher,
    Scenario,
    Simulation,
    default_scenario,
    explore,
    load_scenario,
    plan,
)
from ._version import __version__
from .episode import Episode

__all__ = [
    "Camera",
    "ConfigError",
    "DStarLite",
    "DynamicWindow",
    "Episode",
    "GridSlam",
    "LandmarkEkf",
    "MonteCarlo",
    "OccupancyGrid",
    "PurePursuit",
    "Robot",
    "RobotMapper",
    "ScanMatcher",
    "Scenario",
    "Simulation",
    "VectorEnv",
    "default_scenario",
    "explore",
    "load_scenario",
    "plan",
]


def __getattr__(name):
    # Of all here only VectorEnv is written with numpy: the rest is imported without.
    if name == "VectorEnv":
        from .vector import VectorEnv

        return VectorEnv
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
