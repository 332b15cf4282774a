// Copies of shared lists.

#include "base/shared_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace signorini {
namespace shared_list_test {

TEST(SharedList, CopiesShareElementsUntilOneWrites) {
  SharedList<int> list;
  list.own() = {1, 2, 3};
  SharedList<int> copy = list;
  EXPECT_EQ(&copy[0], &list[0]);
  copy.own()[1] = 5;
  EXPECT_TRUE(std::ranges::equal(copy, std::vector{1, 5, 3}));
  EXPECT_TRUE(std::ranges::equal(list, std::vector{1, 2, 3}));
  const int* first = &copy[0];
  copy.own()[0] = 4;
  EXPECT_EQ(first, &copy[0]) << "its own elements stay where they are";
  list = copy;
  EXPECT_EQ(list[0], 4);
}

} // namespace shared_list_test
} // namespace signorini
