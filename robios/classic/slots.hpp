#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "eyebridge/base/result.hpp"

namespace eyebridge::robios::classic {

/// The open devices of one family: each has a bit, which is its handle. One thread at a time.
template <class Device>
class Slots {
 public:
  /// What RoBIOS returns for a handle without any open device.
  static constexpr int kWrongHandle = 0x11110000;

  /// `family` is for messages ("PSD"); at most `most` devices, 1 … 31, are open at once.
  Slots(const char* family, std::size_t most) : family_(family), slots_(most) {}

  /// Opens `device`, whose number (of the backend) is `id`. OutOfRange when it is open already, or
  /// as many are open as can be.
  Result<int> open(int id, Device device) {
    std::size_t free = slots_.size();
    for (std::size_t i = slots_.size(); i-- > 0;) {
      if (!slots_[i].open) free = i;
      if (slots_[i].open && slots_[i].id == id) {
        return fail(Errc::OutOfRange, fmt::format("this {} is open already", family_));
      }
    }
    if (free == slots_.size()) {
      return fail(Errc::OutOfRange,
                  fmt::format("{} of these are open already: {}", slots_.size(), family_));
    }
    slots_[free] = {true, id, std::move(device)};
    return 1 << free;
  }

  /// The device behind a handle of one bit.
  Result<Device*> one(int handle) {
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      if (slots_[i].open && handle == 1 << i) return &slots_[i].device;
    }
    return wrong(handle);
  }

  /// Those behind a handle of one bit or more; fails unless all of its bits are open ones.
  Result<std::vector<Device*>> all(int mask) {
    if (mask == 0 || (mask & ~open_mask()) != 0) return wrong(mask);
    std::vector<Device*> devices;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      if ((mask & 1 << i) != 0) devices.push_back(&slots_[i].device);
    }
    return devices;
  }

  /// Closes those of `mask`. 0; or, and then closes none, kWrongHandle when none of the bits is an
  /// open one, else the mask of those that are.
  int close(int mask) {
    const int known = mask & open_mask();
    if (mask == 0 || known == 0) return kWrongHandle;
    if (known != mask) return known;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      if ((mask & 1 << i) != 0) slots_[i] = {};
    }
    return 0;
  }
  void close_all() { close(open_mask()); }

  [[nodiscard]] int open_mask() const {
    int mask = 0;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      if (slots_[i].open) mask |= 1 << i;
    }
    return mask;
  }
  [[nodiscard]] bool is_open(int id) const {
    for (const Slot& slot : slots_) {
      if (slot.open && slot.id == id) return true;
    }
    return false;
  }

 private:
  struct Slot {
    bool open = false;
    int id = 0;
    Device device{};
  };

  [[nodiscard]] tl::unexpected<Error> wrong(int handle) const {
    return fail(Errc::OutOfRange,
                fmt::format("handle {:#x} is no open {} (open are {:#x})",
                            static_cast<unsigned>(handle), family_,
                            static_cast<unsigned>(open_mask())));
  }

  const char* family_;
  std::vector<Slot> slots_;
};

}  // namespace eyebridge::robios::classic
