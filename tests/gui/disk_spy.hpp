#pragma once

#include <string>
#include <thread>

namespace eyebridge::gui::testing {

/// Sees what this process asks of the disk, and can make it fail; the system's functions do as
/// usual while there is none. One at a time.
class DiskSpy {
 public:
  /// Of the files in this folder and below.
  explicit DiskSpy(const std::string& folder);
  ~DiskSpy();
  DiskSpy(const DiskSpy&) = delete;
  DiskSpy& operator=(const DiskSpy&) = delete;

  /// How often this thread waited until something was on the disk, and how often others did.
  [[nodiscard]] int own_syncs() const;
  [[nodiscard]] int other_syncs() const;
  /// No file gets a name that ends so, from now on: no room.
  void refuse_name(const std::string& ending);
};

}  // namespace eyebridge::gui::testing
