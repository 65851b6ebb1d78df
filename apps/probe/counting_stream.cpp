#include "counting_stream.hpp"

#include <algorithm>

namespace eyebridge::apps {
namespace {

class CountingStream final : public bridges::ByteStream {
 public:
  CountingStream(std::unique_ptr<bridges::ByteStream> inner, LineCounts& counts)
      : inner_(std::move(inner)), counts_(counts) {}

  Result<std::size_t> read_some(std::span<std::uint8_t> buffer, Time deadline) override {
    auto count = inner_->read_some(buffer, deadline);
    if (count) note(buffer.first(*count));
    return count;
  }
  Result<void> write_all(std::span<const std::uint8_t> bytes, Time deadline) override {
    counts_.sent += bytes.size();
    ++counts_.writes;
    return inner_->write_all(bytes, deadline);
  }
  void close() override { inner_->close(); }
  [[nodiscard]] std::string_view name() const override { return inner_->name(); }

 private:
  void note(std::span<const std::uint8_t> bytes) {
    counts_.received += bytes.size();
    const std::size_t room = LineCounts::kFirst - counts_.first.size();
    counts_.first.append(reinterpret_cast<const char*>(bytes.data()), std::min(bytes.size(), room));
  }

  std::unique_ptr<bridges::ByteStream> inner_;
  LineCounts& counts_;
};

}  // namespace

std::unique_ptr<bridges::ByteStream> make_counting(std::unique_ptr<bridges::ByteStream> inner,
                                                   LineCounts& counts) {
  return std::make_unique<CountingStream>(std::move(inner), counts);
}

}  // namespace eyebridge::apps
