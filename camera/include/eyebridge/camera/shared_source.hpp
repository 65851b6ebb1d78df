#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "eyebridge/camera/source.hpp"

namespace eyebridge::camera {

/// Whoever looks at every frame of a camera, not only at those that a program asks for.
class FrameWatcher {
 public:
  virtual ~FrameWatcher() = default;
  /// The next frame, in the size in which the camera gives it; it may be kept.
  virtual void frame(const FramePtr& frame) = 0;
  /// No frame came for a while (Timeout), or none can come (Disconnected). May come again and
  /// again.
  virtual void no_frame(const Error& why) = 0;
};

/// One camera for two: a watcher is shown every frame, and the program gets the newest that it has
/// not had, in its own size, as from any Source. set_size() only says how frames are fitted: the
/// camera itself goes on in its natural size.
///
/// On a clock that runs by itself, a thread of its own takes the frames and calls the watcher. On a
/// virtual clock whoever lets time pass takes them, by pull(); the watcher is called from there.
/// Any thread.
class SharedSource final : public Source {
 public:
  /// `inner` lives on `clock`; both `clock` and `watcher`, which is called from now on, are lent.
  SharedSource(std::unique_ptr<Source> inner, Clock& clock, FrameWatcher& watcher);
  /// Ends the thread: takes as long as the camera waits for a frame, a tenth of a second at most.
  ~SharedSource() override;
  SharedSource(const SharedSource&) = delete;
  SharedSource& operator=(const SharedSource&) = delete;

  /// Of a virtual clock only: lets time pass until `deadline`, each frame being taken when it is
  /// due.
  void pull(Time deadline);

  Result<void> set_size(int width, int height) override;
  [[nodiscard]] Size natural_size() const override;
  /// As Source::next(); `deadline` on the clock. Fails as the camera does; sequences begin with 0
  /// at the first frame that the program is given.
  Result<FramePtr> next(Time deadline) override;

 private:
  void run();
  /// Takes the next frame, waiting for it at most until `deadline`; whether there was one.
  bool take(Time deadline);
  /// Whether next() has something to say: a frame, or why there is none. `mutex_` is held.
  [[nodiscard]] bool answered(Time deadline) const;
  [[nodiscard]] bool is_answered(Time deadline) const;

  Clock& clock_;
  FrameWatcher& watcher_;
  std::mutex pulling_;  ///< Held while `inner_` is used, in virtual time.
  const std::unique_ptr<Source> inner_;
  const Size natural_;

  mutable std::mutex mutex_;  ///< Of all that follows. Never held while the camera is waited for.
  std::condition_variable news_;
  FramePtr newest_;                     ///< Not yet given to the program; else null.
  std::optional<Error> trouble_;        ///< Why there was none, last time.
  std::optional<Size> size_;            ///< As the program wants it.
  std::optional<std::uint64_t> first_;  ///< Sequence of the first frame that it was given.
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace eyebridge::camera
