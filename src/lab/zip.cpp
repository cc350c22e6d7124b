#include "lab/zip.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <zip.h>

#include <array>
#include <fstream>
#include <memory>

#include "core/error.h"

namespace shadowlab::lab {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_bytes = std::uint64_t{4} << 30;
constexpr zip_int64_t most_files = 200'000;

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw InputError(fmt::format("{}: {}", file.string(), why));
}

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct Close {
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};
using Archive = std::unique_ptr<zip_t, Discard>;

Archive open(const fs::path& file, int flags) {
  int code = 0;
  Archive archive(zip_open(file.c_str(), flags, &code));
  if (archive) return archive;
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  refuse(file, fmt::format("this zip archive cannot be opened ({})", why));
}

bool leads_out(const fs::path& name) {
  if (name.is_absolute() || name.empty()) return true;
  for (const auto& part : name) {
    if (part == "..") return true;
  }
  return false;
}

bool is_link(zip_t* archive, zip_uint64_t index) {
  zip_uint8_t system = 0;
  zip_uint32_t attributes = 0;
  zip_file_get_external_attributes(archive, index, 0, &system, &attributes);
  return system == ZIP_OPSYS_UNIX && S_ISLNK(attributes >> 16);
}

// Writes one entry and gives its size: what its header says of it may be a lie.
std::uint64_t extract(zip_t* archive, zip_uint64_t index, const fs::path& to, std::uint64_t left,
                      const fs::path& file) {
  const std::unique_ptr<zip_file_t, Close> entry(zip_fopen_index(archive, index, 0));
  if (!entry) refuse(file, fmt::format("a file in it cannot be read ({})", zip_strerror(archive)));
  fs::create_directories(to.parent_path());
  std::ofstream out(to, std::ios::binary);
  std::array<char, 65536> block;
  std::uint64_t bytes = 0;
  for (zip_int64_t read; (read = zip_fread(entry.get(), block.data(), block.size())) != 0;) {
    if (read < 0) refuse(file, "a file in it is broken");
    bytes += static_cast<std::uint64_t>(read);
    if (bytes > left) refuse(file, "it unpacks to more than 4 GiB");
    out.write(block.data(), read);
  }
  if (!out.flush()) refuse(to, "it cannot be written");
  return bytes;
}

}  // namespace

void write_zip(const fs::path& file, std::span<const Packed> files) {
  Archive archive = open(file, ZIP_CREATE | ZIP_TRUNCATE);
  for (const Packed& packed : files) {
    zip_source_t* source =
        zip_source_buffer(archive.get(), packed.bytes.data(), packed.bytes.size(), 0);
    const zip_int64_t index =
        zip_file_add(archive.get(), packed.name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
      zip_source_free(source);
      refuse(file, zip_strerror(archive.get()));
    }
    const auto entry = static_cast<zip_uint64_t>(index);
    const zip_uint32_t mode = packed.mode == Packed::Mode::executable ? 0100755 : 0100644;
    zip_file_set_external_attributes(archive.get(), entry, 0, ZIP_OPSYS_UNIX, mode << 16);
    zip_file_set_mtime(archive.get(), entry, 946684800, 0);  // the same archive every time
  }
  if (zip_close(archive.get()) != 0)
    refuse(file, fmt::format("cannot be written ({})", zip_strerror(archive.get())));
  static_cast<void>(archive.release());  // closed
}

void unzip(const fs::path& file, const fs::path& folder) {
  const Archive archive = open(file, ZIP_RDONLY);
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  if (count > most_files) refuse(file, "it holds more than 200,000 files");
  std::uint64_t left = most_bytes;
  for (zip_int64_t i = 0; i < count; ++i) {
    const auto index = static_cast<zip_uint64_t>(i);
    const char* given = zip_get_name(archive.get(), index, 0);
    const std::string name = given ? given : "";
    if (leads_out(name)) refuse(file, fmt::format("it names a file outside of itself: {}", name));
    if (is_link(archive.get(), index)) continue;
    if (name.ends_with('/')) {
      fs::create_directories(folder / name);
    } else {
      left -= extract(archive.get(), index, folder / name, left, file);
    }
  }
}

}  // namespace shadowlab::lab
