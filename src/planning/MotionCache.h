#pragma once

#include "planning/Courses.h"
#include "seahex/planning/PlanarEmbedding.h"
#include "seahex/search/Jumps.h"

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include <cstdint>
#include <map>
#include <vector>

namespace seahex
{

/// Asks a user's SpaceInformation which cells and jumps of a lattice are valid: lazily, each cell and each jump once
/// (there and back is one), and with a look at the termination condition after 16 questions at most, because an answer
/// may take long.
///
/// In SE(2) a state's yaw is the course of the leg that led to it, so a motion depends on the leg before it: motions
/// are then asked for whenever a cell is expanded. Remembered are those that were found wanting afterwards, and the
/// answers of an expansion that was interrupted.
class MotionCache
{
public:
    enum class Answer
    {
        Valid,
        Invalid,
        Interrupted
    };

    /// What is known of the jumps from one cell: of the first `count`, bit k of `valid` tells about jump k.
    struct Answers
    {
        std::uint8_t arrivedBy;
        std::size_t count = 0;
        std::uint64_t valid = 0;
    };

    /// @param isChart  cells whose centre lies outside the space's bounds are left out, so no jump may touch them
    MotionCache(const ompl::base::SpaceInformationPtr &si, const PlanarEmbedding &embedding, const Lattice &lattice,
                const CellLayout &layout, const Jumps &jumps, JumpRule rule, bool isChart)
        : si_(si), embedding_(embedding), lattice_(lattice), layout_(layout), jumps_(jumps), rule_(rule),
          bounds_(embedding.bounds()),
          isCut_(isChart && !(bounds_.contains(lattice.bounds().min) && bounds_.contains(lattice.bounds().max))),
          cells_(layout.size(), unknown), motions_(layout.size() * jumps.size(), unknown), from_(si), to_(si)
    {
    }

    /// Looks at the condition, and from now on again and again; it must outlive the questions.
    void watch(const ompl::base::PlannerTerminationCondition &condition)
    {
        condition_ = &condition;
        look();
    }

    /// True if the cell's centre lies in the space's bounds and is a valid state (whatever its yaw, where there is
    /// one).
    bool isCellUsable(CellIndex cell)
    {
        const OffsetCoord o = layout_.offset(cell);
        if (o.row < 0 || o.row >= layout_.rows() || o.column < 0 || o.column >= layout_.columns())
            return false;
        const Point centre = lattice_.centre(o);
        if (!bounds_.contains(centre))
            return false;
        if (embedding_.hasHeading())
            return true;
        if (cells_[cell] == unknown)
        {
            embedding_.place(to_.get(), centre);
            cells_[cell] = ask(si_->isValid(to_.get())) ? valid : invalid;
        }
        return cells_[cell] == valid;
    }

    /// Is the jump from a cell's centre to its successor's valid? `heading` is the yaw at the cell.
    Answer jump(CellIndex from, CellIndex to, std::size_t jump, double heading)
    {
        std::uint8_t &known = motions_[from * jumps_.size() + jump];
        if (known == unknown)
        {
            if (interrupted())
                return Answer::Interrupted;
            const bool isValid =
                isCellUsable(to) && isWithinBounds(from, jump) &&
                motion(lattice_.centre(layout_.offset(from)), heading, lattice_.centre(layout_.offset(to)));
            if (embedding_.hasHeading())
                return isValid ? Answer::Valid : Answer::Invalid;
            known = isValid ? valid : invalid;
            if (isCellInside(to))
                motions_[to * jumps_.size() + jumps_.opposite(jump)] = known;
        }
        return known == valid ? Answer::Valid : Answer::Invalid;
    }

    /// Declares a jump invalid, whatever the yaw.
    void forbid(CellIndex from, std::size_t jump)
    {
        forbidden_.push_back(from * jumps_.size() + jump);
        motions_[forbidden_.back()] = invalid;
        unfinished_.clear();
    }

    /// Takes all of that back.
    void allowAll()
    {
        for (const std::size_t motion : forbidden_)
            motions_[motion] = unknown;
        forbidden_.clear();
        unfinished_.clear();
    }

    /// Keeps the answers of an expansion that was interrupted. Without them a slow checker and little time would begin
    /// it again and again.
    void keep(CellIndex cell, const Answers &answers) { unfinished_[cell] = answers; }

    /// Hands out what was kept for a cell reached by the same jump.
    Answers take(CellIndex cell, std::uint8_t arrivedBy)
    {
        const auto kept = unfinished_.find(cell);
        if (kept == unfinished_.end())
            return {arrivedBy};
        const Answers answers = kept->second;
        unfinished_.erase(kept);
        return answers.arrivedBy == arrivedBy ? answers : Answers{arrivedBy};
    }

    /// True if the condition holds. Looks at it again if since the last time 13 questions were asked (with the three of
    /// one jump, 16 at most), or this was called often enough for known answers to have taken a while.
    bool interrupted()
    {
        if (questions_ >= 13 || ++calls_ >= 100)
            look();
        return interrupted_;
    }

    /// Counts a question put to the user's code.
    bool ask(bool answer)
    {
        ++questions_;
        return answer;
    }

    /// Is the motion valid? It counts as many questions as it may be calls of the user's checker.
    bool askMotion(const ompl::base::State *from, const ompl::base::State *to)
    {
        questions_ += si_->getStateSpace()->validSegmentCount(from, to);
        return ask(si_->checkMotion(from, to));
    }

private:
    static constexpr std::uint8_t unknown = 0;
    static constexpr std::uint8_t valid = 1;
    static constexpr std::uint8_t invalid = 2;

    void look()
    {
        questions_ = 0;
        calls_ = 0;
        interrupted_ = (*condition_)();
    }

    bool isCellInside(CellIndex cell) const
    {
        const OffsetCoord o = layout_.offset(cell);
        return o.row >= 0 && o.row < layout_.rows() && o.column >= 0 && o.column < layout_.columns();
    }

    bool isWithinBounds(CellIndex from, std::size_t jump) const
    {
        if (!isCut_)
            return true;
        const Jump &entry = jumps_.from(jumps_.parity(from))[jump];
        for (std::uint16_t t = entry.firstTouch; t < entry.endTouch; ++t)
        {
            const auto touched = static_cast<CellIndex>(static_cast<std::int64_t>(from) + jumps_.touched()[t]);
            if (!bounds_.contains(lattice_.centre(layout_.offset(touched))))
                return false;
        }
        return true;
    }

    bool motion(const Point &a, double heading, const Point &b)
    {
        embedding_.place(from_.get(), a, heading);
        embedding_.place(to_.get(), b, courseBetween(a, b));
        return (!embedding_.hasHeading() || ask(si_->isValid(to_.get()))) &&
               (rule_ == JumpRule::Hopping || askMotion(from_.get(), to_.get()));
    }

    ompl::base::SpaceInformationPtr si_;
    PlanarEmbedding embedding_;
    Lattice lattice_;
    CellLayout layout_;
    const Jumps &jumps_;
    JumpRule rule_;
    Box bounds_;
    bool isCut_;  // a jump may touch cells outside the bounds
    std::vector<std::uint8_t> cells_;
    std::vector<std::uint8_t> motions_;
    std::map<CellIndex, Answers> unfinished_;
    std::vector<std::size_t> forbidden_;
    ompl::base::ScopedState<> from_;
    ompl::base::ScopedState<> to_;
    const ompl::base::PlannerTerminationCondition *condition_ = nullptr;
    unsigned int questions_ = 0;  // since the last look
    unsigned int calls_ = 0;
    bool interrupted_ = false;
};

}  // namespace seahex
