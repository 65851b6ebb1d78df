#include <memory>
#include <string>
#include <vector>

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "checks.hpp"
#include "eyebridge/episode/batch.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;
using episode::EpisodeBatch;
using SharedBatch = std::shared_ptr<EpisodeBatch>;
using Marks = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;
using Release = py::call_guard<py::gil_scoped_release>;

episode::Action action_of(const std::string& word) {
  if (word == "speed") return episode::Action::Speed;
  if (word == "wheels") return episode::Action::Wheels;
  refuse("action", word, "speed or wheels");
}

episode::Start start_of(const std::string& word) {
  if (word == "scenario") return episode::Start::Scenario;
  if (word == "anywhere") return episode::Start::Anywhere;
  refuse("start", word, "scenario or anywhere");
}

SharedBatch make_batch(const std::vector<std::shared_ptr<files::Scenario>>& scenarios,
                       std::size_t worlds, const std::string& observation,
                       const std::string& action, const std::string& start, double period,
                       double time_limit, double step, unsigned threads) {
  episode::BatchSettings settings;
  settings.worlds = worlds;
  settings.simulation.step = step;
  settings.period = period;
  settings.time_limit = time_limit;
  settings.observation = observation;
  settings.action = action_of(action);
  settings.start = start_of(start);
  settings.threads = threads;
  const py::gil_scoped_release others_run;
  return std::make_shared<EpisodeBatch>(
      std::vector<std::shared_ptr<const files::Scenario>>(scenarios.begin(), scenarios.end()),
      std::move(settings));
}

void step_batch(EpisodeBatch& batch, const Numbers& actions, const Marks& resets) {
  const std::span<const double> numbers(actions.data(), static_cast<std::size_t>(actions.size()));
  const std::span<const std::uint8_t> marks(resets.data(), static_cast<std::size_t>(resets.size()));
  const py::gil_scoped_release others_run;
  batch.step(numbers, marks);
}

void reset_batch(EpisodeBatch& batch, const Marks& which) {
  const std::span<const std::uint8_t> marks(which.data(), static_cast<std::size_t>(which.size()));
  const py::gil_scoped_release others_run;
  batch.reset(marks);
}

void end_at_collisions(EpisodeBatch& batch, bool end) {
  if (end) {
    batch.set_terminated(nullptr);
  } else {
    batch.set_terminated([](const episode::Episode&) { return false; });
  }
}

/// Views of all rows by name; they follow every call.
py::dict batch_rows(const SharedBatch& batch) {
  const episode::BatchRows& all = batch->rows();
  const auto count = static_cast<py::ssize_t>(batch->settings().worlds);
  const auto width = static_cast<py::ssize_t>(batch->observation_size());
  py::dict out;
  out["observations"] = view_of(all.observations.data(), {count, width}, batch);
  out["rewards"] = view_of(all.rewards.data(), {count}, batch);
  out["terminated"] = view_of(all.terminated.data(), {count}, batch);
  out["truncated"] = view_of(all.truncated.data(), {count}, batch);
  out["poses"] = view_of(all.poses.data(), {count, 3}, batch);
  out["distances"] = view_of(all.distances.data(), {count}, batch);
  out["collisions"] = view_of(all.collisions.data(), {count}, batch);
  out["times"] = view_of(all.times.data(), {count}, batch);
  out["seeds"] = view_of(all.seeds.data(), {count}, batch);
  return out;
}

}  // namespace

void bind_batch(py::module_& module) {
  py::class_<EpisodeBatch, SharedBatch>(module, "EpisodeBatch")
      .def(py::init(&make_batch), py::arg("scenarios"), py::arg("worlds"), py::arg("observation"),
           py::arg("action"), py::arg("start"), py::arg("period"), py::arg("time_limit"),
           py::arg("step"), py::arg("threads"))
      .def("reset_all", &EpisodeBatch::reset_all, py::arg("first"), Release())
      .def("reset", &reset_batch, py::arg("which"))
      .def("step", &step_batch, py::arg("actions"), py::arg("resets"))
      .def("end_at_collisions", &end_at_collisions, py::arg("end"))
      .def("rows", &batch_rows)
      .def_property_readonly("observation_low",
                             [](const EpisodeBatch& b) { return array_of(b.observation_low()); })
      .def_property_readonly("observation_high",
                             [](const EpisodeBatch& b) { return array_of(b.observation_high()); })
      .def_property_readonly("action_high", &EpisodeBatch::action_high);
}

}  // namespace eyebridge::python
