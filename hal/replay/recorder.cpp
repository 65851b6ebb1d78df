#include "replay/recorder.hpp"

#include <filesystem>
#include <mutex>
#include <optional>

#include <fmt/format.h>

#include "calls/device_list.hpp"
#include "eyebridge/base/own_results.hpp"
#include "eyebridge/camera/frame_sink.hpp"
#include "eyebridge/camera/recording/frame_table.hpp"
#include "replay/ebrec.hpp"

namespace eyebridge::hal {
namespace {

/// What is open while a run is recorded.
struct OpenRecording {
  OpenRecording(const std::filesystem::path& path, const std::vector<ListedDevice>& devices,
                const RecordingOrigin& origin, std::optional<camera::FrameCodec> codec)
      : exchanges(path, devices, origin) {
    if (codec) frames.emplace(exchanges.file(), *codec);
  }

  EbrecWriter exchanges;
  std::optional<camera::FrameWriter> frames;
};

class Recorder final : public CallInterceptor, public camera::FrameSink {
 public:
  Recorder(Backend& backend, LogSink& log, std::string path,
           std::shared_ptr<OpenRecording> recording)
      : clock_(backend.clock()),
        log_(log),
        path_(std::move(path)),
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
    std::error_code error;
    if (drop() && !std::filesystem::exists(path_, error)) {  // closed: one file instead of three
      const std::lock_guard lock(mutex_);
      lost_ = fmt::format("the recording {} is lost: {}", path_, kRemoved);
    }
  }

  std::string lost() override {
    const std::lock_guard lock(mutex_);
    return lost_;
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
      const std::lock_guard lock(mutex_);
      lost_ = fmt::format("the recording {} is not whole: {}", path_, error.what());
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
  const std::string path_;
  const bool keeps_frames_;
  std::mutex mutex_;
  std::shared_ptr<OpenRecording> recording_;
  std::string lost_;
};

}  // namespace

std::unique_ptr<Backend> with_recording(std::unique_ptr<Backend> inner,
                                        const std::filesystem::path& path, LogSink& log,
                                        const RecordingOrigin& origin,
                                        std::optional<camera::FrameCodec> frames) {
  return with_interceptor(std::move(inner), [&](Backend& backend) {
    auto recording = std::make_shared<OpenRecording>(path, devices_of(backend), origin, frames);
    return std::make_unique<Recorder>(backend, log, path.string(), std::move(recording));
  });
}

}  // namespace eyebridge::hal
