#include "error_parameters.hpp"

#include <array>

#include "eyebridge/base/units.hpp"

namespace eyebridge::files {
namespace {

using robot::ErrorModels;
using robot::kErrorPart;

constexpr double kPercent = 100;
constexpr double kMilli = 1000;
constexpr double kLongestMm = 1e5;
constexpr double kLongestMs = 3'600'000;  // an hour

constexpr auto kPsd = std::to_array<ErrorParameter>({
    {"sigma", "mm", 0, kLongestMm, kMilli, [](ErrorModels& m, double v) { m.range.sigma = v; }},
    {"relative", "%", 0, 100, kPercent,
     [](ErrorModels& m, double v) { m.range.sigma_relative = v; }},
    {"bias", "mm", -kLongestMm, kLongestMm, kMilli,
     [](ErrorModels& m, double v) { m.range.bias = v; }},
    {"dropout", "%", 0, 100, kPercent, [](ErrorModels& m, double v) { m.range.dropout = v; }},
    {"quantised", "flag", 0, 1, 1, [](ErrorModels& m, double v) { m.range.quantised = v > 0; }},
    {"crosstalk", "%", 0, 100, kPercent, [](ErrorModels& m, double v) { m.range.cross_talk = v; }},
    {"quadratic", "mm", 0, kLongestMm, kMilli,
     [](ErrorModels& m, double v) { m.range.sigma_quadratic = v; }},
});

constexpr auto kDrive = std::to_array<ErrorParameter>({
    {"linear", "%", 0, 100, kPercent, [](ErrorModels& m, double v) { m.drive.linear_sigma = v; }},
    {"angular", "%", 0, 100, kPercent, [](ErrorModels& m, double v) { m.drive.angular_sigma = v; }},
    {"slip", "%", 0, 100, kPercent, [](ErrorModels& m, double v) { m.drive.slip = v; }},
});

constexpr auto kWheels = std::to_array<ErrorParameter>({
    {"left", "%", -50, 50, kPercent, [](ErrorModels& m, double v) { m.drive.left_scale = v; }},
    {"right", "%", -50, 50, kPercent, [](ErrorModels& m, double v) { m.drive.right_scale = v; }},
});

constexpr auto kEncoder = std::to_array<ErrorParameter>({
    {"quantised", "flag", 0, 1, 1,
     [](ErrorModels& m, double v) { m.drive.encoder_quantised = v > 0; }},
    {"miss", "%", 0, 100, kPercent, [](ErrorModels& m, double v) { m.drive.encoder_miss = v; }},
});

constexpr auto kCompass = std::to_array<ErrorParameter>({
    {"sigma", "deg", 0, 180, 1, [](ErrorModels& m, double v) { m.compass.sigma = deg_to_rad(v); }},
    {"bias", "deg", -180, 180, 1, [](ErrorModels& m, double v) { m.compass.bias = deg_to_rad(v); }},
});

constexpr auto kCamera = std::to_array<ErrorParameter>({
    {"salt", "%", 0, 100, kPercent, [](ErrorModels& m, double v) { m.camera.salt_and_pepper = v; }},
    {"sigma", "", 0, 255, 1, [](ErrorModels& m, double v) { m.camera.sigma = v; }},
    {"coloured", "%", 0, 100, kPercent, [](ErrorModels& m, double v) { m.camera.coloured = v; }},
    {"blur", "px", 0, 50, 1, [](ErrorModels& m, double v) { m.camera.blur = v; }},
    {"exposure", "stops", -8, 8, 1, [](ErrorModels& m, double v) { m.camera.exposure = v; }},
    {"flicker", "stops", 0, 8, 1, [](ErrorModels& m, double v) { m.camera.exposure_sigma = v; }},
});

constexpr auto kIr = std::to_array<ErrorParameter>({
    {"flip", "%", 0, 100, kPercent, [](ErrorModels& m, double v) { m.proximity.flip = v; }},
});

constexpr auto kBump = std::to_array<ErrorParameter>({
    {"miss", "%", 0, 100, kPercent, [](ErrorModels& m, double v) { m.bumper.miss = v; }},
});

constexpr auto kLidar = std::to_array<ErrorParameter>({
    {"sigma", "mm", 0, kLongestMm, kMilli, [](ErrorModels& m, double v) { m.lidar.sigma = v; }},
    {"relative", "%", 0, 100, kPercent,
     [](ErrorModels& m, double v) { m.lidar.sigma_relative = v; }},
    {"bias", "mm", -kLongestMm, kLongestMm, kMilli,
     [](ErrorModels& m, double v) { m.lidar.bias = v; }},
    {"dropout", "%", 0, 100, kPercent, [](ErrorModels& m, double v) { m.lidar.dropout = v; }},
});

constexpr auto kTof = std::to_array<ErrorParameter>({
    {"sigma", "mm", 0, kLongestMm, kMilli,
     [](ErrorModels& m, double v) { m.range_matrix.sigma = v; }},
    {"relative", "%", 0, 100, kPercent,
     [](ErrorModels& m, double v) { m.range_matrix.sigma_relative = v; }},
    {"bias", "mm", -kLongestMm, kLongestMm, kMilli,
     [](ErrorModels& m, double v) { m.range_matrix.bias = v; }},
    {"dropout", "%", 0, 100, kPercent,
     [](ErrorModels& m, double v) { m.range_matrix.dropout = v; }},
});

constexpr auto kRadio = std::to_array<ErrorParameter>({
    {"loss", "%", 0, 100, kPercent, [](ErrorModels& m, double v) { m.radio.loss = v; }},
    {"delay", "ms", 0, kLongestMs, kMilli, [](ErrorModels& m, double v) { m.radio.delay = v; }},
    {"jitter", "ms", 0, kLongestMs, kMilli, [](ErrorModels& m, double v) { m.radio.jitter = v; }},
    {"corrupt", "%", 0, 100, kPercent, [](ErrorModels& m, double v) { m.radio.corrupt = v; }},
    {"range", "m", 0, 1e6, 1, [](ErrorModels& m, double v) { m.radio.range = v; }},
});

constexpr auto kGyroscope = std::to_array<ErrorParameter>({
    {"sigma", "deg/s", 0, 1e5, 1,
     [](ErrorModels& m, double v) { m.gyroscope.sigma = deg_to_rad(v); }},
    {"drift", "deg/s", 0, 1e5, 1,
     [](ErrorModels& m, double v) { m.gyroscope.drift = deg_to_rad(v); }},
    {"bias", "deg/s", -1e5, 1e5, 1,
     [](ErrorModels& m, double v) { m.gyroscope.bias = deg_to_rad(v); }},
    {"relative", "%", 0, 100, kPercent,
     [](ErrorModels& m, double v) { m.gyroscope.sigma_relative = v; }},
});

constexpr auto kAccelerometer = std::to_array<ErrorParameter>({
    {"sigma", "m/s2", 0, 1e4, 1, [](ErrorModels& m, double v) { m.accelerometer.sigma = v; }},
    {"bias", "m/s2", -1e4, 1e4, 1, [](ErrorModels& m, double v) { m.accelerometer.bias = v; }},
    {"relative", "%", 0, 100, kPercent,
     [](ErrorModels& m, double v) { m.accelerometer.sigma_relative = v; }},
});

constexpr auto kKinds = std::to_array<ErrorKind>({
    {"psd", kErrorPart<robot::RangeError>, true, 2, kPsd},
    {"drive", kErrorPart<robot::DriveError>, false, 2, kDrive},
    {"wheels", kErrorPart<robot::DriveError>, false, 2, kWheels},
    {"encoder", kErrorPart<robot::DriveError>, false, 0, kEncoder},
    {"compass", kErrorPart<robot::CompassError>, false, 1, kCompass},
    {"camera", kErrorPart<robot::CameraError>, false, 2, kCamera},
    {"ir", kErrorPart<robot::ProximityError>, true, 1, kIr},
    {"bump", kErrorPart<robot::BumperError>, true, 1, kBump},
    {"lidar", kErrorPart<robot::LidarError>, false, 2, kLidar},
    {"tof", kErrorPart<robot::RangeMatrixError>, true, 2, kTof},
    {"radio", kErrorPart<robot::RadioError>, false, 2, kRadio},
    {"gyroscope", kErrorPart<robot::GyroscopeError>, false, 2, kGyroscope},
    {"accelerometer", kErrorPart<robot::AccelerometerError>, false, 1, kAccelerometer},
});

}  // namespace

std::span<const ErrorKind> error_kinds() { return kKinds; }

}  // namespace eyebridge::files
