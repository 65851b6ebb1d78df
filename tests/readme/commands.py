"""What each command on the pages must do. Every command has its row, and every row its command: run.py and a test see to it."""

from dataclasses import dataclass


@dataclass
class Row:
    page: str
    command: str  # as the page has it
    typed: str = ""  # what a reader types instead: a name for FILE, a program for COMMAND
    before: str = ""  # sh: what the page says must be there before
    beside: str = ""  # sh: what stands beside the computer, a board or another program; it is ended at the end
    shows: str = ""  # what is there as soon as it is ready: file:NAME, window:TITLE
    first: str = ""  # sh: put before it
    within: str = ""  # the command that it runs in: a kernel with CAN, a display
    prints: str = ""  # a regular expression in its output
    leaves: tuple = ()  # files that it makes or writes anew
    stop: str = ""  # Ctrl-C once this is there: file:NAME, window:TITLE, or prints:EXPRESSION in its output
    exit: int = 0
    elsewhere: str = ""  # not run here: where it is run instead


README = "README.md"
PROG = r"""cat >prog.c <<'END'
#include "eyebot.h"
int main() {
  LCDPrintf("hello\n");
  VWStraight(100, 200);
  VWWait();
  VWTurn(90, 90);
  VWWait();
  printf("PSD front: %d mm\n", PSDGet(PSD_FRONT));
  return 0;
}
END
"""
PROG_PY = r"""cat >prog.py <<'END'
from eye import *
VWStraight(100, 200)
VWWait()
print("PSD front:", PSDGet(PSD_FRONT), "mm")
END
"""
DROVE = r"PSD front: \d+ mm"
# An IO7 board that nobody here wrote, where a real one would be, and its owner's HDT file.
BOARD = "exec python3 $SHARED/judges/io7_board.py /dev/ttyACM0 --tpm 6484 --base 0.09"
ON_USB = "file:/dev/ttyACM0"
HDT = "eyebridge firmware --world maze-8.maz --hdt >robot.hdt"
# What ./test installs for the guest kernel. The kernel itself is lent: ./test compiles it for ten minutes.
LAB = ". cmake/prepare.sh && install_packages lab"
# A kernel that has CAN and a camera. The robot on the bus is nobody's here, either.
CAN = "eyebridge lab --"
# can_node.py fails on a computer that was started less than 5 s ago.
CAN_ROBOT = ("until [ $(cut -d. -f1 /proc/uptime) -ge 6 ]; do sleep 0.2; done; "
             "ip link set vcan0 down; ip link set vcan0 name can0; ip link set can0 up; "
             "python3 $SHARED/judges/can_node.py --can can0 & ")
CAMERA = "eyebridge lab --vivid --rw . --"
# What calibrating leaves; no person holds a board into a simulated camera.
LENS = "printf '%s\\n' 'size = [640, 480]' 'focal_length = [554.25, 559.8]' 'centre = [323.0, 239.5]' 'distortion = [0, 0, 0, 0, 0]' 'error = 0.3' >cam.toml"
WINDOWS = "window:– environment"
# A folder that asks for something that needs trust.
CAME = "mkdir -p came && echo 'report = \"report.txt\"' >came/eyebridge.toml && "

ROWS = (
    Row(README, "./run", leaves=("out/trace.csv", "out/*.png"), prints="maze solved"),
    Row(README, "./test", elsewhere="half an hour; what runs this has run it"),
    Row(README, "./run FILE", typed="./run worlds/maze-5.maz", leaves=("out/trace.csv",)),
    Row(README, "./run --gui", stop=WINDOWS, exit=130),
    Row(README, 'export PATH="$PWD/build/release/bin:$PATH"'),
    Row(README, "eyebridge-cc prog.c -o prog", before=PROG, leaves=("prog",)),
    Row(README, "eyebridge run --world maze-8.maz prog", prints=DROVE),
    Row(README, "eyebridge run --fast --out out prog", prints=DROVE,
        leaves=("out/trace.csv", "out/collisions.csv", "out/map.png")),
    Row(README, "eyebridge run examples/wall_follow.py", typed="eyebridge run --time-limit 3s examples/wall_follow.py"),
    Row(README, "sudo apt install python3-venv python3-pip", typed="apt-get install -y -q python3-venv python3-pip"),
    Row(README, "python3 -m venv --system-site-packages .venv", leaves=(".venv/bin/python3",)),
    # The same flags as in ./run: the compiler's cache has nearly all objects.
    Row(README, ".venv/bin/pip install .", first="CMAKE_ARGS=-DEYEBRIDGE_WERROR=ON ", prints="Successfully installed"),
    Row(README, ".venv/bin/python3 examples/wall_follow.py",
        typed="EYEBRIDGE_TIME_LIMIT=3s .venv/bin/python3 examples/wall_follow.py"),
    Row(README, "eyebridge --help", prints="firmware"),
    Row(README, "eyebridge doctor", prints=r"libeyebridge +ok"),
    Row(README, "eyebridge lab -- COMMAND", typed="eyebridge lab -- ip link show vcan0", before=LAB, prints="vcan0.*UP"),
    Row(README, "eyebridge run --hal sim --world maze-8.maz prog", prints=DROVE),
    Row(README, "eyebridge run --hal 'serial:/dev/ttyACM0?hdt=robot.hdt' prog", before=HDT, beside=BOARD, shows=ON_USB,
        prints=DROVE),
    Row(README, "eyebridge run --hal 'can:can0?node=1' prog", within=CAN, first=CAN_ROBOT, prints=DROVE),
    Row(README, "eyebridge probe /dev/ttyACM0", beside=BOARD, shows=ON_USB, prints="an EyeBot I/O board"),
    Row(README, "eyebridge firmware --world maze-8.maz --pty ./eyebot.tty", stop="file:eyebot.tty"),
    Row(README, "eyebridge run --fast --robots 3 --world rooms.wld prog", prints="3 robots"),
    Row(README, "eyebridge run --fast --robots all --world soccer-5v5.sim build/release/examples/soccer",
        typed="eyebridge run --time-limit 20s --fast --robots all --world soccer-5v5.sim build/release/examples/soccer",
        prints="10 robots"),
    Row(README, "eyebridge sweep --seed 1..20 --world corridor.wld --time-limit 60s prog", prints="20"),
    Row(README, "eyebridge run --world rooms.wld examples/control/explore.py",
        typed="eyebridge run --fast --time-limit 60s --world rooms.wld examples/control/explore.py"),
    Row(README, "eyebridge assess --worlds maze-5.maz,rooms.wld --seeds 20 examples/control/survey.py",
        prints=r"all: \d+ of 40 runs succeed"),
    Row(README, "eyebridge camera markers --world maze-5.maz --size 50mm --out sheet.pdf", leaves=("sheet.pdf",)),
    Row(README, "eyebridge camera calibrate --camera v4l2: --board charuco:5x7 --square 30mm --out cam.toml",
        within=CAMERA, first="timeout --preserve-status --signal INT 5 ", prints="hold the board into the picture", exit=130),
    Row(README, "eyebridge run --camera 'v4l2:?calibration=cam.toml' --drive 'hand?size=50mm' --world maze-5.maz --out out prog",
        before=LENS, within=CAMERA, first="timeout --preserve-status --signal INT 20 ", leaves=("out/hand.png",)),

    Row("docs/assess.md", "eyebridge assess --worlds worlds/maze-5.maz,worlds/rooms.wld --seeds 20 --time-limit 90s "
        "--no-collisions --errors realistic examples/control/survey.py", prints=r"all: \d+ of 40 runs succeed"),

    Row("docs/boards.md", "eyebridge probe", prints="eyebridge probe"),
    Row("docs/boards.md", "eyebridge probe /dev/ttyACM0", beside=BOARD, shows=ON_USB, prints="an EyeBot I/O board"),
    Row("docs/boards.md", "sudo usermod -aG dialout $USER", typed="usermod -aG dialout root && id root", prints="dialout"),
    Row("docs/boards.md", "eyebridge doctor", prints="serial boards"),
    Row("docs/boards.md", "eyebridge doctor --udev", prints="SUBSYSTEM"),
    Row("docs/boards.md", "eyebridge-cc examples/square.c -o square", leaves=("square",)),
    Row("docs/boards.md", "eyebridge run --hal serial:/dev/ttyACM0 square", beside=BOARD, shows=ON_USB),
    Row("docs/boards.md", "eyebridge run --hal 'serial:/dev/ttyACM0?hdt=robot.hdt' square", beside=BOARD, shows=ON_USB),

    Row("docs/camera.md", "eyebridge camera show --camera URL", typed="eyebridge camera show --camera v4l2:", within=CAMERA,
        prints=r"frames +30"),
    Row("docs/configuration.md", "eyebridge config", prints="world"),
    Row("docs/configuration.md", "eyebridge run --radio 'udp:239.192.7.1:7007?id=2' ping",
        before="eyebridge-cc examples/ping.c -o ping", beside="exec eyebridge run --radio 'udp:239.192.7.1:7007?id=1' ping",
        shows="file:ping",
        prints="robot 2 counted to"),
    Row("docs/configuration.md", "eyebridge-cc -DEYEBOT_PSD_2015", typed="eyebridge-cc -DEYEBOT_PSD_2015 prog.c -o prog-2015",
        leaves=("prog-2015",)),
    Row("docs/control.md", "eyebridge run --world WORLD FILE.py",
        typed="eyebridge run --fast --time-limit 5s --world rooms.wld first.py",
        before="""sed -n '/^```python/,/^```/p' docs/control.md | sed '/^```/d' >first.py && test -s first.py"""),

    Row("docs/install.md", "./run", prints="maze solved"),
    Row("docs/install.md", "./run --gui", stop=WINDOWS, exit=130),
    Row("docs/install.md", "cmake --install build/release --prefix ~/eyebridge", leaves=("/root/eyebridge/bin/eyebridge",)),
    Row("docs/install.md", "~/eyebridge/bin/eyebridge doctor", prints="worlds +ok +/root/eyebridge/"),

    Row("docs/parity.md", "./test parity", elsewhere="a measurement of half an hour, by hand"),
    Row("docs/robustness.md", "./test robust", elsewhere="three hours, by hand"),
    Row("docs/parity.md", "./test hal", elsewhere="./test all has these tests"),
    Row("docs/parity.md", "./test lab", elsewhere="./test all has these tests"),
    Row("docs/parity.md", "./test cortex", elsewhere="./test all has these tests"),

    Row("docs/robots.md", "eyebridge run --robots 3 --world worlds/rooms.wld prog", prints="3 robots"),
    Row("docs/robots.md", "EYEBRIDGE_ROBOTS=3 ./prog", prints="3 robots"),
    Row("docs/robots.md", "eyebridge run --robots 3 --world worlds/rooms.wld prog.py", before=PROG_PY, prints="3 robots"),
    Row("docs/robots.md", "eyebridge run --robots all --world worlds/two-robots.sim prog", prints="2 robots"),
    Row("docs/formats.md", "eyebridge world convert worlds/micromouse-16.maz mouse.txt", prints="mouse.txt", leaves=("mouse.txt",)),
    Row("docs/formats.md", "eyebridge world convert mouse.txt mouse.num", prints="mouse.num", leaves=("mouse.num",)),
    Row("docs/formats.md", "eyebridge world draw mouse.txt", leaves=("mouse.png",)),
    Row("docs/robots.md", "eyebridge run --world match.sim",
        before="printf '%s\\n' 'world worlds/rooms.wld' 'S4 500 400 90 prog' 'LabBot 700 1000 0 prog' >match.sim", prints="2 robots"),

    Row("docs/same-bits.md", "eyebridge run --fast --seed 7 --world rooms.wld --report run.toml prog", prints=DROVE,
        leaves=("run.toml",)),

    Row("docs/scale.md", "./test peers", elsewhere="a measurement of minutes, by hand; ./test all has one short round of it"),
    Row("docs/scale.md", "./test scale", elsewhere="a measurement of minutes, by hand; ./test all has one short round of it"),
    Row("docs/security.md", "eyebridge trust", typed=CAME + "cd came && eyebridge trust", prints="report = "),
    Row("docs/security.md", "eyebridge trust --list", typed=CAME + "eyebridge trust came && eyebridge trust --list", prints="report = "),
    Row("docs/security.md", "eyebridge trust --revoke FOLDER", typed=CAME + "eyebridge trust came && eyebridge trust --revoke came",
        prints="not trusted any more"),
    Row("docs/security.md", "eyebridge config", prints="world"),
    Row("docs/tour.md", "./run --gui", stop=WINDOWS, exit=130),
    Row("docs/tour.md", "eyebridge run --gui --world FILE prog", typed="eyebridge run --gui --world rooms.wld examples/wall_follow.py",
        stop=WINDOWS, exit=130),
)
