#include "hand/open_hand.hpp"

#include <utility>

#include <fmt/format.h>

#include "config/mix_text.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/base/url.hpp"
#include "eyebridge/camera/source.hpp"
#include "eyebridge/hal/hand.hpp"
#include "hand/display.hpp"
#include "hand/hand_backend.hpp"
#include "hand/hand_text.hpp"
#include "hand/shown_drive.hpp"

namespace eyebridge::hal {
namespace {

HandSetting hand_of(const Config& config) { return from_setting(config, "drive", parse_hand); }

std::vector<camera::Fiducial> fiducials_of(Backend& backend, const HandSetting& setting) {
  const auto scene = backend.camera_view()->scene();
  return camera::place_fiducials(*scene.model, setting.layout);
}

void check_mix(const Config& config) {
  for (const MixEntry& entry : parse_mix(config.text("mix"), {})) {
    if (entry.device != "drive" && entry.device != "motor" && entry.device != "encoder") continue;
    throw ConfigError(
        {}, fmt::format("found a person and a {} under mix, expected one to drive", entry.device));
  }
}

/// Fits `found` and `expected` into one message.
[[noreturn]] void refuse(std::string_view found, std::string_view expected) {
  throw ConfigError({}, fmt::format("found {}, expected {}", found, expected));
}

/// Of the pictures that the source gives. With a calibration they are without distortion.
camera::Calibration lens_of(const BackendContext& context, const HandSetting& setting,
                            camera::Size size, double field_of_view_of_model) {
  const Config& config = context.config;
  const Url url = parse_url(config.text("camera"), config.value("camera").where);
  if (const auto file = url.options.find("calibration"); file != url.options.end()) {
    camera::Calibration lens = camera::read_calibration(file->second);
    lens.distortion = {};
    return lens;
  }
  if (setting.field_of_view) return camera::pinhole(size, *setting.field_of_view);
  context.log.write(
      Severity::Warning,
      fmt::format("the camera is not calibrated: its angle of view is taken to be {:.0f} degrees, "
                  "as the robot's; places are as wrong as that is (eyebridge camera calibrate)",
                  rad_to_deg(field_of_view_of_model)));
  return camera::pinhole(size, field_of_view_of_model);
}

std::unique_ptr<InstructionSink> make_display(const BackendContext& context) {
  const Config& config = context.config;
  return std::make_unique<HandDisplay>(
      config.is_set("out") ? config.path("out") : std::filesystem::path{}, standard_error(),
      context.log);
}

}  // namespace

void check_drive(const Config& config) {
  if (!config.is_set("drive") || hand_of(config).is_free) return;
  from_setting(config, "drive", [&](const std::string&) {
    const std::string hal = config.text("hal");
    if (hal != "sim") {
      refuse("a person to drive " + in_quotes(hal), "a simulated robot: --hal sim");
    }
    if (!config.is_set("world")) {
      refuse("no world", "--world with the maze that you walk in: its markers' places are from it");
    }
    check_mix(config);
  });
  from_setting(config, "camera", [](const std::string& url) {
    const std::string scheme = url.substr(0, url.find_first_of(":?"));
    if (scheme != "render" && scheme != "none") return;
    refuse(in_quotes(url) + " with --drive hand",
           "a camera that sees the real maze: v4l2:/dev/video0 or frames:FILE");
  });
}

void check_camera(const Config& config, Backend* backend, LogSink& log) {
  const ConfigValue& camera = config.value("camera");
  camera::View* const view = backend == nullptr ? nullptr : backend->camera_view();
  if (camera.text == "none" || (camera.is_default() && view == nullptr)) return;
  from_setting(config, "camera", [&](const std::string& url) {
    camera::check_source(url, {backend == nullptr ? nullptr : &backend->clock(), view, &log});
  });
}

void check_hand(const BackendContext& context, Backend& backend) {
  const Config& config = context.config;
  if (!config.is_set("drive")) return;
  check_drive(config);
  const HandSetting setting = hand_of(config);
  if (!setting.is_free) {
    from_setting(config, "camera", [&](const std::string& url) {
      camera::check_source(url, {&backend.clock(), nullptr, &context.log});
    });
  }
  from_setting(config, "drive", [&](const std::string&) {
    if (setting.is_free) {
      if (backend.drive() == nullptr) refuse("a robot without a drive", "one that moves");
      return;
    }
    if (backend.camera_view() == nullptr) {
      refuse("a robot without a camera", "one with: its camera is the one in your hand");
    }
    if (fiducials_of(backend, setting).empty()) {
      refuse(fmt::format("no wall in {} that a marker fits on", config.text("world")),
             "walls to put markers up on (without markers: hand:free)");
    }
  });
}

std::unique_ptr<Backend> with_hand(std::unique_ptr<Backend> backend,
                                   const BackendContext& context) {
  const Config& config = context.config;
  if (!config.is_set("drive")) return backend;
  check_hand(context, *backend);
  const HandSetting setting = hand_of(config);
  if (setting.is_free) return with_shown_drive(std::move(backend), make_display(context));
  HandParts parts;
  parts.camera = from_setting(config, "camera", [&](const std::string& url) {
    return camera::open_source(url, {&backend->clock(), nullptr, &context.log});
  });
  const double field_of_view = backend->camera_view()->eye().horizontal_field_of_view;
  const camera::Calibration lens =
      lens_of(context, setting, parts.camera->natural_size(), field_of_view);
  parts.finder = camera::make_fiducial_finder(fiducials_of(*backend, setting), lens, context.log,
                                              config.text("world"));
  parts.display = make_display(context);
  return make_hand(std::move(backend), std::move(parts));
}

}  // namespace eyebridge::hal
