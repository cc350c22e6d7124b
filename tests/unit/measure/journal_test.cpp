#include "measure/journal.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>

#include "core/error.h"

namespace shadowlab::measure {
namespace {

class JournalTest : public testing::Test {
 protected:
  JournalTest() {
    std::string name =
        (std::filesystem::temp_directory_path() / "shadowlab journal XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    file_ = folder_ / "journal.jsonl";
  }
  ~JournalTest() override {
    std::error_code none;
    std::filesystem::remove_all(folder_, none);
  }
  void append(const std::string& text) const {
    std::ofstream(file_, std::ios::app | std::ios::binary) << text;
  }
  std::filesystem::path folder_, file_;
};

TEST_F(JournalTest, gives_back_what_was_written_before) {
  { Journal(file_, "options").write("a", 0.1); }
  const Journal again(file_, "options");
  EXPECT_EQ(again.find("a"), Json(0.1));
  EXPECT_FALSE(again.find("b"));
}

TEST_F(JournalTest, a_line_that_was_cut_off_was_not_written) {
  { Journal(file_, "options").write("a", 1); }
  append(R"({"key":"b","val)");
  {
    Journal again(file_, "options");
    EXPECT_FALSE(again.find("b"));
    again.write("b", 2);
  }
  EXPECT_EQ(Journal(file_, "options").find("b"), Json(2));
}

TEST_F(JournalTest, refuses_to_go_on_with_other_options) {
  { Journal(file_, {{"size", 1}}).write("a", 1); }
  EXPECT_THROW(Journal(file_, {{"size", 2}}), InputError);
}

TEST_F(JournalTest, refuses_a_file_that_is_something_else) {
  append("a letter\n");
  EXPECT_THROW(Journal(file_, "options"), InputError);
}

}  // namespace
}  // namespace shadowlab::measure
