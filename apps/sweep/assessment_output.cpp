#include "sweep/assessment_output.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "sweep/plot.hpp"

namespace eyebridge::apps {
namespace {

/// A field of a CSV file.
std::string field(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string line_of(const std::vector<std::string>& fields) {
  std::string out;
  for (const std::string& each : fields) out += field(each) + ",";
  out.back() = '\n';
  return out;
}

std::string number_field(const std::optional<double>& number) {
  return number ? fmt::format("{}", *number) : "";
}

std::optional<double> value_of(const ResultRow& row, const std::string& name) {
  const auto found = row.values.find(name);
  return found == row.values.end() ? std::nullopt : std::optional(found->second);
}

/// Columns of runs.csv that are values of a run: the name in ResultRow::values, the column's.
std::vector<std::pair<std::string, std::string>> value_columns() {
  std::vector<std::pair<std::string, std::string>> out;
  for (const Measure& measure : measures()) out.emplace_back(measure.value, measure.column);
  for (const auto& [name, column] :
       {std::pair{"observed", "observed"}, {"end_x", "end_x_m"}, {"end_y", "end_y_m"}}) {
    out.emplace_back(name, column);
  }
  return out;
}

/// Numbers that the programs said, of all runs.
std::set<std::string> said_numbers(const std::vector<AssessedRun>& runs) {
  // What the computer took is another time each time.
  std::set<std::string> known = {"wall", "cpu", "end_theta"};
  for (const auto& [name, column] : value_columns()) known.insert(name);
  std::set<std::string> out;
  for (const AssessedRun& run : runs) {
    for (const auto& [name, value] : run.row.values) {
      if (!known.contains(name)) out.insert(name);
    }
  }
  return out;
}

}  // namespace

std::string assessment_table(const std::vector<Score>& scores) {
  std::string out;
  for (const Score& each : scores) {
    const Interval interval = wilson_interval(each.successes, each.runs);
    out += fmt::format("{}: {} of {} runs succeed, {:.1f} % ({:.1f} ... {:.1f} %)", each.group,
                       each.successes, each.runs, 100 * each.rate(), 100 * interval.low,
                       100 * interval.high);
    for (const auto& [verdict, count] : each.failures)
      out += fmt::format(", {} {}", count, verdict);
    out += each.all_alike ? "; all runs are the same: the seed changes nothing\n" : "\n";
    if (each.values.empty()) continue;
    out +=
        fmt::format("  {:<16} {:>12} {:>12} {:>12} {:>6}\n", "", "median", "least", "most", "runs");
    for (const Measure& measure : measures()) {
      const auto found = each.values.find(measure.value);
      if (found == each.values.end()) continue;
      const std::vector<double>& numbers = found->second;
      out += fmt::format("  {:<16} {:>12.5g} {:>12.5g} {:>12.5g} {:>6}\n", measure.title,
                         quantile(numbers, 0.5), quantile(numbers, 0), quantile(numbers, 1),
                         numbers.size());
    }
  }
  return out;
}

std::string runs_csv(const std::vector<AssessedRun>& runs) {
  std::vector<std::string> names = {"group", "seed", "success", "verdict", "reason"};
  for (const auto& [name, column] : value_columns()) names.push_back(column);
  names.insert(names.end(), {"goal_distance_m", "state_hash"});
  const std::set<std::string> said = said_numbers(runs);
  names.insert(names.end(), said.begin(), said.end());
  std::string out = line_of(names);
  for (const AssessedRun& run : runs) {
    const auto seed = run.row.coordinates.find("seed");
    std::vector<std::string> fields = {run.group,
                                       seed == run.row.coordinates.end() ? "" : seed->second,
                                       run.success() ? "1" : "0", run.verdict, run.reason};
    for (const auto& [name, column] : value_columns()) {
      fields.push_back(number_field(value_of(run.row, name)));
    }
    fields.push_back(number_field(run.goal_distance));
    fields.push_back(run.row.state_hash);
    for (const std::string& name : said) fields.push_back(number_field(value_of(run.row, name)));
    out += line_of(fields);
  }
  return out;
}

std::string summary_csv(const std::vector<Score>& scores) {
  std::vector<std::string> names = {"group",        "runs",       "successes",
                                    "success_rate", "wilson_low", "wilson_high"};
  for (const Measure& measure : measures()) {
    for (const char* part : {"median", "least", "most", "runs"}) {
      names.push_back(fmt::format("{}_{}", measure.column, part));
    }
  }
  std::string out = line_of(names);
  for (const Score& each : scores) {
    const Interval interval = wilson_interval(each.successes, each.runs);
    std::vector<std::string> fields = {each.group, fmt::format("{}", each.runs),
                                       fmt::format("{}", each.successes)};
    for (const double number : {each.rate(), interval.low, interval.high}) {
      fields.push_back(fmt::format("{}", number));
    }
    for (const Measure& measure : measures()) {
      const auto found = each.values.find(measure.value);
      const bool is_there = found != each.values.end();
      for (const double share : {0.5, 0.0, 1.0}) {
        fields.push_back(is_there ? fmt::format("{}", quantile(found->second, share)) : "");
      }
      fields.push_back(fmt::format("{}", is_there ? found->second.size() : 0));
    }
    out += line_of(fields);
  }
  return out;
}

void plot_assessment(const std::vector<Score>& scores, const std::filesystem::path& folder) {
  std::vector<PlotRow> rates;
  for (const Score& each : scores) {
    const Interval interval = wilson_interval(each.successes, each.runs);
    rates.push_back({each.group, {}, PlotBar{interval.low, each.rate(), interval.high}});
  }
  plot_rows(rates, "rate of success, with its 95 % interval", folder / "success.png",
            std::pair(0.0, 1.0));
  for (const Measure& measure : measures()) {
    const std::filesystem::path file = folder / (std::string(measure.column) + ".png");
    std::vector<PlotRow> rows;
    bool any = false;
    for (const Score& each : scores) {
      PlotRow& row = rows.emplace_back();
      row.label = each.group;
      const auto found = each.values.find(measure.value);
      if (found == each.values.end()) continue;
      any = true;
      row.dots = found->second;
      row.bar =
          PlotBar{quantile(row.dots, 0.25), quantile(row.dots, 0.5), quantile(row.dots, 0.75)};
    }
    if (any) {
      plot_rows(rows, measure.title, file);
    } else {
      std::filesystem::remove(file);  // of an earlier assessment: it is not of these runs
    }
  }
}

}  // namespace eyebridge::apps
