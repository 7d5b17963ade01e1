#include "support/conformance/Census.h"

#include <seahex/planning/HexStateSpace.h>

#include <ompl/base/spaces/SE2StateSpace.h>

#include <utility>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

/// A space that counts its states.
template <class Space>
class Counting : public Space
{
public:
    template <class... Arguments>
    explicit Counting(CensusPtr census, Arguments &&...arguments)
        : Space(std::forward<Arguments>(arguments)...), census_(std::move(census))
    {
    }

    ob::State *allocState() const override
    {
        ob::State *state = Space::allocState();
        census_->count(state);
        return state;
    }

    void freeState(ob::State *state) const override
    {
        census_->discount(state);
        Space::freeState(state);
    }

private:
    CensusPtr census_;
};

ob::RealVectorBounds boundsOf(const Box &box)
{
    ob::RealVectorBounds bounds(2);
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
        bounds.setLow(axis, box.min[axis]);
        bounds.setHigh(axis, box.max[axis]);
    }
    return bounds;
}

}  // namespace

void Census::count(const ob::State *state)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    states_.insert(state);
}

void Census::discount(const ob::State *state)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    states_.erase(state);
}

std::size_t Census::size() const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return states_.size();
}

bool Census::has(const ob::State *state) const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return states_.count(state) > 0;
}

ob::StateSpacePtr countingPlane(const Box &bounds, const CensusPtr &census)
{
    auto space = std::make_shared<Counting<ob::RealVectorStateSpace>>(census, 2u);
    space->setBounds(boundsOf(bounds));
    return space;
}

ob::StateSpacePtr countingSolid(const Box &bounds, const CensusPtr &census)
{
    auto space = std::make_shared<Counting<ob::RealVectorStateSpace>>(census, 3);
    ob::RealVectorBounds box(3);
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
        box.setLow(axis, bounds.min[axis]);
        box.setHigh(axis, bounds.max[axis]);
    }
    box.setLow(2, 0.0);
    box.setHigh(2, 4.0);
    space->setBounds(box);
    return space;
}

ob::StateSpacePtr countingPoses(const Box &bounds, const CensusPtr &census)
{
    auto space = std::make_shared<ob::SE2StateSpace>();
    space->setBounds(boundsOf(bounds));
    const_cast<ob::StateSpacePtr &>(space->getSubspace(1)) = std::make_shared<Counting<ob::SO2StateSpace>>(census);
    return space;
}

ob::StateSpacePtr countingCells(const HexLattice &lattice, const CensusPtr &census)
{
    return std::make_shared<Counting<HexStateSpace>>(census, lattice);
}

}  // namespace seahex::test
