#include "program_variables.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <new>

#include <dlfcn.h>
#include <elf.h>
#include <link.h>

namespace eyebridge::robios {
namespace {

#if defined(__aarch64__)
constexpr std::uint32_t kCopy = R_AARCH64_COPY;
constexpr std::uint32_t kTable = R_AARCH64_GLOB_DAT;
constexpr std::uint32_t kAddress = R_AARCH64_ABS64;
#else
constexpr std::uint32_t kCopy = R_X86_64_COPY;
constexpr std::uint32_t kTable = R_X86_64_GLOB_DAT;
constexpr std::uint32_t kAddress = R_X86_64_64;
#endif

/// What the dynamic section of an image says of its relocations.
struct Relocations {
  explicit Relocations(const link_map& image) {
    for (const ElfW(Dyn)* entry = image.l_ld; entry->d_tag != DT_NULL; ++entry) {
      // glibc has relocated these addresses on x86-64 and AArch64.
      if (entry->d_tag == DT_SYMTAB) {
        symbols = reinterpret_cast<const ElfW(Sym)*>(entry->d_un.d_ptr);
      } else if (entry->d_tag == DT_STRTAB) {
        names = reinterpret_cast<const char*>(entry->d_un.d_ptr);
      } else if (entry->d_tag == DT_RELA) {
        first = reinterpret_cast<const ElfW(Rela)*>(entry->d_un.d_ptr);
      } else if (entry->d_tag == DT_RELASZ) {
        count = entry->d_un.d_val / sizeof *first;
      }
    }
    if (symbols == nullptr || names == nullptr || first == nullptr) count = 0;
  }

  const ElfW(Sym) * symbols = nullptr;
  const char* names = nullptr;
  const ElfW(Rela) * first = nullptr;
  std::size_t count = 0;
};

bool is_stream(const void* place) {
  const std::array<const void*, 8> streams{&std::cin,  &std::cout,  &std::cerr,  &std::clog,
                                           &std::wcin, &std::wcout, &std::wcerr, &std::wclog};
  return std::ranges::find(streams, place) != streams.end();
}

/// In the library that this function is in.
bool is_ours(const Dl_info& info) {
  static const void* const base = [] {
    Dl_info own{};
    dladdr(reinterpret_cast<const void*>(&is_stream), &own);
    return own.dli_fbase;
  }();
  return info.dli_fbase == base;
}

/// The size of the variable at `place` that each robot is to have for itself; 0 for functions and
/// for what all share.
std::size_t own_size(const void* place) {
  Dl_info info{};
  const ElfW(Sym)* symbol = nullptr;
  if (dladdr1(place, &info, const_cast<void**>(reinterpret_cast<const void**>(&symbol)),
              RTLD_DL_SYMENT) == 0 ||
      symbol == nullptr || info.dli_saddr != place ||
      ELF64_ST_TYPE(symbol->st_info) != STT_OBJECT || !(is_ours(info) || is_stream(place))) {
    return 0;
  }
  return symbol->st_size;
}

}  // namespace

ProgramVariables::ProgramVariables(const link_map& image) {
  const Relocations relocations(image);
  const auto each = [&](auto visit) {
    for (std::size_t i = 0; i < relocations.count; ++i) {
      const ElfW(Rela)& one = relocations.first[i];
      const ElfW(Sym)& symbol = relocations.symbols[ELF64_R_SYM(one.r_info)];
      visit(ELF64_R_TYPE(one.r_info), relocations.names + symbol.st_name, symbol,
            reinterpret_cast<void*>(image.l_addr + one.r_offset), one.r_addend);
    }
  };
  each([&](std::uint32_t type, const char* name, const ElfW(Sym) & symbol, void* place, auto) {
    if (type == kCopy) add(name, place, dlsym(RTLD_DEFAULT, name), symbol.st_size);
  });
  each([&](std::uint32_t type, const char* name, const ElfW(Sym)&, void* place,
           std::int64_t addend) {
    if (type != kTable && type != kAddress) return;
    const std::int64_t beyond = type == kAddress ? addend : 0;
    auto* const address = static_cast<std::byte**>(place);
    if (void* const copy = copy_of(name, *address - beyond)) {
      *address = static_cast<std::byte*>(copy) + beyond;
    }
  });
}

void* ProgramVariables::copy_of(const char* name, const void* original) {
  if (void* const known = find(name)) return known;
  const std::size_t size = own_size(original);
  if (size == 0) return nullptr;
  void* const place = ::operator new (size, std::align_val_t{64});  // for good, as the image
  std::memcpy(place, original, size);
  add(name, place, original, size);
  return place;
}

void ProgramVariables::add(const char* name, void* place, const void* original, std::size_t size) {
  // What points into itself, as std::cout, still points into the library's.
  const auto from = reinterpret_cast<std::uintptr_t>(original);
  auto* const words = static_cast<std::uintptr_t*>(place);
  for (std::size_t i = 0; i < size / sizeof *words; ++i) {
    if (words[i] >= from && words[i] - from < size) {
      words[i] += reinterpret_cast<std::uintptr_t>(place) - from;
    }
  }
  variables_.push_back({name, place});
}

void* ProgramVariables::find(const std::string& name) const {
  const auto found = std::ranges::find(variables_, name, &Variable::name);
  return found != variables_.end() ? found->place : nullptr;
}

}  // namespace eyebridge::robios
