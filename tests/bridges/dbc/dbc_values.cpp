// dbc_values FILE: what the frames on standard input mean by a DBC file, for judge_test.py.
//
// A line in is "ID DATA" in hex digits, bit 31 of ID set for 29 bits; lines out are
// "Message Signal raw value" with tabs, then "-".
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "eyebridge/bridges/dbc/read_dbc.hpp"
#include "eyebridge/bridges/dbc/signal.hpp"

namespace {

using namespace eyebridge::bridges;

void print(const dbc::Message& message, const std::vector<std::uint8_t>& data) {
  for (std::size_t i = 0; i < message.signals.size(); ++i) {
    const dbc::Signal& signal = message.signals[i];
    if (!dbc::is_present(message, i, data)) continue;
    const std::uint64_t bits = dbc::raw_bits(signal, data);
    std::printf("%s\t%s\t%llu\t%.17g\n", message.name.c_str(), signal.name.c_str(),
                static_cast<unsigned long long>(bits), dbc::value_of(signal, bits));
  }
}

int run(const char* file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const dbc::Database database = dbc::read_dbc(text, file);
  for (const dbc::Message& message : database.messages) {
    std::printf("%s\t%u\t%d\t%d\t%d\n", message.name.c_str(), message.id, message.extended ? 1 : 0,
                message.length, message.period_ms.value_or(0));
  }
  std::puts("-");
  std::string line;
  while (std::getline(std::cin, line)) {
    std::istringstream words(line);
    std::string id_text;
    std::string hex;
    words >> id_text >> hex;
    const unsigned long id = std::strtoul(id_text.c_str(), nullptr, 16);
    std::vector<std::uint8_t> data;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
      data.push_back(
          static_cast<std::uint8_t>(std::strtoul(hex.substr(i, 2).c_str(), nullptr, 16)));
    }
    for (const dbc::Message& message : database.messages) {
      const unsigned long own = message.id | (message.extended ? 0x8000'0000UL : 0UL);
      if (own == id) print(message, data);
    }
    std::puts("-");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: dbc_values FILE\n", stderr);
    return 2;
  }
  try {
    return run(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
