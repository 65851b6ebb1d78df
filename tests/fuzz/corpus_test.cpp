#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "bridges_entry.hpp"
#include "camera_entry.hpp"
#include "classic_entry.hpp"
#include "dbc_entry.hpp"
#include "entry.hpp"
#include "firmware_entry.hpp"
#include "foreign_entry.hpp"
#include "gui_entry.hpp"
#include "host_entry.hpp"
#include "map_entry.hpp"
#include "plant_link_entry.hpp"
#include "program_entry.hpp"
#include "remote_entry.hpp"
#include "sweep_entry.hpp"

namespace eyebridge::fuzz {
namespace {

using Entry = void (*)(std::string_view);

struct Target {
  const char* name;
  Entry run;
};

constexpr Target kTargets[] = {{"world", world},
                               {"maze", maze},
                               {"encoding", encoding},
                               {"robi", robi},
                               {"object", object},
                               {"keys", keys},
                               {"sim", sim},
                               {"parameter", parameter},
                               {"hdt", hdt},
                               {"pnm", pnm},
                               {"picture", picture},
                               {"calibration", calibration},
                               {"config", config},
                               {"run_plan", run_plan},
                               {"errors", errors},
                               {"faults", faults},
                               {"hand", hand},
                               {"svg", svg},
                               {"stage", stage},
                               {"irsim", irsim},
                               {"map_yaml", map_yaml},
                               {"map_pgm", map_pgm},
                               {"map_csv", map_csv},
                               {"message", message},
                               {"radio", radio},
                               {"radio_datagram", radio_datagram},
                               {"remote_message", remote_message},
                               {"serial_devices", serial_devices},
                               {"sound", sound},
                               {"sample", sample},
                               {"program_names", program_names},
                               {"sweep", sweep},
                               {"outcome", outcome},
                               {"recording", recording},
                               {"terminal_input", terminal_input},
                               {"camera_frame", camera_frame},
                               {"camera_url", camera_url},
                               {"io7_reply", io7_reply},
                               {"io7_help", io7_help},
                               {"can_frame", can_frame},
                               {"trace", trace},
                               {"url", url},
                               {"dbc", dbc},
                               {"dbc_map", dbc_map},
                               {"firmware", firmware},
                               {"plant_link", plant_link}};

const auto kCorpus = std::filesystem::path(EYEBRIDGE_SOURCE_DIR) / "tests/fuzz/corpus";

class FuzzCorpus : public testing::TestWithParam<Target> {};

void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

TEST_P(FuzzCorpus, NoInputIsAcceptedWrongly) {
  const auto folder = kCorpus / GetParam().name;
  ASSERT_TRUE(std::filesystem::is_directory(folder)) << folder << " is missing";
  int inputs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::FILE* file = std::fopen(entry.path().c_str(), "rb");
    ASSERT_NE(file, nullptr) << entry.path();
    std::string text(static_cast<std::size_t>(entry.file_size()), '\0');
    const std::size_t got = std::fread(text.data(), 1, text.size(), file);
    std::fclose(file);
    ASSERT_EQ(got, text.size()) << entry.path();
    GetParam().run(text);
    ++inputs;
  }
  EXPECT_GE(inputs, 3);
}

TEST(FuzzCorpusFolders, AllHaveATarget) {
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus)) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(std::ranges::any_of(kTargets, [&](const Target& t) { return name == t.name; }))
        << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Readers, FuzzCorpus, testing::ValuesIn(kTargets),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace eyebridge::fuzz
