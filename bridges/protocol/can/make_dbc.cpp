// make_dbc [--fd] [--robots N] FILE: writes the CAN protocol as a DBC file.

#include <charconv>
#include <cstdio>
#include <cstring>
#include <string>

#include "eyebridge/bridges/can/dbc.hpp"
#include "opcodes.h"

namespace {

int usage() {
  std::fputs("usage: make_dbc [--fd] [--robots 1..14] FILE\n", stderr);
  return 2;
}

bool write_file(const char* path, const std::string& text) {
  std::FILE* file = std::fopen(path, "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  return std::fclose(file) == 0 && written;
}

}  // namespace

int main(int argc, char** argv) {
  eyebridge::bridges::can::DbcOptions options;
  const char* path = nullptr;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--fd") == 0) {
      options.fd = true;
    } else if (std::strcmp(argv[i], "--robots") == 0 && i + 1 < argc) {
      const char* text = argv[++i];
      const char* end = text + std::strlen(text);
      const auto read = std::from_chars(text, end, options.robots);
      const bool good = read.ec == std::errc{} && read.ptr == end && options.robots >= 1 &&
                        options.robots <= EYECAN_NODE_LAST;
      if (!good) return usage();
    } else if (argv[i][0] != '-' && path == nullptr) {
      path = argv[i];
    } else {
      return usage();
    }
  }
  if (path == nullptr) return usage();
  if (!write_file(path, eyebridge::bridges::can::write_dbc(options))) {
    std::perror(path);
    return 1;
  }
  return 0;
}
