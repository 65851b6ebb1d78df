#include "eyebridge/base/config_error.hpp"
#include "replay/ebrec.hpp"
#include "replay/numbers.hpp"

namespace eyebridge::hal {
namespace {

namespace sqlite = camera::sqlite;

camera::RecordingFacts facts_of(const RecordingOrigin& origin) {
  return {{"program", origin.program}, {"hal", origin.hal}, {"world", origin.world}};
}

}  // namespace

EbrecWriter::EbrecWriter(const std::filesystem::path& path,
                         const std::vector<ListedDevice>& devices, const RecordingOrigin& origin)
    : file_(path, facts_of(origin)) {
  try {
    const sqlite::Statement add_device = file_.prepare("INSERT INTO device VALUES(?,?,?)");
    file_.write(Time{0}, [&] {
      for (const ListedDevice& device : devices) {
        sqlite::reset(add_device);
        sqlite::bind(add_device, 1, device.kind);
        sqlite::bind(add_device, 2, std::int64_t{device.id});
        sqlite::bind(add_device, 3, write_numbers(device.facts));
        sqlite::step(add_device);
      }
    });
    file_.commit();
    insert_ = file_.prepare(
        "INSERT INTO exchange(t,device,id,call,request,reply,error,what) VALUES(?,?,?,?,?,?,?,?)");
  } catch (const std::runtime_error& error) {
    throw ConfigError({}, "cannot write " + path.string() + ": " + error.what());
  }
}

void EbrecWriter::add(Time time, const Call& call, const Result<Values>& reply) {
  file_.write(time, [&] {
    sqlite::reset(insert_);
    sqlite::bind(insert_, 1, std::int64_t{time.count()});
    sqlite::bind(insert_, 2, call.device);
    sqlite::bind(insert_, 3, std::int64_t{call.id});
    sqlite::bind(insert_, 4, call.name);
    sqlite::bind(insert_, 5, write_numbers(call.request));
    if (reply) {
      sqlite::bind(insert_, 6, write_numbers(*reply));
    } else {
      sqlite::bind(insert_, 7, std::int64_t{static_cast<int>(reply.error().code)});
      sqlite::bind(insert_, 8, reply.error().what);
    }
    sqlite::step(insert_);
  });
}

}  // namespace eyebridge::hal
