#include "recording_text.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

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
std::string devices_text(const std::vector<hal::ListedDevice>& devices) {
  std::vector<std::pair<std::string, std::vector<int>>> kinds;
  for (const hal::ListedDevice& device : devices) {
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

/// "237, 160 x 120 pixels, lossless, 2.5 MB, 29.8 a second, 3 dropped"; sizes and codecs that are
/// mixed are all named.
std::string frames_text(std::span<const camera::RecordedFrame> frames) {
  if (frames.empty()) return "none";
  std::set<std::string> kinds;
  double bytes = 0.0;
  std::uint64_t dropped = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const camera::RecordedFrame& frame = frames[i];
    kinds.insert(fmt::format("{} x {} pixels, {}", frame.size.width, frame.size.height,
                             camera::name_of(frame.codec)));
    bytes += static_cast<double>(frame.bytes);
    // A camera that was opened again counts from 0 again.
    const bool goes_on = i > 0 && frame.sequence > frames[i - 1].sequence;
    if (goes_on) dropped += frame.sequence - frames[i - 1].sequence - 1;
  }
  std::string out =
      fmt::format("{}, {}, {:.1f} MB", frames.size(), fmt::join(kinds, " and "), bytes / 1e6);
  const double span = to_seconds(frames.back().given - frames.front().given);
  if (span > 0.0) {
    out += fmt::format(", {:.1f} a second", static_cast<double>(frames.size() - 1) / span);
  }
  return out + fmt::format(", {} dropped", dropped);
}

}  // namespace

std::string recording_summary(const hal::Recording& recording,
                              std::span<const camera::RecordedFrame> frames,
                              const std::string& name) {
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
  Time end = recording.exchanges.empty() ? Time{0} : recording.exchanges.back().time;
  if (!frames.empty()) end = std::max(end, frames.back().given);
  std::string out = name + "\n";
  out += fmt::format("  program   {}\n", or_unknown(origin.program));
  out += fmt::format("  backend   {}{}\n", or_unknown(origin.hal),
                     origin.world.empty() ? "" : ", world " + origin.world);
  out += fmt::format("  duration  {:.3f} s\n", to_seconds(end));
  out += fmt::format("  devices   {}\n", devices_text(recording.devices));
  out += fmt::format("  calls     {}, {} of them failed\n", recording.exchanges.size(), errors);
  out += fmt::format("  frames    {}\n", frames_text(frames));
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
