#include <seahex/search/SpreadQueue.h>

#include "support/Random.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

TEST(SpreadQueue, GivesTheLeastBucketFirstHoweverFarKeysLieApart)
{
    constexpr std::int64_t width = std::int64_t{1} << BucketQueue::shift;
    constexpr std::int64_t reach = (BucketQueue::buckets - 2) * width;
    forEachSeed(60,
                [](Random &random)
                {
                    SpreadQueue queue;
                    for (int round = 0; round < 3; ++round)
                    {
                        queue.clear();
                        std::multimap<std::int64_t, CellIndex> model;  // by bucket
                        CellIndex next = 0;
                        const std::int64_t spread = random.chance(0.5) ? 20 * reach : 1'000'000'000'000;
                        for (std::int64_t i = random.integer(0, 300); i > 0; --i)
                        {
                            const std::int64_t key = random.integer(0, spread);
                            queue.add(key, next);
                            model.emplace(key / width, next++);
                        }
                        queue.begin();
                        for (int step = 0; !queue.isCurrentEmpty() || queue.advance(); ++step)
                        {
                            ASSERT_FALSE(model.empty());
                            const std::int64_t bucket = model.begin()->first;
                            ASSERT_EQ(queue.least(), bucket * width);
                            const CellIndex cell = queue.pop();
                            const auto [first, end] = model.equal_range(bucket);
                            const auto found =
                                std::find_if(first, end, [cell](const auto &entry) { return entry.second == cell; });
                            ASSERT_NE(found, end);
                            model.erase(found);
                            for (std::int64_t i = random.integer(0, 2); i > 0 && step < 700; --i)
                            {
                                const bool isNear = random.chance(0.7);
                                const std::int64_t key = queue.least() + random.integer(0, isNear ? reach : spread);
                                isNear ? queue.push(key, next) : queue.pushAnywhere(key, next);
                                model.emplace(key / width, next++);
                            }
                        }
                        EXPECT_TRUE(model.empty());
                    }
                });
}
