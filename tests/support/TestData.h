#pragma once

#include <filesystem>
#include <optional>
#include <string>

/// Makes `variable` the path of a folder of test data, or skips the test with the reason where there is none.
#define SEAHEX_TEST_DATA_OR_SKIP(variable, name)                                                                       \
    if (!seahex::test::testData(name))                                                                                 \
        GTEST_SKIP() << seahex::test::whyNoTestData(name);                                                             \
    const std::filesystem::path variable = *seahex::test::testData(name)

namespace seahex::test
{

/// The folder `name` in the folder that the environment variable SEAHEX_TEST_DATA names; empty where there is none.
std::optional<std::filesystem::path> testData(const std::string &name);

/// One sentence for a skipped test.
std::string whyNoTestData(const std::string &name);

}  // namespace seahex::test
