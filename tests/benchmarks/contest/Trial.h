#pragma once

#include "contest/Contender.h"
#include "contest/World.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace seahex::contest
{

/// A world with its queries, and what each must cost.
class Course
{
public:
    Course(World world, std::size_t queries, std::uint64_t seed);

    const World &world() const { return world_; }
    const std::vector<Query> &queries() const { return queries_; }

    /// Holds a cost against the textbook's for the same query and rings. In a world too large for the textbook the
    /// first answer to a query is what the others must equal.
    /// @throws std::runtime_error if they differ by more than rounding
    void check(const ContenderKind &kind, std::size_t query, double cost);

private:
    double &expected(const ContenderKind &kind, std::size_t query, double cost);

    World world_;
    std::vector<Query> queries_;
    std::vector<std::vector<std::optional<double>>> costs_;  // of each ring
};

/// What a contender did on a course.
struct Result
{
    std::string world;
    std::string contender;
    Side side = Side::Ours;
    int rings = 1;
    std::int64_t cells = 0;
    std::size_t indices = 0;      ///< of the layout: the cells, their frame and the rows' padding
    std::vector<double> queryMs;  ///< of each query the least wall time of all passes
    std::vector<Answer> answers;

    double medianMs() const;
    double meanMs() const;
    double nsPerExpansion() const;   ///< over all queries
    double expanded() const;         ///< cells, by all queries
    double bytesPerTouched() const;  ///< over all queries; 0 where the contender can't tell
    double bitsPerIndex() const;     ///< held for every index of the layout, touched or not
};

/// A contender on its way through a course.
class Trial
{
public:
    Trial(Course &course, const ContenderKind &kind);

    /// Solves every query once. @return wall seconds of all, without the checking
    /// @throws std::runtime_error if a cost is wrong
    double pass();

    const Result &result() const { return result_; }

private:
    Answer solve(const Query &query);

    Course &course_;
    const ContenderKind &kind_;
    std::unique_ptr<Contender> contender_;
    Result result_;
};

}  // namespace seahex::contest
