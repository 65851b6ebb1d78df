#include "program_code.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

namespace eyebridge::robios::program_code {
namespace {

struct Range {
  std::uintptr_t begin;
  std::uintptr_t end;
  int protection;

  [[nodiscard]] bool has(const void* address) const {
    const auto at = reinterpret_cast<std::uintptr_t>(address);
    return at >= begin && at < end;
  }
};

struct Loaded {
  std::vector<Range> code;
  unsigned long long count = 0;  ///< Of files loaded so far.
};

// A handler may read them at any time: they are never changed, and never destroyed.
std::vector<Range>* own = nullptr;
std::atomic<const Loaded*> programs = nullptr;
std::atomic<bool> has_barred = false;

/// Whole pages of what can be executed.
int add_code(dl_phdr_info* object, std::size_t /*size*/, void* given) {
  static const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  auto& loaded = *static_cast<Loaded*>(given);
  loaded.count = object->dlpi_adds;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const auto& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_LOAD || (segment.p_flags & PF_X) == 0) continue;
    const std::uintptr_t begin = object->dlpi_addr + segment.p_vaddr;
    const int can_write = (segment.p_flags & PF_W) != 0 ? PROT_WRITE : 0;
    loaded.code.push_back({begin / page * page, (begin + segment.p_memsz + page - 1) / page * page,
                           PROT_READ | PROT_EXEC | can_write});
  }
  return 0;
}

}  // namespace

void begin() {
  Loaded loaded;
  dl_iterate_phdr(add_code, &loaded);
  own = new std::vector<Range>(std::move(loaded.code));
}

bool is_own(const void* address) {
  return own != nullptr &&
         std::ranges::any_of(*own, [&](const Range& range) { return range.has(address); });
}

void survey() {
  auto loaded = std::make_unique<Loaded>();
  dl_iterate_phdr(add_code, loaded.get());
  const Loaded* const known = programs;
  if (has_barred || (known != nullptr && known->count == loaded->count)) return;
  std::erase_if(loaded->code, [](const Range& range) {
    return is_own(reinterpret_cast<const void*>(range.begin));
  });
  programs = loaded.release();
}

void bar() {
  const Loaded* const loaded = programs;
  if (loaded == nullptr || has_barred.exchange(true)) return;
  for (const Range& range : loaded->code) {
    mprotect(reinterpret_cast<void*>(range.begin), range.end - range.begin, PROT_READ);
  }
}

void unbar() {
  if (!has_barred) return;
  for (const Range& range : programs.load()->code) {
    mprotect(reinterpret_cast<void*>(range.begin), range.end - range.begin, range.protection);
  }
  has_barred = false;
}

bool is_barred() { return has_barred; }

bool is_barred(const void* address) {
  return has_barred && std::ranges::any_of(programs.load()->code,
                                           [&](const Range& range) { return range.has(address); });
}

}  // namespace eyebridge::robios::program_code
