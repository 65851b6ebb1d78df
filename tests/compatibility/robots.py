"""The robots of worlds/robots as rows of docs/compatibility.md: which devices of theirs are modelled, and how."""

import pathlib
import re

HEAD = ["robot", "drive", "motors", "encoders", "PSDs", "servos", "camera", "LIDAR", "more"]
DRIVES = {
    "DIFFERENTIAL_DRIVE": ("two wheels", 2, 2),
    "ACKERMANN_DRIVE": ("as a car", 1, 2),
    "OMNI_DRIVE": ("four mecanum wheels", 4, 4),
    "SWEDISH_DRIVE": ("three omnidirectional wheels", 3, 3),
    "SYNCHRO_DRIVE": ("wheels that turn together", 2, 2),
    "SUBMARINE_DRIVE": ("a submarine's thrusters", 4, 0),
}


def lines_of(robi: pathlib.Path) -> list[list[str]]:
    return [line.split() for line in robi.read_text().splitlines() if line.strip() and not line.startswith("#")]


def ids_of(lines: list[list[str]], keyword: str) -> str:
    """The numbers of the devices of a kind: "1-4", "1-3, 7"."""
    ids = sorted(int(line[2]) for line in lines if line[0] == keyword)
    runs: list[list[int]] = []
    for number in ids:
        if runs and number == runs[-1][1] + 1:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    return ", ".join(str(a) if a == b else f"{a}-{b}" for a, b in runs)


def servos_of(lines: list[list[str]], has_camera: bool) -> str:
    servos = ["1 pan", "2 tilt"] if has_camera else ["1 (position only)", "2 (position only)"]
    cars = [line for line in lines if line[0] == "steering"] or [line for line in lines if line[:2] == ["drive", "ACKERMANN_DRIVE"]]
    if cars:
        servo = int(cars[0][2]) if cars[0][0] == "steering" and len(cars[0]) > 2 else 1
        servos = [text for text in servos if text[0] != str(servo)] + [f"{servo} steers"]
    for line in lines:
        if line[0] == "kicker":
            servos.append(f"{line[1]} kicks")
        elif line[0] == "servo":
            servos.append(f"{line[1]} {line[3]} wheel" if len(line) > 3 else f"{line[1]} (position only)")
    return ", ".join(sorted(servos, key=lambda text: int(text.split()[0])))


def row_of(robi: pathlib.Path, builtin: set[str]) -> list[str]:
    lines = lines_of(robi)
    words = {line[0]: line for line in lines}
    drive, motors, encoders = DRIVES[words["drive"][1]]
    more = [f"{name} {ids_of(lines, keyword)}" for keyword, name in (("ir", "infrared switch"), ("bump", "bumper")) if keyword in words]
    kinds = sorted({line[1].partition(":")[0] for line in lines if line[0] == "psd_kind"} - {"down"})
    more += [f"PSD {line[1].partition(':')[2]} down" for line in lines if line[0] == "psd_kind" and line[1].startswith("down:")]
    if kinds:
        more.append("PSDs by " + " and ".join(kinds))
    if "error" in words:
        more.append("errors")
    lidar = words.get("lidar", [])
    return [
        robi.stem + ("" if robi.stem in builtin else " (file)"),
        drive,
        str(motors),
        str(encoders),
        ids_of(lines, "psd"),
        servos_of(lines, "camera" in words),
        "yes" if "camera" in words else "none",
        (f"{lidar[1]} points" if lidar[1].isdigit() else lidar[1]) if lidar else "none",
        ", ".join(more),
    ]


def robot_rows(root: pathlib.Path) -> list[list[str]]:
    """One row for each robot, the built-in ones first, in the order in which messages name them."""
    cmake = (root / "core/files/CMakeLists.txt").read_text()
    found = re.search(r"foreach\(robot ([^)]*)\)", cmake)
    builtin = found.group(1).split() if found else []
    files = sorted(path.stem for path in (root / "worlds/robots").glob("*.robi"))
    names = builtin + [name for name in files if name not in builtin]
    return [row_of(root / f"worlds/robots/{name}.robi", set(builtin)) for name in names]
