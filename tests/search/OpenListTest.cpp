#include <seahex/search/OpenList.h>

#include "support/Random.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

bool before(const OpenEntry &a, const OpenEntry &b)
{
    return a.key < b.key || (a.key == b.key && a.tie < b.tie);
}

}  // namespace

TEST(OpenList, topIsTheFirstOfAllEntries)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        OpenList<bool (*)(const OpenEntry &, const OpenEntry &)> open(before);
        std::vector<OpenEntry> expected;
        for (CellIndex i = 0; i < 400; ++i)
        {
            if (random.chance(0.6) || expected.empty())
            {
                // few different keys, so that ties matter
                const OpenEntry entry{static_cast<double>(random.integer(0, 9)), random.unit(), i};
                open.push(entry);
                expected.push_back(entry);
            }
            else
            {
                expected.erase(std::min_element(expected.begin(), expected.end(), before));
                open.pop();
            }
            ASSERT_EQ(open.size(), expected.size());
            ASSERT_EQ(open.empty(), expected.empty());
            if (!expected.empty())
            {
                ASSERT_EQ(open.top().cell, std::min_element(expected.begin(), expected.end(), before)->cell);
            }
        }
        open.clear();
        EXPECT_TRUE(open.empty());
    }
}

TEST(OpenList, renewedEntriesComeInTheirNewOrder)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        OpenList<bool (*)(const OpenEntry &, const OpenEntry &)> open(before);
        const std::int64_t size = random.integer(0, 60);
        for (CellIndex i = 0; i < static_cast<CellIndex>(size); ++i)
            open.push({random.unit(), random.unit(), i});
        std::vector<OpenEntry> expected;
        open.renew(
            [&](OpenEntry &entry)
            {
                entry.key = static_cast<double>(random.integer(0, 9));
                entry.tie = random.unit();
                if (random.chance(0.3))
                    return false;
                expected.push_back(entry);
                return true;
            });
        std::sort(expected.begin(), expected.end(), before);
        ASSERT_EQ(open.size(), expected.size());
        for (const OpenEntry &entry : expected)
        {
            ASSERT_EQ(open.top().cell, entry.cell);
            ASSERT_EQ(open.top().key, entry.key);
            open.pop();
        }
        EXPECT_TRUE(open.empty());
    }
}
