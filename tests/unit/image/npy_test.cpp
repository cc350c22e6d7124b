#include <gmock/gmock.h>

#include <cstring>

#include "core/error.h"
#include "image/image.h"
#include "test_folder.h"

namespace shadowlab::image {
namespace {

class Npy : public InFolder {
 protected:
  // Magic, version 1.0, the length of the fields in two bytes, the fields; then the values.
  static std::string fields_of(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    return bytes.substr(10, length_of(bytes));
  }
  static std::string values_of(const std::string& bytes) {
    return bytes.substr(10 + length_of(bytes));
  }

 private:
  static std::size_t length_of(const std::string& bytes) {
    return static_cast<std::uint8_t>(bytes[8]) + 256u * static_cast<std::uint8_t>(bytes[9]);
  }
};

TEST_F(Npy, of_floats_is_a_header_and_the_values_as_they_are) {
  const std::vector<float> values = {0.f, 0.5f, -1.f, 3.25f, 1e-30f, 7.f};
  const std::size_t shape[] = {2, 3};
  write_npy(in_folder("a.npy"), shape, std::span<const float>(values));
  const std::string bytes = bytes_of(in_folder("a.npy"));
  EXPECT_THAT(fields_of(bytes),
              testing::StartsWith("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3, ), }"));
  ASSERT_EQ(values_of(bytes).size(), 24u);
  EXPECT_EQ(std::memcmp(values_of(bytes).data(), values.data(), 24), 0);
}

TEST_F(Npy, values_begin_at_a_multiple_of_64_after_a_line_feed) {
  const std::vector<std::uint8_t> values(1000);
  for (const auto& shape :
       {std::vector<std::size_t>{1000}, {10, 100}, {10, 25, 4}, {1, 1, 1, 1, 1, 1, 1, 1000}}) {
    write_npy(in_folder("a.npy"), shape, std::span<const std::uint8_t>(values));
    const std::string bytes = bytes_of(in_folder("a.npy"));
    EXPECT_EQ((bytes.size() - values_of(bytes).size()) % 64, 0u);
    EXPECT_EQ(fields_of(bytes).back(), '\n');
    EXPECT_THAT(fields_of(bytes), testing::HasSubstr("'|u1'"));
  }
}

TEST_F(Npy, of_one_dimension_has_the_comma_that_makes_a_tuple) {
  const std::size_t shape[] = {3};
  const std::vector<std::uint8_t> values = {1, 2, 3};
  write_npy(in_folder("a.npy"), shape, std::span<const std::uint8_t>(values));
  EXPECT_THAT(fields_of(bytes_of(in_folder("a.npy"))), testing::HasSubstr("'shape': (3, )"));
}

TEST_F(Npy, to_a_missing_folder_names_the_folder) {
  const std::size_t shape[] = {1};
  const std::vector<float> values = {1.f};
  EXPECT_THAT(message_of<InputError>([&] {
                write_npy(in_folder("none/a.npy"), shape, std::span<const float>(values));
              }),
              testing::HasSubstr("there is no folder"));
}

}  // namespace
}  // namespace shadowlab::image
