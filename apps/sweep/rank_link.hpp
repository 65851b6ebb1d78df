#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace eyebridge::apps {

/// Messages between the processes of one sweep, which mpirun started: ranks 0 … size() - 1. One
/// thread. A rank that is lost ends all others: that is MPI's way.
class RankLink {
 public:
  virtual ~RankLink() = default;

  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;
  /// Texts from one rank to another arrive in their order.
  virtual void send(int to, const std::string& text) = 0;
  /// The next text for this rank, and who sent it; nothing when none is there. Waits not.
  virtual std::optional<std::pair<int, std::string>> receive() = 0;
};

/// What the library of MPI (`libeyebridge_mpi.so`, loaded only where mpirun started us) offers, by
/// this name: a new link, which the caller deletes.
inline constexpr const char* kOpenRankLink = "eyebridge_open_rank_link";
using OpenRankLink = RankLink* (*)();

/// The link of a process that mpirun started; null in any other. `library` is the file to load.
/// Throws ConfigError when it cannot be loaded: this eyebridge was built without MPI.
std::unique_ptr<RankLink> open_rank_link(const std::string& library);

}  // namespace eyebridge::apps
