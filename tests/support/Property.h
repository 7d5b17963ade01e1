#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace seahex::test
{

/// Checks a RapidCheck property in (at least) `cases` cases. A failure shows the smallest counterexample found, the
/// seed and the value of RC_PARAMS that repeats it.
template <class Testable>
void checkProperty(int cases, Testable &&property)
{
    const ::testing::TestInfo *info = ::testing::UnitTest::GetInstance()->current_test_info();
    rc::detail::TestMetadata metadata;
    metadata.id = std::string(info->test_suite_name()) + "/" + info->name();
    metadata.description = info->name();
    rc::detail::TestParams params = rc::detail::configuration().testParams;
    params.maxSuccess = std::max(params.maxSuccess, cases);
    const rc::detail::TestResult result = rc::detail::checkTestable(std::forward<Testable>(property), metadata, params);
    if (result.template is<rc::detail::SuccessResult>())
        return;
    std::ostringstream message;
    rc::detail::printResultMessage(result, message);
    FAIL() << "seed " << params.seed << ": " << message.str();
}

}  // namespace seahex::test
