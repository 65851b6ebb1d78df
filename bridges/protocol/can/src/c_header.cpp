// The CAN part of opcodes.h.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "eyebridge/bridges/can/generated.hpp"
#include "eyebridge/bridges/can/table.hpp"
#include "marked_part.hpp"

namespace eyebridge::bridges::can {
namespace {

struct Define {
  std::string name, number, comment;
};

std::string c_number(std::int64_t value, int hex_digits) {
  if (hex_digits == 0) return std::to_string(value);
  char text[32];
  std::snprintf(text, sizeof text, "0x%0*llX", hex_digits, static_cast<unsigned long long>(value));
  return text;
}

std::string group_text(const std::string& title, const std::vector<Define>& defines) {
  std::size_t width = 0;
  for (const Define& define : defines) {
    width = std::max(width, define.name.size() + define.number.size());
  }
  std::string out = "\n/* " + title + ". */\n";
  for (const Define& define : defines) {
    out += "#define EYECAN_" + define.name + " " + define.number +
           std::string(width - define.name.size() - define.number.size(), ' ') + " /* " +
           define.comment + " */\n";
  }
  return out;
}

std::string functions_text() {
  std::vector<Define> defines;
  for (const MessageSpec& spec : messages()) {
    if (spec.fd) {  // the same function as the classic frame before it
      defines.back().comment += "; as a CAN FD frame " + std::string(spec.name);
      continue;
    }
    defines.push_back(
        {std::string(spec.c_name), c_number(spec.function, 2), std::string(spec.name)});
  }
  return group_text("Functions: C_ from the host to robots, S_ from a robot to the host", defines);
}

}  // namespace

Result<std::string> update_opcodes(std::string_view old) {
  // Not formatted: the comments would be broken into lines.
  std::string part = "/* clang-format off */\n" + functions_text();
  for (const NameGroup* group : name_groups()) {
    std::vector<Define> defines;
    for (const Name& name : group->names) {
      defines.push_back({std::string(group->prefix) + std::string(name.name),
                         c_number(name.number, group->hex_digits), std::string(name.meaning)});
    }
    part += group_text(std::string(group->title) + (group->are_bits ? "; bits" : ""), defines);
  }
  part += "\n/* clang-format on */\n";
  return with_marked_part(old,
                          "/* Written by make_protocol from bridges/protocol/can: do not edit. */",
                          "/* End of what make_protocol writes. */", part);
}

}  // namespace eyebridge::bridges::can
