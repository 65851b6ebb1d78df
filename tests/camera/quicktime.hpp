#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "picture_files.hpp"

namespace eyebridge::camera::testing {

/// A QuickTime film of JPEGs as a phone or an editor makes them (Apple, QuickTime File Format):
/// every frame with a duration of its own, pixels that need not be square, and a beginning that is
/// not shown.
struct Film {
  struct Shot {
    Bytes jpeg;
    std::uint32_t milliseconds = 40;
  };
  std::vector<Shot> shots;
  std::uint16_t width = 0;
  std::uint16_t height = 0;
  std::uint32_t pixel_width = 1;   ///< Of a pixel's shape, by
  std::uint32_t pixel_height = 1;  ///< this.
  std::uint32_t begins_at = 0;     ///< Milliseconds that are not shown.

  [[nodiscard]] Bytes file() const;
};

/// Big-endian numbers, and boxes of them.
class BoxWriter {
 public:
  BoxWriter& u32(std::uint64_t value) { return number(value, 4); }
  BoxWriter& u16(std::uint64_t value) { return number(value, 2); }
  BoxWriter& zeros(std::size_t count) {
    bytes_.resize(bytes_.size() + count);
    return *this;
  }
  BoxWriter& text(const std::string& text) {
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    return *this;
  }
  BoxWriter& bytes(const Bytes& bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return *this;
  }
  BoxWriter& box(const std::string& name, const BoxWriter& inside) {
    return u32(8 + inside.bytes_.size()).text(name).bytes(inside.bytes_);
  }
  [[nodiscard]] const Bytes& all() const { return bytes_; }

 private:
  BoxWriter& number(std::uint64_t value, int count) {
    for (int i = count - 1; i >= 0; --i) {
      bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i) & 0xFFU));
    }
    return *this;
  }
  Bytes bytes_;
};

inline Bytes Film::file() const {
  constexpr std::uint32_t kScale = 1000;  // units a second
  constexpr std::uint32_t kUnity = 0x10000;
  std::uint32_t duration = 0;
  BoxWriter pictures;
  BoxWriter durations;
  BoxWriter sizes;
  BoxWriter places;
  BoxWriter kind;
  kind.box("ftyp", BoxWriter().text("qt  ").u32(0).text("qt  "));
  const std::size_t first = kind.all().size() + 8;
  for (const Shot& shot : shots) {
    durations.u32(1).u32(shot.milliseconds);
    sizes.u32(shot.jpeg.size());
    places.u32(first + pictures.all().size());
    pictures.bytes(shot.jpeg);
    duration += shot.milliseconds;
  }
  const auto matrix = [&](BoxWriter& to) {
    for (const std::uint32_t v : {kUnity, 0U, 0U, 0U, kUnity, 0U, 0U, 0U, 0x40000000U}) to.u32(v);
  };
  BoxWriter film_header;
  film_header.u32(0).u32(0).u32(0).u32(kScale).u32(duration).u32(kUnity).u16(0x100).zeros(10);
  matrix(film_header);
  film_header.zeros(24).u32(2);
  BoxWriter track_header;
  track_header.u32(7).u32(0).u32(0).u32(1).u32(0).u32(duration).zeros(16);
  matrix(track_header);
  track_header.u32(std::uint32_t{width} << 16U).u32(std::uint32_t{height} << 16U);
  BoxWriter description;
  description.zeros(6).u16(1).u16(0).u16(0).zeros(12).u16(width).u16(height);
  description.u32(72 * kUnity).u32(72 * kUnity).u32(0).u16(1).zeros(32).u16(24).u16(0xFFFF);
  description.box("pasp", BoxWriter().u32(pixel_width).u32(pixel_height));
  const auto count = shots.size();
  BoxWriter table;
  table.box("stsd", BoxWriter().u32(0).u32(1).box("jpeg", description));
  table.box("stts", BoxWriter().u32(0).u32(count).bytes(durations.all()));
  table.box("stsc", BoxWriter().u32(0).u32(1).u32(1).u32(1).u32(1));
  table.box("stsz", BoxWriter().u32(0).u32(0).u32(count).bytes(sizes.all()));
  table.box("stco", BoxWriter().u32(0).u32(count).bytes(places.all()));
  BoxWriter information;
  information.box("vmhd", BoxWriter().u32(1).zeros(8));
  information.box(
      "dinf", BoxWriter().box("dref", BoxWriter().u32(0).u32(1).box("url ", BoxWriter().u32(1))));
  information.box("stbl", table);
  BoxWriter media;
  media.box("mdhd", BoxWriter().u32(0).u32(0).u32(0).u32(kScale).u32(duration).u32(0));
  media.box("hdlr", BoxWriter().u32(0).text("mhlr").text("vide").zeros(13));
  media.box("minf", information);
  BoxWriter track;
  track.box("tkhd", track_header);
  if (begins_at > 0) {
    track.box("edts",
              BoxWriter().box(
                  "elst",
                  BoxWriter().u32(0).u32(1).u32(duration - begins_at).u32(begins_at).u32(kUnity)));
  }
  track.box("mdia", media);
  BoxWriter film;
  film.box("mvhd", film_header).box("trak", track);
  kind.box("mdat", pictures).box("moov", film);
  return kind.all();
}

}  // namespace eyebridge::camera::testing
