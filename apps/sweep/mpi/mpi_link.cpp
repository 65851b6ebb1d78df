// libeyebridge_mpi.so: ranks by MPI. A library of its own, so that nobody else needs MPI.

#include <stdexcept>

#include <mpi.h>

#include "sweep/rank_link.hpp"

namespace eyebridge::apps {
namespace {

constexpr int kTag = 0;

void check(int code, const char* what) {
  if (code != MPI_SUCCESS) throw std::runtime_error(std::string("MPI: ") + what + " failed");
}

class MpiLink final : public RankLink {
 public:
  MpiLink() {
    check(MPI_Init(nullptr, nullptr), "starting");
    check(MPI_Comm_rank(MPI_COMM_WORLD, &rank_), "asking for the rank");
    check(MPI_Comm_size(MPI_COMM_WORLD, &size_), "asking for the size");
  }
  ~MpiLink() override { MPI_Finalize(); }

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }

  void send(int to, const std::string& text) override {
    check(MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, kTag, MPI_COMM_WORLD),
          "sending");
  }

  std::optional<std::pair<int, std::string>> receive() override {
    int there = 0;
    MPI_Status status;
    check(MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &there, &status), "looking");
    if (there == 0) return std::nullopt;
    int length = 0;
    check(MPI_Get_count(&status, MPI_CHAR, &length), "counting");
    std::string text(static_cast<std::size_t>(length), '\0');
    check(MPI_Recv(text.data(), length, MPI_CHAR, status.MPI_SOURCE, kTag, MPI_COMM_WORLD, &status),
          "receiving");
    return std::pair(status.MPI_SOURCE, std::move(text));
  }

 private:
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace
}  // namespace eyebridge::apps

extern "C" __attribute__((visibility("default"))) eyebridge::apps::RankLink*
eyebridge_open_rank_link() {
  return new eyebridge::apps::MpiLink;
}
