#include "replay/record_tap.hpp"

#include <mutex>
#include <optional>

#include <fmt/format.h>

#include "eyebridge/camera/frame_sink.hpp"
#include "eyebridge/camera/recording/frame_table.hpp"
#include "replay/ebrec.hpp"

namespace eyebridge::hal {
namespace {

constexpr int kMostIds = 255;

/// What the robot has, asked device by device: a backend has no list.
std::vector<RecordedDevice> devices_of(Backend& backend) {
  std::vector<RecordedDevice> devices;
  const auto add = [&](const char* kind, int id, const void* there, Values facts = {}) {
    if (there != nullptr) devices.push_back({kind, id, std::move(facts)});
  };
  add("drive", 1, backend.drive());
  add("compass", 1, backend.compass());
  if (const Lidar* lidar = backend.lidar()) {
    const LidarShape shape = lidar->shape();
    add("lidar", 1, lidar,
        {lidar->max_range(), shape.field_of_view, shape.tilt, static_cast<double>(shape.points)});
  }
  add("digital", 1, backend.digital());
  add("analog", 1, backend.analog());
  add("board", 1, backend.io_board());
  add("remote", 1, backend.remote());
  add("sound", 1, backend.sound());
  if (const Radio* radio = backend.radio())
    add("radio", 1, radio, {static_cast<double>(radio->id())});
  add("serial", 0, backend.serial_port(0));
  for (int id = 1; id <= kMostIds; ++id) {
    if (const RangeSensor* psd = backend.range_sensor(id))
      add("psd", id, psd, {psd->out_of_range()});
    add("proximity", id, backend.proximity(id));
    add("bumper", id, backend.bumper(id));
    add("motor", id, backend.motor(id));
    add("encoder", id, backend.encoder(id));
    add("servo", id, backend.servo(id));
    add("serial", id, backend.serial_port(id));
  }
  return devices;
}

/// What is open while a run is recorded.
struct OpenRecording {
  OpenRecording(const std::filesystem::path& path, const std::vector<RecordedDevice>& devices,
                const RecordingOrigin& origin, std::optional<camera::FrameCodec> codec)
      : exchanges(path, devices, origin) {
    if (codec) frames.emplace(exchanges.file(), *codec);
  }

  EbrecWriter exchanges;
  std::optional<camera::FrameWriter> frames;
};

class RecordTap final : public Tap, public camera::FrameSink {
 public:
  RecordTap(Backend& backend, LogSink& log, std::shared_ptr<OpenRecording> recording)
      : clock_(backend.clock()),
        log_(log),
        keeps_frames_(recording->frames.has_value()),
        recording_(std::move(recording)) {}

  Result<Values> exchange(const Call& call,
                          const std::function<Result<Values>()>& device) override {
    const Time began = clock_.now();
    Result<Values> reply = device();
    write([&](OpenRecording& recording) { recording.exchanges.add(began, call, reply); });
    return reply;
  }

  camera::FrameSink* frame_sink() override { return keeps_frames_ ? this : nullptr; }

  void take(const camera::Frame& frame) noexcept override {
    const Time now = clock_.now();
    write([&](OpenRecording& recording) { recording.frames->add(frame, now); });
  }

  void finish() noexcept override {
    write([](OpenRecording& recording) { recording.exchanges.commit(); });
    drop();  // closed, it is one file instead of three
  }

 private:
  /// Without the lock: packing a frame takes milliseconds, and the file locks for itself.
  template <class Write>
  void write(Write&& act) {
    const std::shared_ptr<OpenRecording> recording = current();
    if (recording == nullptr) return;
    try {
      act(*recording);
    } catch (const std::runtime_error& error) {
      if (!drop()) return;  // another thread has said it
      log_.write(Severity::Error, fmt::format("the recording ends here: {}", error.what()));
    }
  }

  std::shared_ptr<OpenRecording> current() {
    const std::lock_guard lock(mutex_);
    return recording_;
  }
  /// False when it had been dropped before.
  bool drop() {
    const std::lock_guard lock(mutex_);
    return std::exchange(recording_, nullptr) != nullptr;
  }

  Clock& clock_;
  LogSink& log_;
  const bool keeps_frames_;
  std::mutex mutex_;
  std::shared_ptr<OpenRecording> recording_;
};

}  // namespace

std::unique_ptr<Backend> with_recording(std::unique_ptr<Backend> inner,
                                        const std::filesystem::path& path, LogSink& log,
                                        const RecordingOrigin& origin,
                                        std::optional<camera::FrameCodec> frames) {
  return make_tapped(std::move(inner), [&](Backend& backend) {
    auto recording = std::make_shared<OpenRecording>(path, devices_of(backend), origin, frames);
    return std::make_unique<RecordTap>(backend, log, std::move(recording));
  });
}

}  // namespace eyebridge::hal
