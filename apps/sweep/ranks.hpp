#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sweep/outcome.hpp"
#include "sweep/plan.hpp"
#include "sweep/rank_link.hpp"
#include "sweep/run_cells.hpp"

namespace eyebridge::apps {

// One sweep on several ranks: rank 0 hands out cells one at a time and gets outcomes, all others
// run them. All ranks know the cells; that they are the same ones is checked.

/// Rank 0: waits until every rank has said that it is ready. `problem` is what is wrong here, ""
/// for nothing. Throws ConfigError for a problem here or elsewhere, after sending all others home.
void greet_ranks(RankLink& link, const std::vector<Cell>& cells, const std::string& problem);

/// Rank 0, once they are ready: as run_cells(), by the other ranks; sends them home at the end.
bool run_on_ranks(RankLink& link, std::span<const std::size_t> todo,
                  const std::function<void(std::size_t, const Outcome&)>& ended,
                  const std::function<bool()>& stop);

/// Any other rank: runs what it is told until it is sent home. `problem` as above.
void serve_rank(RankLink& link, const std::vector<Cell>& cells, const RunSettings& settings,
                const std::string& problem);

}  // namespace eyebridge::apps
