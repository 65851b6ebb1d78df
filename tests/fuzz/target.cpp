// A libFuzzer target: ENTRY of HEADER, which CMakeLists.txt names, gets every input.
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include EYEBRIDGE_FUZZ_HEADER

namespace {

/// How many bytes all inputs had together: told at the end, beside libFuzzer's own figures.
struct Fed {
  std::uint64_t bytes = 0;
  ~Fed() { std::fprintf(stderr, "stat::number_of_bytes: %llu\n", 0ULL + bytes); }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Fed fed;
  fed.bytes += size;
  eyebridge::fuzz::EYEBRIDGE_FUZZ_ENTRY({reinterpret_cast<const char*>(data), size});
  return 0;
}
