#include "sweep/outcome.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "eyebridge/base/text.hpp"

namespace eyebridge::apps {
namespace {

constexpr std::size_t kLongestValue = 1000;
constexpr std::size_t kMostResults = 1000;

template <class Number>
std::optional<Number> number(std::string_view text) {
  text = trimmed(text);
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

bool is_name(std::string_view text) {
  return !text.empty() && text.size() <= 64 && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  });
}

/// `text` without control characters, which would spoil a table.
std::string on_one_line(std::string_view text) {
  std::string out(text);
  std::ranges::replace_if(
      out, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
  return out;
}

void read_report(Outcome& outcome, const std::filesystem::path& path) {
  constexpr std::string_view kColumns[] = {"time",       "distance",   "collisions", "stuck",
                                           "state_hash", "trace_hash", "ended"};
  std::ifstream file(path);
  std::map<std::string, std::string> entries;
  for (std::string line; std::getline(file, line);) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) continue;
    const std::string name(trimmed(std::string_view(line).substr(0, equals)));
    const std::string value(trimmed(std::string_view(line).substr(equals + 1)));
    const bool is_new = entries.emplace(name, value).second;
    const bool is_column = std::ranges::find(kColumns, name) != std::end(kColumns);
    if (is_new && !is_column && number<double>(value)) outcome.results.emplace_back(name, value);
  }
  outcome.time = number<double>(entries["time"]);
  outcome.distance = number<double>(entries["distance"]);
  outcome.collisions = number<std::uint64_t>(entries["collisions"]);
  std::string& hash = entries["state_hash"];
  if (entries["ended"] == "true" && hash.size() == 18) outcome.state_hash = hash.substr(1, 16);
}

void read_results(Outcome& outcome, const std::filesystem::path& path) {
  constexpr std::string_view kWord = "result ";
  std::ifstream file(path, std::ios::binary);
  const auto of_report = static_cast<std::ptrdiff_t>(outcome.results.size());
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(kWord)) continue;
    const std::string_view rest = trimmed(std::string_view(line).substr(kWord.size()));
    const std::size_t blank = rest.find(' ');
    std::string name(rest.substr(0, blank));
    if (blank == std::string_view::npos || !is_name(name)) continue;
    const std::string value = on_one_line(trimmed(rest.substr(blank)).substr(0, kLongestValue));
    const auto same = [&](const auto& result) { return result.first == name; };
    const auto measured = outcome.results.begin() + of_report;
    // A program may call its own numbers as the report calls ours.
    if (std::find_if(outcome.results.begin(), measured, same) != measured) name = "result." + name;
    const auto present = std::ranges::find_if(outcome.results, same);
    if (present != outcome.results.end()) {
      present->second = value;
    } else if (outcome.results.size() < kMostResults) {
      outcome.results.emplace_back(name, value);
    }
  }
}

// Fields are separated by what no line of text holds.
constexpr char kEnd = '\x1E';

template <class Number>
std::string text_of(const std::optional<Number>& value) {
  return value ? fmt::format("{}", *value) : "";
}

}  // namespace

void read_files(Outcome& outcome, const std::filesystem::path& report,
                const std::filesystem::path& output) {
  read_report(outcome, report);
  read_results(outcome, output);
}

std::string last_line(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (const std::string_view text = trimmed(line); !text.empty()) last = text;
  }
  return on_one_line(last.substr(0, 200));
}

std::string signal_name(int signal) {
  const char* name = sigabbrev_np(signal);
  return name != nullptr ? std::string("SIG") + name : fmt::format("signal {}", signal);
}

std::string to_text(const Outcome& o) {
  std::string text;
  for (const std::string& field :
       {o.how, o.reason, text_of(o.exit_code), text_of(o.signal), text_of(o.time),
        text_of(o.distance), text_of(o.collisions), o.state_hash, fmt::format("{}", o.wall),
        fmt::format("{}", o.cpu)}) {
    text += field + kEnd;
  }
  for (const auto& [name, value] : o.results) text += name + kEnd + value + kEnd;
  return text;
}

Outcome outcome_from_text(const std::string& text) {
  std::vector<std::string> fields;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find(kEnd, begin);
    if (end == std::string::npos) throw std::runtime_error("an outcome without an end");
    fields.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  constexpr std::size_t kFixed = 10;
  if (fields.size() < kFixed || (fields.size() - kFixed) % 2 != 0) {
    throw std::runtime_error(fmt::format("an outcome of {} fields", fields.size()));
  }
  Outcome o{fields[0],
            fields[1],
            number<int>(fields[2]),
            number<int>(fields[3]),
            number<double>(fields[4]),
            number<double>(fields[5]),
            number<std::uint64_t>(fields[6]),
            fields[7],
            number<double>(fields[8]).value_or(0.0),
            number<double>(fields[9]).value_or(0.0),
            {}};
  for (std::size_t i = kFixed; i < fields.size(); i += 2) {
    o.results.emplace_back(fields[i], fields[i + 1]);
  }
  return o;
}

}  // namespace eyebridge::apps
