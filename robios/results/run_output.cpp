#include "run_output.hpp"

#include <algorithm>
#include <cerrno>
#include <stdexcept>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/own_results.hpp"
#include "eyebridge/base/write_file.hpp"
#include "eyebridge/camera/birdseye.hpp"
#include "eyebridge/camera/png.hpp"

namespace eyebridge::robios {
namespace {

constexpr double kTrailStep = 0.005;  // metres; finer does not show on the map
// Pieces of the trail, from the first, pale, to the last, dark.
constexpr std::size_t kTrailPieces = 24;

Rgb trail_colour(std::size_t piece) {
  const auto fade = [&](int from, int to) {
    return static_cast<std::uint8_t>(from + (to - from) * static_cast<int>(piece) /
                                                static_cast<int>(kTrailPieces - 1));
  };
  return {fade(250, 200), fade(205, 20), fade(160, 20)};
}

/// The trail in pieces of equal length that meet, so that the last run shows over the first.
std::vector<camera::Trail> fading(const std::vector<Vec2>& points) {
  std::vector<camera::Trail> pieces;
  for (std::size_t i = 0; i < kTrailPieces; ++i) {
    const std::size_t begin = points.size() * i / kTrailPieces;
    const std::size_t end = std::min(points.size() * (i + 1) / kTrailPieces + 1, points.size());
    if (begin >= end) continue;
    const auto at = [&](std::size_t index) { return points.begin() + static_cast<long>(index); };
    pieces.push_back({trail_colour(i), {at(begin), at(end)}});
  }
  return pieces;
}

/// Makes the folder, if it may hold results: those of an earlier run in it are replaced, but no
/// files that only have the same names.
const std::filesystem::path& claimed(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const char* const name : {"trace.csv", "collisions.csv", "frames"}) drop_link(folder / name);
  const std::filesystem::path trace = folder / "trace.csv";
  check_replaceable(trace, "trace", kTraceHeader);
  if (std::filesystem::exists(trace)) return folder;
  for (const char* const name : {"collisions.csv", "lcd.png", "lcd.txt", "map.png", "frames"}) {
    if (!std::filesystem::exists(folder / name)) continue;
    throw ConfigError({}, fmt::format("cannot write {}: found {} and no trace.csv, expected an "
                                      "empty or new folder, or one with earlier results",
                                      folder.string(), name));
  }
  return folder;
}

/// Keeps other runs out of the folder while this lives. Where a file system has no locks, nobody
/// is.
UniqueFd locked(const std::filesystem::path& folder) {
  UniqueFd file(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (file.valid() && flock(file.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    throw ConfigError({}, fmt::format("cannot write {}: another run writes its results there now, "
                                      "expected another folder",
                                      folder.string()));
  }
  return file;
}

}  // namespace

RunOutput::RunOutput(std::filesystem::path directory, long long frames_to_keep) try
    : directory_(std::move(directory)),
      lock_(locked(claimed(directory_))),
      frames_left_(frames_to_keep),
      trace_(directory_ / "trace.csv"),
      collisions_(directory_ / "collisions.csv") {
} catch (const std::filesystem::filesystem_error& error) {
  throw ConfigError({}, fmt::format("cannot make the folder {}: {}", error.path1().string(),
                                    error.code().message()));
}

RunOutput::~RunOutput() = default;

void RunOutput::point(const hal::TracePoint& p) noexcept {
  const std::lock_guard lock(mutex_);
  const Vec2 here = p.pose.position();
  if (trail_.empty() || norm(here - trail_.back()) >= kTrailStep) trail_.push_back(here);
  trace_.add(p);
}

bool RunOutput::is_due(Time time) const noexcept {
  const std::lock_guard lock(mutex_);
  return trace_.is_due(time);
}

void RunOutput::contact(const hal::TraceContact& contact) noexcept {
  const std::lock_guard lock(mutex_);
  collisions_.add(contact);
}

void RunOutput::frame(const camera::Frame& frame) {
  std::filesystem::path file;
  {
    const std::lock_guard lock(mutex_);
    if (frames_left_ <= 0) return;
    --frames_left_;
    file = directory_ / "frames" / fmt::format("{:04}.png", frames_taken_++);
  }
  write(frame, file);
}

void RunOutput::write(const camera::Frame& frame, const std::filesystem::path& path) {
  try {
    std::filesystem::create_directories(path.parent_path());
    drop_link(path);
    camera::write_png(frame, path);
  } catch (const std::runtime_error& error) {
    note_failure(error.what());
  }
}

void RunOutput::note_failure(const std::string& failure) {
  const std::lock_guard lock(mutex_);
  if (failure_.empty()) failure_ = failure;
}

void RunOutput::before_fork() {
  mutex_.lock();
  trace_.file().flush();
  collisions_.file().flush();
}

void RunOutput::after_fork() { mutex_.unlock(); }

void RunOutput::finish(const world::Scene* scene, const camera::Frame& lcd,
                       const std::string& lcd_text) {
  std::vector<camera::Trail> trail;
  {
    const std::lock_guard lock(mutex_);
    for (RowFile* file : {&trace_.file(), &collisions_.file()}) {
      file->flush();
      if (failure_.empty()) failure_ = file->failure();
    }
    trail = fading(trail_);
  }
  write(lcd, directory_ / "lcd.png");
  const std::filesystem::path text_path = directory_ / "lcd.txt";
  drop_link(text_path);
  if (const auto done = write_file(text_path, lcd_text); !done) {
    note_failure(text_path.string() + ": " + done.error().what);
  }
  if (scene != nullptr) write(camera::draw_birdseye(*scene, trail), directory_ / "map.png");
  const std::lock_guard lock(mutex_);
  if (!failure_.empty()) throw std::runtime_error(failure_);
}

}  // namespace eyebridge::robios
