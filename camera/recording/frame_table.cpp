#include "eyebridge/camera/recording/frame_table.hpp"

#include <string>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/camera/recording/checked_file.hpp"
#include "sources/frame_schedule.hpp"

namespace eyebridge::camera {
namespace {

/// The row at which `row` stands. Throws std::runtime_error when it cannot be one.
RecordedFrame read_row(const sqlite::Statement& row) {
  RecordedFrame frame;
  frame.row = sqlite::integer(row, 0);
  const std::string which = "frame " + std::to_string(frame.row) + ": ";
  try {
    frame.given = recorded_time(sqlite::integer(row, 1));
    frame.taken = recorded_time(sqlite::integer(row, 2), -kLongestRecording);  // before the run
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(which + error.what());
  }
  const std::int64_t sequence = sqlite::integer(row, 3);
  if (sequence < 0) throw std::runtime_error(which + "a negative number");
  frame.sequence = static_cast<std::uint64_t>(sequence);
  const std::int64_t width = sqlite::integer(row, 4);
  const std::int64_t height = sqlite::integer(row, 5);
  constexpr std::int64_t kMost = FrameSchedule::kLargestSide;
  if (width < 1 || width > kMost || height < 1 || height > kMost) {
    throw std::runtime_error(which + std::to_string(width) + " x " + std::to_string(height) +
                             " pixels, expected 1 ... " + std::to_string(kMost) + " each way");
  }
  frame.size = {static_cast<int>(width), static_cast<int>(height)};
  const auto format = find_pixel_format(sqlite::text(row, 6));
  if (!format)
    throw std::runtime_error(which + "unknown format " + in_quotes(sqlite::text(row, 6)));
  const auto codec = find_frame_codec(sqlite::text(row, 7));
  if (!codec) throw std::runtime_error(which + "unknown codec " + in_quotes(sqlite::text(row, 7)));
  frame.format = *format;
  frame.codec = *codec;
  frame.bytes = sqlite::integer(row, 8);
  return frame;
}

}  // namespace

FrameWriter::FrameWriter(RecordingFile& file, FrameCodec codec)
    : file_(file),
      codec_(codec),
      insert_(file.prepare("INSERT INTO frame(t,taken,sequence,width,height,format,codec,data) "
                           "VALUES(?,?,?,?,?,?,?,?)")) {}

void FrameWriter::add(const Frame& frame, Time now) {
  const std::vector<std::uint8_t> data = encode_frame(frame, codec_);  // outside of the lock
  file_.write(now, [&] {
    sqlite::reset(insert_);
    sqlite::bind(insert_, 1, std::int64_t{now.count()});
    sqlite::bind(insert_, 2, std::int64_t{frame.time.count()});
    sqlite::bind(insert_, 3, static_cast<std::int64_t>(frame.sequence));
    sqlite::bind(insert_, 4, std::int64_t{frame.width});
    sqlite::bind(insert_, 5, std::int64_t{frame.height});
    const bool grey = frame.format == PixelFormat::Grey8;
    const bool exact = codec_ == FrameCodec::Lossless || grey;
    sqlite::bind(insert_, 6, name_of(exact ? frame.format : PixelFormat::Rgb24));
    sqlite::bind(insert_, 7, name_of(codec_));
    sqlite::bind(insert_, 8, std::span(data));
    sqlite::step(insert_);
  });
}

FrameReader::FrameReader(const std::filesystem::path& path) : path_(path) {
  try {
    database_ = open_recording(path);
    read_rows();
  } catch (const std::runtime_error& error) {
    throw ConfigError({path.string()},
                      std::string(error.what()) + ": expected a recording (.ebrec)");
  }
}

void FrameReader::read_rows() {
  const auto table = sqlite::prepare(
      database_.get(), "SELECT 1 FROM sqlite_master WHERE type='table' AND name='frame'");
  if (!sqlite::step(table)) return;  // of a time when recordings had none
  sqlite::Rows rows(
      database_.get(),
      "SELECT seq,t,taken,sequence,width,height,format,codec,length(data) FROM frame ORDER BY seq");
  while (rows.next()) {
    RecordedFrame frame = read_row(rows.statement());
    rows.count(frame.bytes);
    if (!frames_.empty() && frame.given < frames_.back().given) {
      throw std::runtime_error("frame " + std::to_string(frame.row) +
                               ": earlier than the one before it");
    }
    frames_.push_back(frame);
  }
  data_ = sqlite::prepare(database_.get(), "SELECT data FROM frame WHERE seq=?");
}

Result<Frame> FrameReader::read(std::size_t index) {
  const RecordedFrame& row = frames_.at(index);
  try {
    sqlite::reset(data_);
    sqlite::bind(data_, 1, row.row);
    if (!sqlite::step(data_)) throw std::runtime_error("it is gone");
    Frame frame = decode_frame(sqlite::blob(data_, 0), row.codec, row.size, row.format);
    frame.time = row.taken;
    frame.sequence = row.sequence;
    sqlite3_reset(data_.get());  // whoever writes to the file must not wait for us
    return frame;
  } catch (const std::runtime_error& error) {
    return fail(Errc::Corrupt,
                path_.string() + ": frame " + std::to_string(row.row) + ": " + error.what());
  }
}

}  // namespace eyebridge::camera
