#include "program_image.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>
#include <string_view>
#include <vector>

#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"
#include "generation.hpp"

namespace eyebridge::robios {
namespace {

using Bytes = std::vector<char>;

[[noreturn]] void refuse(const std::filesystem::path& program, const std::string& why) {
  throw ConfigError({program.string()}, why);
}

template <class Value>
Value* at(Bytes& file, std::uint64_t offset, std::uint64_t count = 1) {
  if (offset > file.size() || count > (file.size() - offset) / sizeof(Value)) return nullptr;
  return reinterpret_cast<Value*>(file.data() + offset);
}

constexpr const char* kExpected =
    "; expected a program built with eyebridge-cc or eyebridge-c++, without -no-pie and -static";

/// The C library keeps where these are in a program's words, once for all who call them; and of
/// optarg and optind each robot would have a copy of its own that they do not know.
void check_calls(const std::filesystem::path& program, const Bytes& file) {
  using namespace std::string_view_literals;
  const std::string_view text(file.data(), file.size());
  for (const std::string_view name :
       {"\0getopt\0"sv, "\0getopt_long\0"sv, "\0getopt_long_only\0"sv}) {
    if (text.find(name) == std::string_view::npos) continue;
    refuse(program, "found " + std::string(name.substr(1, name.size() - 2)) +
                        "(), which several robots cannot call in one process");
  }
}

/// Takes the mark off that it is a program. elf(5), and DT_FLAGS_1 of the System V gABI.
void unmark(const std::filesystem::path& program, Bytes& file) {
  const auto* header = at<ElfW(Ehdr)>(file, 0);
  if (header == nullptr || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0) {
    refuse(program,
           std::string("found a file that is no program, as several robots need one") + kExpected);
  }
  if (header->e_ident[EI_CLASS] != ELFCLASS64 || header->e_machine != EM_X86_64) {
#if defined(__x86_64__)
    refuse(program, "found a program for another kind of machine, expected one for x86-64");
#endif
  }
  if (header->e_type != ET_DYN) {
    refuse(program, std::string("found a program for a fixed address") + kExpected);
  }
  const auto* segments = at<ElfW(Phdr)>(file, header->e_phoff, header->e_phnum);
  if (segments == nullptr) refuse(program, "the program's file is cut off");
  bool is_dynamic = false;
  for (std::size_t i = 0; i < header->e_phnum; ++i) {
    if (segments[i].p_type == PT_TLS) {
      refuse(program,
             "found a program with thread_local variables, which several robots cannot have; "
             "expected global or static ones: each robot has its own");
    }
    if (segments[i].p_type != PT_DYNAMIC) continue;
    const std::size_t count = segments[i].p_filesz / sizeof(ElfW(Dyn));
    auto* entries = at<ElfW(Dyn)>(file, segments[i].p_offset, count);
    if (entries == nullptr) refuse(program, "the program's file is cut off");
    is_dynamic = true;
    for (std::size_t k = 0; k < count && entries[k].d_tag != DT_NULL; ++k) {
      if (entries[k].d_tag == DT_FLAGS_1) {
        entries[k].d_un.d_val &= ~static_cast<ElfW(Xword)>(DF_1_PIE);
      }
    }
  }
  if (!is_dynamic) refuse(program, std::string("found a static program") + kExpected);
}

/// The bytes of `program`, unmarked; read once.
const Bytes& contents(const std::filesystem::path& program) {
  static std::mutex mutex;
  static auto* const known = new std::map<std::filesystem::path, Bytes>;
  const std::lock_guard lock(mutex);
  const auto found = known->find(program);
  if (found != known->end()) return found->second;
  if (is_of_other_generation(program)) {
    refuse(program,
           "found a program for another generation of RoBIOS than the first robot's; expected all "
           "programs of a world to be of one");
  }
  std::ifstream stream(program, std::ios::binary);
  Bytes file{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) refuse(program, std::string("cannot be read: ") + std::strerror(errno));
  unmark(program, file);
  check_calls(program, file);
  return known->emplace(program, std::move(file)).first->second;
}

UniqueFd in_memory(const std::filesystem::path& program, const Bytes& file) {
  UniqueFd copy(memfd_create(program.filename().c_str(), MFD_CLOEXEC));
  std::size_t written = 0;
  while (copy.valid() && written < file.size()) {
    const ssize_t n = write(copy.get(), file.data() + written, file.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    written += static_cast<std::size_t>(n);
  }
  if (written < file.size()) {
    refuse(program, std::string("cannot be copied: ") + std::strerror(errno));
  }
  return copy;
}

/// A name under which the dynamic linker has not seen a file yet: it knows them by name, and a
/// descriptor's number comes again.
std::string fresh_name(int descriptor) {
  static std::atomic<std::uint64_t> next = 0;
  std::string name = "/proc/self/";
  for (std::uint64_t n = next++; n != 0; n /= 2) name += n % 2 != 0 ? "./" : "fd/../";
  return name + "fd/" + std::to_string(descriptor);
}

}  // namespace

std::unique_ptr<ProgramImage> ProgramImage::load(const std::filesystem::path& program) {
  const UniqueFd file = in_memory(program, contents(program));
  std::unique_ptr<ProgramImage> image(new ProgramImage);
  image->handle_ = dlopen(fresh_name(file.get()).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (image->handle_ == nullptr) {
    refuse(program, std::string("cannot be loaded for a robot: ") + dlerror());
  }
  image->main_ = reinterpret_cast<Main>(dlsym(image->handle_, "main"));
  if (image->main_ == nullptr) {
    refuse(program, std::string("found a program that hides its main()") + kExpected);
  }
  return image;
}

bool ProgramImage::can_load(const std::filesystem::path& program) {
  try {
    contents(program);
    return true;
  } catch (const ConfigError&) {
    return false;
  }
}

std::shared_ptr<ProgramImage> ProgramImage::load_shared(const std::filesystem::path& program) {
  static std::mutex mutex;
  static auto* const known = new std::map<std::filesystem::path, std::shared_ptr<ProgramImage>>;
  const std::lock_guard lock(mutex);
  std::shared_ptr<ProgramImage>& image = (*known)[program];
  if (image == nullptr) image = load(program);
  return image;
}

void* ProgramImage::variable(const std::string& name) const {
  link_map* map = nullptr;
  if (dlinfo(handle_, RTLD_DI_LINKMAP, &map) != 0) return nullptr;
  const ElfW(Sym)* symbols = nullptr;
  const char* names = nullptr;
  const ElfW(Rela)* relocations = nullptr;
  std::size_t size = 0;
  for (const ElfW(Dyn)* entry = map->l_ld; entry->d_tag != DT_NULL; ++entry) {
    // glibc has relocated these addresses on x86-64 and AArch64.
    if (entry->d_tag == DT_SYMTAB) {
      symbols = reinterpret_cast<const ElfW(Sym)*>(entry->d_un.d_ptr);
    } else if (entry->d_tag == DT_STRTAB) {
      names = reinterpret_cast<const char*>(entry->d_un.d_ptr);
    } else if (entry->d_tag == DT_RELA) {
      relocations = reinterpret_cast<const ElfW(Rela)*>(entry->d_un.d_ptr);
    } else if (entry->d_tag == DT_RELASZ) {
      size = entry->d_un.d_val;
    }
  }
  if (symbols == nullptr || names == nullptr || relocations == nullptr) return nullptr;
#if defined(__aarch64__)
  constexpr std::uint32_t kCopy = R_AARCH64_COPY;
#else
  constexpr std::uint32_t kCopy = R_X86_64_COPY;
#endif
  const ElfW(Rela)* const end = relocations + size / sizeof(ElfW(Rela));
  const auto* found = std::find_if(relocations, end, [&](const ElfW(Rela) & relocation) {
    return ELF64_R_TYPE(relocation.r_info) == kCopy &&
           name == names + symbols[ELF64_R_SYM(relocation.r_info)].st_name;
  });
  return found == end ? nullptr : reinterpret_cast<void*>(map->l_addr + found->r_offset);
}

}  // namespace eyebridge::robios
