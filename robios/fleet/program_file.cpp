#include "program_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <map>
#include <mutex>
#include <string_view>
#include <system_error>
#include <utility>

#include <dlfcn.h>
#include <elf.h>
#include <link.h>

#include "eyebridge/base/read_file.hpp"
#include "generation.hpp"
#include "robot_program.hpp"

namespace eyebridge::robios {
namespace {

namespace fs = std::filesystem;

using Bytes = std::vector<char>;

[[noreturn]] void refuse(const fs::path& program, const std::string& why) {
  throw ConfigError({program.string()}, why);
}

template <class Value>
Value* at(Bytes& file, std::uint64_t offset, std::uint64_t count = 1) {
  if (offset > file.size() || count > (file.size() - offset) / sizeof(Value)) return nullptr;
  return reinterpret_cast<Value*>(file.data() + offset);
}

constexpr const char* kExpected =
    "; expected a program built with eyebridge-cc or eyebridge-c++, without -no-pie and -static";

struct Machine {
  int elf;           ///< What a program's file calls it.
  const char* name;  ///< What its users call it.
};
#if defined(__x86_64__)
constexpr Machine kMachine{EM_X86_64, "x86-64"};
#elif defined(__aarch64__)
constexpr Machine kMachine{EM_AARCH64, "arm64"};
#else
#error "several robots in one process: the number of this machine in elf(5) is missing here"
#endif

/// Takes the mark off that it is a program, and what would be called too early or too late. elf(5),
/// and DT_FLAGS_1 of the System V gABI.
void change(ElfW(Dyn) & entry, ProgramFile& file) {
  const auto take_other = [&](ProgramFile::Functions& functions) {
    functions.other = std::exchange(entry.d_un.d_ptr, 0);
    entry.d_tag = DT_DEBUG;  // means nothing in a library
  };
  const auto take_count = [&](ProgramFile::Functions& functions) {
    functions.count = std::exchange(entry.d_un.d_val, 0) / sizeof(ElfW(Addr));
  };
  if (entry.d_tag == DT_FLAGS_1) {
    entry.d_un.d_val &= ~static_cast<ElfW(Xword)>(DF_1_PIE);
  } else if (entry.d_tag == DT_INIT_ARRAY) {
    file.starts.array = entry.d_un.d_ptr;
  } else if (entry.d_tag == DT_INIT_ARRAYSZ) {
    take_count(file.starts);
  } else if (entry.d_tag == DT_INIT) {
    take_other(file.starts);
  } else if (entry.d_tag == DT_FINI_ARRAY) {
    file.ends.array = entry.d_un.d_ptr;
  } else if (entry.d_tag == DT_FINI_ARRAYSZ) {
    take_count(file.ends);
  } else if (entry.d_tag == DT_FINI) {
    take_other(file.ends);
  }
}

/// The C library keeps where these are in a program's words, once for all who call them; and of
/// optarg and optind each robot would have a copy of its own that they do not know.
constexpr std::array<std::string_view, 1> kOnceForAll = {"getopt"};
/// Threads of POSIX, C and C++, of OpenMP, of parallel algorithms, of classic RoBIOS, and what they
/// wait for each other with: in virtual time all robots of a process run in one thread.
constexpr std::array<std::string_view, 14> kThreads = {"pthread_",
                                                       "sem_",
                                                       "thrd_",
                                                       "mtx_",
                                                       "cnd_",
                                                       "_ZNSt6thread",
                                                       "_ZNSt18condition_variable",
                                                       "_ZNSt3_V222condition_variable_any",
                                                       "_ZNSt28__atomic_futex",
                                                       "syscall",
                                                       "GOMP_",
                                                       "_ZN3tbb",
                                                       "sched_yield",
                                                       "OSSpawn"};

/// The first name that begins with one of `starts`; "" when none does.
template <std::size_t count>
std::string first_of(const DynamicNames& names, const std::array<std::string_view, count>& starts) {
  for (const std::string_view name : names.wanted) {
    const auto begins = [name](std::string_view start) { return name.starts_with(start); };
    if (std::ranges::any_of(starts, begins)) return std::string(name);
  }
  return "";
}

void check_calls(const fs::path& program, const DynamicNames& names) {
  if (const std::string name = first_of(names, kOnceForAll); !name.empty()) {
    refuse(program, "found " + name + "(), which several robots cannot call in one process");
  }
  if (const std::string name = first_of(names, kThreads); !name.empty()) {
    refuse(program, "found a program with threads (it asks the system for " + name +
                        "), which several robots cannot have in one process");
  }
}

bool is_loaded(const std::string& library) {
  void* const handle = dlopen(library.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  if (handle != nullptr) dlclose(handle);
  return handle != nullptr;
}

/// The system's libraries keep nothing for a program, or guard it.
bool is_systems(const fs::path& folder) {
  std::error_code ignored;  // a folder that is not there holds no library
  const std::string real = fs::weakly_canonical(folder, ignored).string();
  return real.starts_with("/usr/") || real.starts_with("/lib");
}

/// Where the dynamic linker looks first: ld.so(8).
std::vector<fs::path> first_folders(const fs::path& program, std::string_view list) {
  std::vector<fs::path> folders;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(':'), list.size());
    std::string folder(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
    for (const std::string_view origin : {"$ORIGIN", "${ORIGIN}"}) {
      const std::size_t place = folder.find(origin);
      if (place == std::string::npos) continue;
      folder.replace(place, origin.size(), fs::absolute(program).parent_path().string());
    }
    folders.emplace_back(folder);
  }
  return folders;
}

/// The first library that is neither the system's nor in use already, as ours are.
std::string own_library(const fs::path& program, const DynamicNames& names) {
  const char* const path = std::getenv("LD_LIBRARY_PATH");
  std::vector<fs::path> folders = first_folders(program, names.folders);
  std::ranges::copy(first_folders(program, path != nullptr ? path : ""),
                    std::back_inserter(folders));
  std::erase_if(folders, is_systems);
  for (const std::string_view name : names.libraries) {
    std::string library(name);
    if (is_loaded(library)) continue;
    const bool has_folder = library.find('/') != std::string::npos;
    std::error_code ignored;  // a folder that may not be searched holds nothing for us
    const auto is_here = [&](const fs::path& folder) {
      return fs::exists(folder / library, ignored);
    };
    if (has_folder ? !is_systems(library) : std::ranges::any_of(folders, is_here)) return library;
  }
  return "";
}

void prepare(const fs::path& program, ProgramFile& file) {
  Bytes& bytes = file.bytes;
  const auto names = dynamic_names(bytes);
  if (names && is_of_other_generation(*names)) {
    refuse(program,
           "found a program for another generation of RoBIOS than the first robot's; expected all "
           "programs of a world to be of one");
  }
  const auto* header = at<ElfW(Ehdr)>(bytes, 0);
  if (header == nullptr || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0) {
    refuse(program,
           std::string("found a file that is no program, as several robots need one") + kExpected);
  }
  if (header->e_ident[EI_CLASS] != ELFCLASS64 || header->e_machine != kMachine.elf) {
    refuse(program, "found a program for another kind of machine, expected one for " +
                        std::string(kMachine.name));
  }
  if (header->e_type != ET_DYN) {
    refuse(program, std::string("found a program for a fixed address") + kExpected);
  }
  auto* segments = at<ElfW(Phdr)>(bytes, header->e_phoff, header->e_phnum);
  if (segments == nullptr) refuse(program, "the program's file is cut off");
  for (std::size_t i = 0; i < header->e_phnum; ++i) {
    if (segments[i].p_type == PT_TLS) {
      refuse(program,
             "found a program with thread_local variables, which several robots cannot have; "
             "expected global or static ones: each robot has its own");
    }
    // The addresses of variables stay writable: ProgramVariables changes them.
    if (segments[i].p_type == PT_GNU_RELRO) segments[i].p_type = PT_NULL;
    if (segments[i].p_type != PT_DYNAMIC) continue;
    const std::size_t count = segments[i].p_filesz / sizeof(ElfW(Dyn));
    auto* entries = at<ElfW(Dyn)>(bytes, segments[i].p_offset, count);
    if (entries == nullptr) refuse(program, "the program's file is cut off");
    for (std::size_t k = 0; k < count && entries[k].d_tag != DT_NULL; ++k) {
      change(entries[k], file);
    }
  }
  if (!names) refuse(program, std::string("found a static program") + kExpected);
  check_calls(program, *names);
  file.own_library = own_library(program, *names);
}

}  // namespace

const ProgramFile& ProgramFile::of(const fs::path& program) {
  static std::mutex mutex;
  static auto* const known = new std::map<fs::path, ProgramFile>;
  const std::lock_guard lock(mutex);
  const auto found = known->find(program);
  if (found != known->end()) return found->second;
  auto bytes = read_file(program, kLargestProgram);
  if (!bytes) refuse(program, bytes.error().what);
  ProgramFile file;
  file.bytes.assign(bytes->begin(), bytes->end());
  prepare(program, file);
  return known->emplace(program, std::move(file)).first->second;
}

}  // namespace eyebridge::robios
