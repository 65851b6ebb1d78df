#include "row_file.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/own_results.hpp"

namespace eyebridge::robios {

RowFile::RowFile(std::filesystem::path path)
    : path_(std::move(path)), file_(std::fopen(path_.c_str(), "w")) {
  if (file_) return;
  throw ConfigError({}, "cannot write " + path_.filename().string() + ": " +
                            std::generic_category().message(errno));
}

void RowFile::add(std::string_view row) noexcept {
  if (failure_ != 0) return;
  if (std::fwrite(row.data(), 1, row.size(), file_.get()) != row.size()) note_failure();
}

void RowFile::flush() noexcept {
  if (std::fflush(file_.get()) != 0) note_failure();
}

std::string RowFile::failure() const {
  if (failed()) return path_.string() + ": " + std::generic_category().message(failure_);
  return is_still_at(path_, fileno(file_.get())) ? "" : path_.string() + ": " + kRemoved;
}

void RowFile::note_failure() noexcept {
  if (failure_ == 0) failure_ = errno;
}

}  // namespace eyebridge::robios
