#include "measure/journal.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>

#include "core/error.h"

namespace shadowlab::measure {
namespace {

const std::string options_key = "options";

}  // namespace

Journal::Journal(const std::filesystem::path& file, const Json& options) : file_(file) {
  read();
  const auto before = entries_.find(options_key);
  if (before != entries_.end() && before->second != options) {
    throw InputError(fmt::format(
        "{} holds a measurement with other options; go on with those, choose another folder, or "
        "begin again with --fresh",
        file_.parent_path().string()));
  }
  found_ = entries_.size();
  out_.open(file_, std::ios::binary | std::ios::app);
  if (!out_) throw InputError(fmt::format("cannot write {}", file_.string()));
  if (before == entries_.end()) write(options_key, options);
}

// Cuts off what does not end in a newline: it was being written.
void Journal::read() {
  std::ifstream in(file_, std::ios::binary);
  if (!in) return;
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::size_t at = 0;
  for (std::size_t end; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
    const Json line = Json::parse(text.begin() + static_cast<std::ptrdiff_t>(at),
                                  text.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
    if (!line.is_object() || !line.contains("key") || !line.at("key").is_string() ||
        !line.contains("value")) {
      throw InputError(
          fmt::format("{} is not a journal of shadowlab measure; move it away, or "
                      "choose another folder",
                      file_.string()));
    }
    entries_[line.at("key").get<std::string>()] = line.at("value");
  }
  if (at < text.size()) std::filesystem::resize_file(file_, at);
}

std::optional<Json> Journal::find(const std::string& key) const {
  const auto found = entries_.find(key);
  if (found == entries_.end()) return {};
  return found->second;
}

void Journal::write(const std::string& key, const Json& value) {
  out_
      << Json({{"key", key}, {"value", value}}).dump(-1, ' ', false, Json::error_handler_t::replace)
      << '\n';
  out_.flush();
  if (!out_) throw InputError(fmt::format("cannot write {}: is the disk full?", file_.string()));
  entries_[key] = value;
}

}  // namespace shadowlab::measure
