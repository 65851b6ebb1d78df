#include "dynamic_names.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include <elf.h>
#include <link.h>

namespace eyebridge::robios {
namespace {

/// A file, by its offsets and by the addresses at which it is loaded.
class Image {
 public:
  explicit Image(std::span<const char> file) : file_(file) {
    const auto header = read<ElfW(Ehdr)>(0);
    for (unsigned i = 0; i < header.e_phnum; ++i) {
      segments_.push_back(read<ElfW(Phdr)>(header.e_phoff, i));
    }
  }

  /// Value number `index` from `offset` on; all zeros outside of the file.
  template <class Value>
  [[nodiscard]] Value read(std::uint64_t offset, std::uint64_t index = 0) const {
    Value value{};
    if (offset > file_.size() || index > (file_.size() - offset) / sizeof value) return value;
    const std::uint64_t start = offset + index * sizeof value;
    if (sizeof value > file_.size() - start) return value;
    std::memcpy(&value, file_.data() + start, sizeof value);
    return value;
  }
  [[nodiscard]] std::span<const ElfW(Phdr)> segments() const { return segments_; }
  /// Where in the file `address` is; its end when nowhere.
  [[nodiscard]] std::uint64_t offset_of(std::uint64_t address) const {
    for (const ElfW(Phdr) & segment : segments_) {
      if (segment.p_type != PT_LOAD || address < segment.p_vaddr ||
          address - segment.p_vaddr >= segment.p_filesz) {
        continue;
      }
      return std::min<std::uint64_t>(address - segment.p_vaddr + segment.p_offset, file_.size());
    }
    return file_.size();
  }
  [[nodiscard]] std::string_view text(std::uint64_t address) const {
    const std::span<const char> rest = file_.subspan(offset_of(address));
    return {rest.data(), strnlen(rest.data(), rest.size())};
  }
  [[nodiscard]] std::size_t size() const { return file_.size(); }

 private:
  std::span<const char> file_;
  std::vector<ElfW(Phdr)> segments_;
};

/// The tables that the dynamic section names.
struct Tables {
  std::uint64_t names = 0;
  std::uint64_t symbols = 0;
  std::uint64_t hash = 0;
  std::uint64_t gnu_hash = 0;
  std::vector<std::uint64_t> libraries;  ///< Places in `names`, as these two.
  std::optional<std::uint64_t> rpath;
  std::optional<std::uint64_t> runpath;

  void take(const ElfW(Dyn) & entry) {
    switch (entry.d_tag) {
      case DT_STRTAB:
        names = entry.d_un.d_ptr;
        break;
      case DT_SYMTAB:
        symbols = entry.d_un.d_ptr;
        break;
      case DT_HASH:
        hash = entry.d_un.d_ptr;
        break;
      case DT_GNU_HASH:
        gnu_hash = entry.d_un.d_ptr;
        break;
      case DT_NEEDED:
        libraries.push_back(entry.d_un.d_val);
        break;
      case DT_RPATH:
        rpath = entry.d_un.d_val;
        break;
      case DT_RUNPATH:
        runpath = entry.d_un.d_val;
        break;
      default:
        break;
    }
  }
};

/// How many symbols there are: no table says so, but a hash table has them all.
std::uint64_t symbol_count(const Image& image, const Tables& tables) {
  if (tables.gnu_hash == 0) {
    return tables.hash != 0 ? image.read<std::uint32_t>(image.offset_of(tables.hash), 1) : 0;
  }
  // Buckets hold the first symbol of a chain each, whose last one has an odd hash.
  const std::uint64_t table = image.offset_of(tables.gnu_hash);
  const auto bucket_count = image.read<std::uint32_t>(table, 0);
  const auto first = image.read<std::uint32_t>(table, 1);
  const auto filter_words = image.read<std::uint32_t>(table, 2);
  const std::uint64_t buckets = table + 16 + filter_words * sizeof(ElfW(Addr));
  std::uint64_t last = 0;
  for (std::uint64_t i = 0; i < bucket_count && buckets + 4 * i < image.size(); ++i) {
    last = std::max<std::uint64_t>(last, image.read<std::uint32_t>(buckets, i));
  }
  if (last < first) return first;  // all are wanted
  const std::uint64_t chains = buckets + 4ULL * bucket_count;
  while (chains + 4 * (last - first) < image.size() &&
         image.read<std::uint32_t>(chains, last - first) % 2 == 0) {
    ++last;
  }
  return last + 1;
}

}  // namespace

std::optional<DynamicNames> dynamic_names(std::span<const char> file) {
  const Image image(file);
  const auto header = image.read<ElfW(Ehdr)>(0);
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_ident[EI_CLASS] != ELFCLASS64) {
    return std::nullopt;
  }
  Tables tables;
  bool is_dynamic = false;
  for (const ElfW(Phdr) & segment : image.segments()) {
    if (segment.p_type != PT_DYNAMIC || is_dynamic) continue;
    is_dynamic = true;
    for (std::uint64_t i = 0; i < segment.p_filesz / sizeof(ElfW(Dyn)); ++i) {
      const auto entry = image.read<ElfW(Dyn)>(segment.p_offset, i);
      if (entry.d_tag == DT_NULL) break;
      tables.take(entry);
    }
  }
  if (!is_dynamic) return std::nullopt;

  DynamicNames out;
  for (const std::uint64_t name : tables.libraries) {
    out.libraries.push_back(image.text(tables.names + name));
  }
  if (const auto list = tables.runpath ? tables.runpath : tables.rpath) {
    out.folders = image.text(tables.names + *list);
  }
  const std::uint64_t symbols = image.offset_of(tables.symbols);
  const std::uint64_t most = (image.size() - symbols) / sizeof(ElfW(Sym));
  const std::uint64_t count = std::min(symbol_count(image, tables), most);
  for (std::uint64_t i = 1; i < count; ++i) {
    const auto symbol = image.read<ElfW(Sym)>(symbols, i);
    if (symbol.st_shndx == SHN_UNDEF)
      out.wanted.push_back(image.text(tables.names + symbol.st_name));
  }
  return out;
}

}  // namespace eyebridge::robios
