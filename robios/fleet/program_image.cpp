#include "program_image.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <map>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include "exit_handlers.hpp"
#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::robios {
namespace {

[[noreturn]] void refuse_image(const std::filesystem::path& program, const std::string& why) {
  throw ConfigError({program.string()}, why);
}

UniqueFd in_memory(const std::filesystem::path& program, const std::vector<char>& file) {
  UniqueFd copy(memfd_create(program.filename().c_str(), MFD_CLOEXEC));
  std::size_t written = 0;
  while (copy.valid() && written < file.size()) {
    const ssize_t n = write(copy.get(), file.data() + written, file.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    written += static_cast<std::size_t>(n);
  }
  if (written < file.size()) {
    refuse_image(program, std::string("cannot be copied: ") + std::strerror(errno));
  }
  return copy;
}

constexpr const char* kImages = "/proc/self/";  // how all their names begin

/// A name under which the dynamic linker has not seen a file yet: it knows them by name, and a
/// descriptor's number comes again.
std::string fresh_name(int descriptor) {
  static std::atomic<std::uint64_t> next = 0;
  std::string name = kImages;
  for (std::uint64_t n = next++; n != 0; n /= 2) name += n % 2 != 0 ? "./" : "fd/../";
  return name + "fd/" + std::to_string(descriptor);
}

}  // namespace

std::unique_ptr<ProgramImage> ProgramImage::load(const std::filesystem::path& program) {
  const ProgramFile& file = ProgramFile::of(program);
  if (!file.own_library.empty()) {
    refuse_image(program, "found a program with a library of its own, " + file.own_library +
                              ", which all robots would share");
  }
  return load(program, file);
}

std::unique_ptr<ProgramImage> ProgramImage::load(const std::filesystem::path& program,
                                                 const ProgramFile& file) {
  const UniqueFd memory = in_memory(program, file.bytes);
  std::unique_ptr<ProgramImage> image(new ProgramImage(program, file.ends));
  image->handle_ = dlopen(fresh_name(memory.get()).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (image->handle_ == nullptr) {
    refuse_image(program, std::string("cannot be loaded for a robot: ") + dlerror());
  }
  image->main_ = reinterpret_cast<Main>(dlsym(image->handle_, "main"));
  if (image->main_ == nullptr || dlinfo(image->handle_, RTLD_DI_LINKMAP, &image->map_) != 0) {
    refuse_image(program,
                 "found a program that hides its main(); expected one built with eyebridge-cc or "
                 "eyebridge-c++, without -no-pie and -static");
  }
  image->variables_ = ProgramVariables(*image->map_);
  image->start(file.starts);
  return image;
}

std::shared_ptr<ProgramImage> ProgramImage::load_shared(const std::filesystem::path& program) {
  static std::mutex mutex;
  static auto* const known = new std::map<std::filesystem::path, std::shared_ptr<ProgramImage>>;
  const std::lock_guard lock(mutex);
  std::shared_ptr<ProgramImage>& image = (*known)[program];
  // Who comes when the others have ended finds its objects destroyed.
  if (image == nullptr || !image->share()) image = load(program, ProgramFile::of(program));
  return image;
}

bool ProgramImage::share() {
  std::size_t users = users_;
  while (users > 0 && !users_.compare_exchange_weak(users, users + 1)) {
  }
  return users > 0;
}

const link_map* ProgramImage::around(const void* address) {
  Dl_info info{};
  link_map* map = nullptr;
  if (dladdr1(address, &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) == 0) return nullptr;
  return map != nullptr && std::string_view(map->l_name).starts_with(kImages) ? map : nullptr;
}

void ProgramImage::start(const ProgramFile::Functions& starts) {
  if (starts.other != 0) reinterpret_cast<void (*)()>(map_->l_addr + starts.other)();
  // glibc gives constructors what it gives main().
  const auto* functions = reinterpret_cast<const Main*>(map_->l_addr + starts.array);
  for (std::size_t i = 0; i < starts.count; ++i) functions[i](1, words_.data(), environ);
}

void ProgramImage::finish(bool is_quick, int status) {
  ExitHandlers::run(*map_, is_quick, status);
  if (is_quick) return;
  using Function = void (*)();
  const auto* functions = reinterpret_cast<const Function*>(map_->l_addr + ends_.array);
  while (ends_.count > 0) functions[--ends_.count]();
  if (const std::uint64_t last = std::exchange(ends_.other, 0); last != 0) {
    reinterpret_cast<Function>(map_->l_addr + last)();
  }
}

}  // namespace eyebridge::robios
