#include "eyebridge/bridges/moved_bus.hpp"

#include <algorithm>
#include <string>

namespace eyebridge::bridges {

CanFrame MovedBus::on_socket(const CanFrame& frame) const {
  CanFrame moved = frame;
  moved.id += place_.offset;
  moved.extended = place_.extended;
  return inner_->on_socket(moved);
}

Result<void> MovedBus::send(const CanFrame& frame, Time deadline) {
  const std::uint64_t id = std::uint64_t{frame.id} + place_.offset;
  if (frame.extended || frame.id > CanFrame::kMaxStandardId || id > place_.last_id()) {
    return fail(Errc::OutOfRange, std::string(name()) + ": there is no identifier " +
                                      std::to_string(id) + " to send; expected one of 0 … " +
                                      std::to_string(place_.last_id()));
  }
  CanFrame moved = frame;
  moved.id = static_cast<std::uint32_t>(id);
  moved.extended = place_.extended;
  return inner_->send(moved, deadline);
}

Result<CanFrame> MovedBus::receive(Time deadline) {
  while (true) {
    auto frame = inner_->receive(deadline);
    if (!frame) return frame;
    const bool is_here = frame->extended == place_.extended && frame->id >= place_.offset &&
                         frame->id - place_.offset <= CanFrame::kMaxStandardId;
    if (!is_here) continue;
    frame->id -= place_.offset;
    frame->extended = false;
    const auto passes = [&](const CanFilter& filter) { return filter.passes(*frame); };
    if (filters_.empty() || std::ranges::any_of(filters_, passes)) return frame;
  }
}

// The bits of a sum are not those of its parts, so the bus under this one gets a filter only for
// its load.
Result<void> MovedBus::set_filters(std::span<const CanFilter> filters) {
  filters_.assign(filters.begin(), filters.end());
  const CanFilter of_format{.id = 0, .mask = 0, .extended = place_.extended};
  return inner_->set_filters({&of_format, filters.empty() ? 0U : 1U});
}

}  // namespace eyebridge::bridges
