// Writes what is made from the table of the CAN protocol.
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "eyebridge/bridges/can/generated.hpp"
#include "eyebridge/bridges/can/table.hpp"

namespace {

namespace can = eyebridge::bridges::can;

int usage() {
  std::fputs(
      "usage: make_protocol --update FOLDER         opcodes.h, SPECIFICATION.md, eyebridge.dbc and "
      "eyebridge_fd.dbc there\n"
      "       make_protocol [--fd] [--robots 0..14] FILE   a DBC file; 0: one robot, for tools "
      "that "
      "mask the node\n",
      stderr);
  return 2;
}

int failed(const std::string& path, const std::string& why) {
  std::fprintf(stderr, "%s: %s\n", path.c_str(), why.c_str());
  return 1;
}

int write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  return file ? 0 : failed(path, std::strerror(errno));
}

int update_file(const std::string& path,
                eyebridge::Result<std::string> (*update)(std::string_view)) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return failed(path, std::strerror(errno));
  const std::string old{std::istreambuf_iterator<char>(file), {}};
  const auto text = update(old);
  if (!text) return failed(path, text.error().what);
  return *text == old ? 0 : write_file(path, *text);  // what is the same need not be built again
}

int update_folder(const std::string& folder) {
  return update_file(folder + "/opcodes.h", can::update_opcodes) +
         update_file(folder + "/SPECIFICATION.md", can::update_specification) +
         write_file(folder + "/eyebridge.dbc", can::write_dbc({})) +
         write_file(folder + "/eyebridge_fd.dbc", can::write_dbc({.fd = true}));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::strcmp(argv[1], "--update") == 0) return update_folder(argv[2]) > 0 ? 1 : 0;
  can::DbcOptions options;
  const char* path = nullptr;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--fd") == 0) {
      options.fd = true;
    } else if (std::strcmp(argv[i], "--robots") == 0 && i + 1 < argc) {
      const char* text = argv[++i];
      const char* end = text + std::strlen(text);
      const auto read = std::from_chars(text, end, options.robots);
      const bool good = read.ec == std::errc{} && read.ptr == end && options.robots >= 0 &&
                        options.robots <= can::kLastNode;
      if (!good) return usage();
    } else if (argv[i][0] != '-' && path == nullptr) {
      path = argv[i];
    } else {
      return usage();
    }
  }
  return path == nullptr ? usage() : write_file(path, can::write_dbc(options));
}
