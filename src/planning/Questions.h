#pragma once

#include <ompl/base/PlannerTerminationCondition.h>

#include <cstddef>
#include <vector>

namespace seahex
{

/// Questions put to a problem's own code by work whose course is decided by their answers alone. Such work may be ended
/// by a termination condition and done once more: the answers given before are played back, so that nothing is asked
/// twice and the work comes further each time.
class Questions
{
public:
    /// @param answers  those of earlier times, to which the new ones are added
    Questions(std::vector<bool> &answers, const ompl::base::PlannerTerminationCondition &stop)
        : answers_(answers), stop_(stop), isOver_(stop())
    {
    }

    /// @param weight  calls of the user's code that the answer takes
    /// @return the answer, or false if no more may be asked
    template <class Question>
    bool ask(unsigned int weight, Question &&question)
    {
        if (next_ < answers_.size())
            return answers_[next_++];
        sinceLook_ += weight;
        if (!isOver_ && sinceLook_ >= 16)
        {
            sinceLook_ = weight;
            isOver_ = stop_();
        }
        if (isOver_)
            return false;
        answers_.push_back(question());
        ++next_;
        return answers_.back();
    }

    /// True if the condition ended the work; then answers may be missing.
    bool isOver() const { return isOver_; }

private:
    std::vector<bool> &answers_;
    const ompl::base::PlannerTerminationCondition &stop_;
    std::size_t next_ = 0;
    unsigned int sinceLook_ = 0;
    bool isOver_;
};

}  // namespace seahex
