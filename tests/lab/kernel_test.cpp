#include <gmock/gmock.h>

#include "run_program.hpp"

// What the guest kernel can do that the host's may not: one small Python program each.
namespace eyebridge::testing {
namespace {

using ::testing::HasSubstr;

/// Runs `program` in the guest, in simulated time.
ProgramRun guest(const std::string& program, std::vector<std::string> options = {}) {
  std::vector<std::string> command = {EYEBRIDGE_LAB "/run", "--time-travel", "--timeout", "50"};
  command.insert(command.end(), options.begin(), options.end());
  command.insert(command.end(), {"--", "/usr/bin/python3", "-c", program});
  return run_program({command, {}, ""});
}

TEST(LabKernel, CarriesCanFdFramesOf64Bytes) {
  const ProgramRun run = guest(R"(
import socket, struct
def bus():
    s = socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
    s.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_FD_FRAMES, 1)
    s.bind(('vcan0',))
    return s
a, b = bus(), bus()
a.send(struct.pack('=IB3x64s', 0x123, 64, bytes(range(64))))
print(len(b.recv(100)))
)");
  EXPECT_EQ(run.out, "72\n") << run.err;
}

TEST(LabKernel, CarriesIsoTpMessagesWithFlowControl) {
  const ProgramRun run = guest(R"(
import socket
def end(rx, tx):
    s = socket.socket(socket.AF_CAN, socket.SOCK_DGRAM, socket.CAN_ISOTP)
    s.bind(('vcan0', rx, tx))
    return s
a, b = end(0x7E8, 0x7E0), end(0x7E0, 0x7E8)
message = bytes(i % 251 for i in range(300))
a.send(message)
print(b.recv(4096) == message)
)");
  EXPECT_EQ(run.out, "True\n") << run.err;
}

TEST(LabKernel, IsoTpWithoutAPeerTimesOutAfterASecondOfSimulatedTime) {
  const ProgramRun run = guest(R"(
import socket, time
s = socket.socket(socket.AF_CAN, socket.SOCK_DGRAM, socket.CAN_ISOTP)
s.setsockopt(106, 1, bytes([0x00, 0x04, 0, 0]) + bytes(8))  # SOL_CAN_ISOTP options: wait for the end
s.bind(('vcan1', 0x7E8, 0x7E0))
t = time.monotonic()
try:
    s.send(bytes(100))
    print('sent')
except OSError as error:
    print(error.errno, round(time.monotonic() - t, 2))
)");
  EXPECT_EQ(run.out, "70 1.0\n") << "ECOMM; " << run.err;
}

TEST(LabKernel, PairsOfVirtualInterfacesAreThere) {
  const ProgramRun run = guest(R"(
import socket, struct, subprocess
subprocess.check_call('ip link add vx0 type vxcan peer name vx1 && ip link set vx0 up && ip link set vx1 up',
                      shell=True)
ends = []
for name in ('vx0', 'vx1'):
    s = socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
    s.bind((name,))
    ends.append(s)
ends[0].send(struct.pack('=IB3x8s', 0x321, 2, b'hi'))
print(ends[1].recv(16)[8:10].decode())
)");
  EXPECT_EQ(run.out, "hi\n") << run.err;
}

TEST(LabKernel, ASerialAdapterBecomesAnInterfaceWithABitRate) {
  const ProgramRun run = guest(R"(
import fcntl, os, pty, struct, subprocess, termios, threading, tty
board, line = pty.openpty()
tty.setraw(line)
fcntl.ioctl(line, termios.TIOCSETD, struct.pack('i', 17))  # N_SLCAN
heard = b''
def listen():
    global heard
    while True: heard += os.read(board, 100)
threading.Thread(target=listen, daemon=True).start()
subprocess.check_call('ip link set can0 type can bitrate 500000 && ip link set can0 up', shell=True)
print(heard.decode().split('\r'))
)");
  EXPECT_THAT(run.out, HasSubstr("'S6', 'O'")) << "Lawicel for 500 kbit/s, then open; " << run.err;
}

TEST(LabKernel, VividIsACameraAtFullRate) {
  const ProgramRun run = guest(R"(
import fcntl
video = open('/dev/video0', 'rb', buffering=0)
capability = bytearray(104)
fcntl.ioctl(video, 0x80685600, capability)  # VIDIOC_QUERYCAP
print(capability[:16].rstrip(b'\0').decode(), len(video.read(100000)) > 0)
)",
                               {"--vivid"});
  EXPECT_EQ(run.out, "vivid True\n") << run.err;
}

TEST(LabKernel, RecordedFramesCanBePlayedIntoALoopbackCamera) {
  const ProgramRun run = guest("print(open('/sys/class/video4linux/video0/name').read().strip())",
                               {"--module", "v4l2loopback card_label=lab"});
  EXPECT_EQ(run.out, "lab\n") << run.err;
}

}  // namespace
}  // namespace eyebridge::testing
