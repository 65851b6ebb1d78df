#include "pictures/jpeg_decoder.hpp"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>
// After it: the codes of its messages.
#include <jerror.h>

#include "pictures/exif.hpp"

namespace eyebridge::camera {
namespace {

// A small file of very many scans takes minutes otherwise.
constexpr int kMostScans = 500;
constexpr int kEighths = 8;
constexpr int kExif = JPEG_APP0 + 1;
constexpr unsigned kLongestMarker = 0xFFFF;

/// libjpeg's decoder, whose errors jump here instead of ending the process. What it lives in holds
/// nothing that a jump would leave behind.
struct Decoder {
  jpeg_decompress_struct info{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf failed{};
  std::array<char, JMSG_LENGTH_MAX> message{};
  bool damaged = false;
  Oddities odd;
};

Decoder& decoder_of(j_common_ptr info) { return *static_cast<Decoder*>(info->client_data); }

void keep_message(j_common_ptr info) {
  info->err->format_message(info, decoder_of(info).message.data());
}

[[noreturn]] void on_error(j_common_ptr info) {
  keep_message(info);
  std::longjmp(decoder_of(info).failed, 1);
}

/// A warning: `level` < 0.
void on_message(j_common_ptr info, int level) {
  if (level >= 0) return;
  Decoder& decoder = decoder_of(info);
  switch (info->err->msg_code) {
    case JWRN_EXTRANEOUS_DATA:
      decoder.odd.stray_bytes = true;
      return;
    case JWRN_JPEG_EOF:  // a picture that ends too early is warned of once more
      decoder.odd.no_end = true;
      return;
    case JWRN_ADOBE_XFORM:
    case JWRN_JFIF_MAJOR:
      return;
    default:
      if (!decoder.damaged) keep_message(info);
      decoder.damaged = true;
  }
}

void on_progress(j_common_ptr info) {
  auto* const decompress = reinterpret_cast<j_decompress_ptr>(info);
  if (decompress->input_scan_number <= kMostScans) return;
  std::snprintf(decoder_of(info).message.data(), JMSG_LENGTH_MAX, "more than %d scans", kMostScans);
  std::longjmp(decoder_of(info).failed, 1);
}

/// Where the picture begins: some cameras send a few bytes before it.
std::span<const std::uint8_t> from_beginning(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 3> kBeginning = {0xFF, 0xD8, 0xFF};
  const auto found = std::search(bytes.begin(), bytes.end(), kBeginning.begin(), kBeginning.end());
  return found == bytes.end() ? bytes
                              : bytes.subspan(static_cast<std::size_t>(found - bytes.begin()));
}

void begin(Decoder& decoder, std::span<const std::uint8_t> bytes) {
  decoder.info.err = jpeg_std_error(&decoder.errors);
  decoder.info.client_data = &decoder;
  decoder.errors.error_exit = on_error;
  decoder.errors.emit_message = on_message;
  decoder.errors.output_message = [](j_common_ptr) {};
  jpeg_create_decompress(&decoder.info);
  decoder.progress.progress_monitor = on_progress;
  decoder.info.progress = &decoder.progress;
  jpeg_save_markers(&decoder.info, kExif, kLongestMarker);
  jpeg_mem_src(&decoder.info, bytes.data(),
               static_cast<unsigned long>(bytes.size()));  // NOLINT(google-runtime-int)
}

/// False: it failed, and the message says why.
bool read_header(Decoder& decoder, std::span<const std::uint8_t> bytes) {
  if (setjmp(decoder.failed) != 0) return false;
  begin(decoder, bytes);
  jpeg_read_header(&decoder.info, TRUE);
  return true;
}

void choose_scale(jpeg_decompress_struct& info, Size least) {
  if (least.width <= 0 || least.height <= 0) return;
  const auto scaled = [](unsigned side, int eighths) {
    return static_cast<int>((side * static_cast<unsigned>(eighths) + kEighths - 1) / kEighths);
  };
  for (int eighths = 1; eighths <= kEighths; ++eighths) {
    info.scale_num = static_cast<unsigned>(eighths);
    info.scale_denom = kEighths;
    if (scaled(info.image_width, eighths) >= least.width &&
        scaled(info.image_height, eighths) >= least.height) {
      return;
    }
  }
}

/// False: it failed.
bool start(Decoder& decoder, const JpegOptions& options) {
  if (setjmp(decoder.failed) != 0) return false;
  jpeg_decompress_struct& info = decoder.info;
  decoder.odd.no_tables = info.dc_huff_tbl_ptrs[0] == nullptr && info.arith_code == FALSE;
  const bool is_cmyk = info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK;
  info.out_color_space = is_cmyk ? JCS_CMYK : JCS_RGB;
  info.dct_method = JDCT_ISLOW;
  info.do_fancy_upsampling = options.is_fast ? FALSE : TRUE;
  choose_scale(info, options.least);
  jpeg_start_decompress(&info);
  return true;
}

/// Adobe's programs write CMYK inverted, and say so in a marker.
void cmyk_to_rgb(const std::uint8_t* in, std::uint8_t* out, int pixels, bool is_inverted) {
  for (int i = 0; i < pixels; ++i, in += 4, out += 3) {
    for (int k = 0; k < 3; ++k) {
      const int ink = is_inverted ? in[k] : 255 - in[k];
      const int black = is_inverted ? in[3] : 255 - in[3];
      out[k] = static_cast<std::uint8_t>((ink * black + 127) / 255);
    }
  }
}

/// False: it failed. `row` has room for a row of the decoder's.
bool read_rows(Decoder& decoder, Frame& frame, std::uint8_t* row) {
  if (setjmp(decoder.failed) != 0) return false;
  jpeg_decompress_struct& info = decoder.info;
  while (info.output_scanline < info.output_height) {
    std::uint8_t* const target =
        frame.bytes.data() +
        static_cast<std::size_t>(info.output_scanline) * static_cast<std::size_t>(frame.stride);
    JSAMPROW rows[1] = {info.out_color_space == JCS_CMYK ? row : target};
    jpeg_read_scanlines(&info, rows, 1);
    if (info.out_color_space == JCS_CMYK) {
      cmyk_to_rgb(row, target, frame.width, info.saw_Adobe_marker != FALSE);
    }
  }
  jpeg_finish_decompress(&info);
  // Cameras fill their buffers up with zeros, which are no oddity.
  const auto* const rest = info.src->next_input_byte;
  decoder.odd.trailing_bytes =
      !decoder.odd.no_end && std::any_of(rest, rest + info.src->bytes_in_buffer,
                                         [](std::uint8_t byte) { return byte != 0; });
  return true;
}

struct Destroy {
  Decoder& decoder;
  explicit Destroy(Decoder& of) : decoder(of) {}
  Destroy(const Destroy&) = delete;
  Destroy& operator=(const Destroy&) = delete;
  ~Destroy() { jpeg_destroy_decompress(&decoder.info); }
};

tl::unexpected<Error> corrupt(const Decoder& decoder) {
  return fail(Errc::Corrupt, std::string("JPEG: ") + decoder.message.data());
}

std::string text_of(Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace

std::string Oddities::text() const {
  std::string out;
  const auto add = [&](bool holds, const char* words) {
    if (holds) out += (out.empty() ? "" : ", ") + std::string(words);
  };
  add(stray_bytes, "with stray bytes");
  add(no_end, "without an end");
  add(no_tables, "without tables");
  add(trailing_bytes, "with bytes after their end");
  return out;
}

Result<Frame> decode_jpeg(std::span<const std::uint8_t> bytes, const JpegOptions& options,
                          const std::function<Frame(int width, int height)>& make) {
  Decoder decoder;
  const Destroy destroy(decoder);
  const auto picture = from_beginning(bytes);
  if (!read_header(decoder, picture)) return corrupt(decoder);
  const Size size{static_cast<int>(decoder.info.image_width),
                  static_cast<int>(decoder.info.image_height)};
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
  if (pixels < 1 || pixels > options.most_pixels) {
    return fail(Errc::Corrupt, "JPEG: " + std::to_string(size.width) + " x " +
                                   std::to_string(size.height) + " pixels, expected 1 ... " +
                                   std::to_string(options.most_pixels));
  }
  if (options.size && *options.size != size) {
    return fail(Errc::Corrupt, "JPEG: a picture of " + text_of(size) + " in a stream of " +
                                   text_of(*options.size));
  }
  if (!start(decoder, options)) return corrupt(decoder);
  Frame frame = make(static_cast<int>(decoder.info.output_width),
                     static_cast<int>(decoder.info.output_height));
  std::vector<std::uint8_t> row;
  if (decoder.info.out_color_space == JCS_CMYK) {
    row.resize(std::size_t{4} * decoder.info.output_width);
  }
  if (!read_rows(decoder, frame, row.data()) || decoder.damaged) return corrupt(decoder);
  if (picture.size() != bytes.size()) decoder.odd.stray_bytes = true;
  frame.odd = decoder.odd;
  return frame;
}

Result<JpegHeader> read_jpeg_header(std::span<const std::uint8_t> bytes) {
  Decoder decoder;
  const Destroy destroy(decoder);
  if (!read_header(decoder, from_beginning(bytes))) return corrupt(decoder);
  JpegHeader header;
  header.size = {static_cast<int>(decoder.info.image_width),
                 static_cast<int>(decoder.info.image_height)};
  for (const auto* marker = decoder.info.marker_list; marker != nullptr; marker = marker->next) {
    if (marker->marker != kExif) continue;
    if (const int found = exif_orientation({marker->data, marker->data_length}); found != 0) {
      header.orientation = found;
      break;
    }
  }
  return header;
}

}  // namespace eyebridge::camera
