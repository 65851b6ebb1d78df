#include "system_files.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>

#include "eyebridge/base/text.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

template <class Number>
std::optional<Number> whole_number(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

fs::path below(const fs::path& root, std::string_view path) {
  return root / fs::path(path).relative_path();
}

std::optional<std::string> line_of(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line)) return std::nullopt;
  return std::string(trimmed(line));
}

std::optional<long> number_of(const fs::path& file) {
  const auto line = line_of(file);
  return line ? whole_number<long>(*line) : std::nullopt;
}

std::vector<std::string> names_in(const fs::path& folder,
                                  std::initializer_list<std::string_view> prefixes) {
  std::vector<std::string> out;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::string name = at->path().filename();
    const auto begins = [&](std::string_view prefix) { return name.starts_with(prefix); };
    if (prefixes.size() == 0 || std::any_of(prefixes.begin(), prefixes.end(), begins)) {
      out.push_back(std::move(name));
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<Process> processes(const fs::path& root) {
  const fs::path proc = below(root, "/proc");
  std::vector<Process> out;
  for (const std::string& name : names_in(proc)) {
    const auto id = whole_number<int>(name);
    if (!id) continue;
    if (auto called = line_of(proc / name / "comm")) out.push_back({*id, std::move(*called)});
  }
  std::sort(out.begin(), out.end(), [](const Process& a, const Process& b) { return a.id < b.id; });
  return out;
}

std::string described(const Process& process) {
  if (process.id <= 0) return "a process outside of this container";
  const std::string id = "process " + std::to_string(process.id);
  return process.name.empty() ? id : process.name + " (" + id + ")";
}

}  // namespace eyebridge::apps
