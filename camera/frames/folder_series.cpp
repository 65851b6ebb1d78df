#include <algorithm>
#include <array>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/picture.hpp"
#include "frames/frame_series.hpp"

namespace eyebridge::camera {
namespace {

namespace fs = std::filesystem;

/// Hidden files are what other systems keep beside pictures.
bool is_picture_name(const fs::path& path) {
  if (path.filename().string().starts_with('.')) return false;
  std::string ending = path.extension().string();
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  constexpr std::array kEndings{".png", ".jpg", ".jpeg", ".bmp",  ".pbm", ".pgm",
                                ".ppm", ".pnm", ".tif",  ".tiff", ".webp"};
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

std::string text_of(Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

class FolderSeries final : public FrameSeries {
 public:
  FolderSeries(std::vector<fs::path> files, Size size, double rate)
      : files_(std::move(files)), size_(size), rate_(rate) {}

  [[nodiscard]] Size size() const override { return size_; }
  [[nodiscard]] Time period() const override { return time_of(1); }
  [[nodiscard]] bool is_on_robots_clock() const override { return false; }

  std::optional<SeriesEntry> entry(int ahead) override {
    const std::size_t index = at_ + static_cast<std::size_t>(ahead);
    if (index >= files_.size()) return std::nullopt;
    const Time due = time_of(index);
    return SeriesEntry{due, due, index};
  }
  Result<Frame> picture() override {
    try {
      Frame frame = read_picture(files_[at_]);
      if (Size{frame.width, frame.height} == size_) return frame;
      return fail(Errc::Corrupt, "camera: " + files_[at_].string() + " has " +
                                     text_of({frame.width, frame.height}) + " pixels, expected " +
                                     text_of(size_) + ": pictures of one camera are of one size");
    } catch (const std::runtime_error& error) {
      return fail(Errc::Corrupt, std::string("camera: ") + error.what());
    }
  }
  void advance() override { ++at_; }
  void rewind() override { at_ = 0; }

 private:
  /// Rounded down, as the times of simulated cameras.
  [[nodiscard]] Time time_of(std::size_t index) const {
    return Time(static_cast<Time::rep>(static_cast<double>(index) * 1e9 / rate_));
  }

  std::vector<fs::path> files_;
  Size size_;
  double rate_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (is_picture_name(entry->path())) files.push_back(entry->path());
  }
  if (error) throw ConfigError({folder.string()}, "cannot be read: " + error.message());
  if (files.empty()) {
    throw ConfigError(
        {folder.string()},
        "found no pictures in this folder, expected .png, .jpg, .bmp, .ppm, .tif or .webp");
  }
  std::ranges::sort(files, natural_less,
                    [](const fs::path& path) { return path.filename().string(); });
  return files;
}

std::unique_ptr<FrameSeries> open_folder_series(const fs::path& folder, double rate) {
  std::vector<fs::path> files = pictures_in(folder);
  // Of the first one that can be read; the others fail at their turn.
  std::string why;
  for (const fs::path& file : files) {
    try {
      const Size size = picture_size(file);
      return std::make_unique<FolderSeries>(std::move(files), size, rate);
    } catch (const std::runtime_error& error) {
      if (why.empty()) why = error.what();
    }
  }
  throw ConfigError({}, why);
}

}  // namespace eyebridge::camera
