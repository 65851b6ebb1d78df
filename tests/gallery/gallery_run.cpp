#include "gallery_run.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "eyebridge/camera/png.hpp"
#include "lcd_cells.hpp"
#include "run_program.hpp"
#include "trail.hpp"

namespace eyebridge::gallery {
namespace {

namespace fs = std::filesystem;

const fs::path kGallery = EYEBRIDGE_SOURCE_DIR "/tests/gallery";
constexpr std::size_t kFileLines = 40;

/// Puts what the program needs into `folder`; its sources' names.
std::vector<std::string> unpack(const Row& row, const fs::path& folder) {
  const auto take = [&](const fs::path& from) {
    fs::copy_file(from, folder / from.filename());
    return from.filename().string();
  };
  for (const std::string& file : row.files) take(kGallery / file);
  const fs::path source = kGallery / row.source;
  if (!fs::is_directory(source)) return {take(source)};
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(source)) names.push_back(take(entry.path()));
  std::erase_if(names, [](const std::string& name) { return name.ends_with(".h"); });
  std::ranges::sort(names);
  return names;
}

/// Compiles unless it is Python; the program's name.
std::string build(const Row& row, const std::vector<std::string>& sources, const fs::path& folder) {
  if (row.is_python()) return sources.front();
  const bool cpp = sources.front().ends_with(".cpp");
  std::vector<std::string> command = {
      std::string(EYEBRIDGE_BIN) + (cpp ? "/eyebridge-c++" : "/eyebridge-cc"), "-o",
      row.name + ".x"};
  if (row.classic) command.emplace_back("--classic");
  command.insert(command.end(), sources.begin(), sources.end());
  command.emplace_back("-lm");
  const testing::ProgramRun run = testing::run_program({command, {}, folder});
  if (run.exit_code != 0) throw std::runtime_error("does not compile:\n" + run.err);
  return "./" + row.name + ".x";
}

testing::ProgramRun start(const Row& row, const std::string& program, const fs::path& folder,
                          const fs::path& out) {
  std::vector<std::string> command = {EYEBRIDGE_BIN "/eyebridge", "run", "--fast", "--out", out};
  const auto add = [&](const char* flag, const std::string& value) {
    if (!value.empty()) command.insert(command.end(), {flag, value});
  };
  if (!row.world.empty()) {
    const fs::path own = kGallery / row.world;
    add("--world", fs::exists(own) ? own.string() : EYEBRIDGE_SOURCE_DIR "/worlds/" + row.world);
  }
  add("--keys", row.keys);
  add("--time-limit", row.time_limit);
  add("--seed", "1");
  command.push_back(program);
  command.insert(command.end(), row.arguments.begin(), row.arguments.end());
  std::map<std::string, std::string> environment = {{"XDG_CONFIG_HOME", "/dev/null/none"}};
  if (row.is_python()) {
    environment["PATH"] = "/usr/bin:/bin";  // Debian's, for which the packages are: it has numpy
#ifdef EYEBRIDGE_TEST_PRELOAD
    environment["LD_PRELOAD"] = EYEBRIDGE_TEST_PRELOAD;
    environment["ASAN_OPTIONS"] = "detect_leaks=0";  // what Python leaves behind is not ours
#endif
  }
  return testing::run_program({command, environment, folder});
}

/// Takes the message about the results from `err`; the robot's time in it, "12.34 s".
std::string take_time(Lines& err) {
  constexpr std::string_view kTimes = " on the robot's clock in ";
  constexpr std::string_view kStart = "eyebridge: ";
  const auto found = std::ranges::find_if(err, [&](const std::string& line) {
    return line.starts_with(kStart) && line.find(kTimes) != std::string::npos;
  });
  if (found == err.end()) return "no time: the program never called RoBIOS";
  std::string time = found->substr(kStart.size(), found->find(kTimes) - kStart.size());
  err.erase(found);
  return time;
}

/// Messages name files of the source tree, wherever that is.
std::string without_folder(std::string text) {
  constexpr std::string_view kFolder = EYEBRIDGE_SOURCE_DIR "/";
  for (std::size_t at = 0; (at = text.find(kFolder, at)) != std::string::npos;) {
    text.erase(at, kFolder.size());
  }
  return text;
}

Lines file_lines(const fs::path& folder, const std::set<std::string>& before) {
  std::map<std::string, Lines> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (before.contains(name) || !entry.is_regular_file()) continue;
    files[name] = lines_of(testing::file_text(entry.path()));
  }
  Lines lines;
  for (const auto& [name, text] : files) {
    lines.push_back(fmt::format("{}: {} lines", name, text.size()));
    const auto shown = static_cast<long>(std::min(text.size(), kFileLines));
    for (const std::string& line : Lines(text.begin(), text.begin() + shown)) {
      lines.push_back("  " + line);
    }
  }
  return lines;
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

Lines picture_lines(const Row& row, const camera::Frame& lcd) {
  Lines lines = {fmt::format("{} x {}", lcd.width, lcd.height)};
  if (!row.camera) lines.front() += ", pixels " + hash_of(lcd);
  for (std::string& line : lcd_cells(lcd)) lines.push_back(std::move(line));
  return lines;
}

void keep_pictures(const Row& row, const fs::path& out, const fs::path& pictures) {
  if (pictures.empty()) return;
  fs::create_directories(pictures);
  for (const char* name : {"lcd.png", "map.png"}) {
    if (!fs::exists(out / name)) continue;  // a program that died leaves none
    fs::copy_file(out / name, pictures / (row.name + "-" + name),
                  fs::copy_options::overwrite_existing);
  }
}

}  // namespace

Golden run_program_of(const Row& row, const fs::path& pictures) {
  const testing::ScratchFolder scratch;
  const fs::path folder = fs::path(scratch.path()) / "program";
  const fs::path out = fs::path(scratch.path()) / "out";
  fs::create_directory(folder);
  const std::string program = build(row, unpack(row, folder), folder);
  const std::set<std::string> before = names_in(folder);
  const testing::ProgramRun run = start(row, program, folder, out);

  Lines printed = lines_of(run.out);
  if (row.threads) std::ranges::sort(printed);
  Lines messages = lines_of(without_folder(run.err));
  const std::string time = take_time(messages);
  Golden golden;
  const auto add = [&](const char* name, Lines lines) {
    if (!lines.empty()) golden.sections.emplace_back(name, std::move(lines));
  };
  add("end", {fmt::format("exit code {}", run.exit_code) + (row.threads ? "" : " after " + time)});
  add("stdout", printed);
  add("stderr", messages);
  if (!fs::exists(out / "lcd.png")) {
    throw std::runtime_error("the program left no results:\n" + to_text(golden));
  }
  add("lcd text", lines_of(testing::file_text(out / "lcd.txt")));
  add("lcd picture", picture_lines(row, camera::read_png(out / "lcd.png")));
  add("files", file_lines(folder, before));
  add("trail", trail_lines(testing::file_text(out / "trace.csv"), row.threads));
  keep_pictures(row, out, pictures);
  return golden;
}

}  // namespace eyebridge::gallery
