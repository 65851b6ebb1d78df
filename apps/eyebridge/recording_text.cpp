#include "recording_text.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include <fmt/format.h>

namespace eyebridge::apps {
namespace {

struct CallCount {
  std::size_t calls = 0;
  std::size_t errors = 0;
  Time first{0};
  Time last{0};
};

std::string name_of(const hal::Exchange& exchange) {
  return fmt::format("{} {} {}", exchange.device, exchange.id, exchange.name);
}

std::string or_unknown(const std::string& text) { return text.empty() ? "not told" : text; }

/// "drive, psd 1-4, motor 1 2": kinds in the order of the recording.
std::string devices_text(const std::vector<hal::RecordedDevice>& devices) {
  std::vector<std::pair<std::string, std::vector<int>>> kinds;
  for (const hal::RecordedDevice& device : devices) {
    const auto kind = std::ranges::find(kinds, device.kind, [](const auto& k) { return k.first; });
    if (kind == kinds.end()) {
      kinds.push_back({device.kind, {device.id}});
    } else {
      kind->second.push_back(device.id);
    }
  }
  std::string out;
  for (auto& [kind, ids] : kinds) {
    std::ranges::sort(ids);
    out += (out.empty() ? "" : ", ") + kind;
    if (ids.size() == 1 && ids.front() == 1) continue;
    const bool is_range = ids.back() - ids.front() + 1 == static_cast<int>(ids.size());
    if (is_range && ids.size() > 2) {
      out += fmt::format(" {}-{}", ids.front(), ids.back());
    } else {
      for (const int id : ids) out += fmt::format(" {}", id);
    }
  }
  return out.empty() ? "none" : out;
}

std::string numbers(const hal::Values& values) {
  constexpr std::size_t kMost = 8;  // a scan has hundreds
  std::string out;
  for (std::size_t i = 0; i < std::min(values.size(), kMost); ++i) {
    out += fmt::format("{}{:.6g}", i == 0 ? "" : " ", values[i]);
  }
  if (values.size() > kMost) out += fmt::format(" … ({} numbers)", values.size());
  return out;
}

}  // namespace

std::string recording_summary(const hal::Recording& recording, const std::string& name) {
  std::map<std::string, CallCount> counts;
  std::size_t errors = 0;
  for (const hal::Exchange& exchange : recording.exchanges) {
    CallCount& count = counts[name_of(exchange)];
    if (count.calls++ == 0) count.first = exchange.time;
    count.last = exchange.time;
    if (exchange.reply) continue;
    ++count.errors;
    ++errors;
  }
  const auto& origin = recording.origin;
  const Time end = recording.exchanges.empty() ? Time{0} : recording.exchanges.back().time;
  std::string out = name + "\n";
  out += fmt::format("  program   {}\n", or_unknown(origin.program));
  out += fmt::format("  backend   {}{}\n", or_unknown(origin.hal),
                     origin.world.empty() ? "" : ", world " + origin.world);
  out += fmt::format("  duration  {:.3f} s\n", to_seconds(end));
  out += fmt::format("  devices   {}\n", devices_text(recording.devices));
  out += fmt::format("  calls     {}, {} of them failed\n", recording.exchanges.size(), errors);
  if (counts.empty()) return out;
  out += fmt::format("\n{:<24} {:>8} {:>10} {:>10} {:>7}\n", "call", "times", "first", "last",
                     "failed");
  for (const auto& [call, count] : counts) {
    out += fmt::format("{:<24} {:>8} {:>8.3f} s {:>8.3f} s {:>7}\n", call, count.calls,
                       to_seconds(count.first), to_seconds(count.last), count.errors);
  }
  return out;
}

std::string recording_calls(const hal::Recording& recording, std::size_t most) {
  std::string out;
  for (std::size_t i = 0; i < std::min(most, recording.exchanges.size()); ++i) {
    const hal::Exchange& exchange = recording.exchanges[i];
    out += fmt::format("{:>10.3f} s  {}", to_seconds(exchange.time), name_of(exchange));
    if (!exchange.request.empty()) out += " (" + numbers(exchange.request) + ")";
    if (!exchange.reply) {
      out += ": failed: " + exchange.reply.error().what;
    } else if (!exchange.reply->empty()) {
      out += ": " + numbers(*exchange.reply);
    }
    out += "\n";
  }
  const std::size_t left = recording.exchanges.size() - std::min(most, recording.exchanges.size());
  if (left > 0) out += fmt::format("{:>10}    {} more\n", "…", left);
  return out;
}

}  // namespace eyebridge::apps
