#include "seahex/search/LengthMatrix.h"

#include "seahex/search/LengthTree.h"
#include "search/WorkTeam.h"

#include <limits>

namespace seahex
{

LengthMatrix::LengthMatrix(std::size_t starts, std::size_t goals)
    : starts_(starts), goals_(goals), lengths_(starts * goals, std::numeric_limits<double>::quiet_NaN())
{
}

LengthMatrix lengthMatrix(const Occupancy &occupancy, int rings, const std::vector<HexCoord> &starts,
                          const std::vector<HexCoord> &goals, const BatchControl &control)
{
    LengthMatrix matrix(starts.size(), goals.size());
    const bool isFromStarts = starts.size() <= goals.size();
    const std::vector<HexCoord> &roots = isFromStarts ? starts : goals;
    const std::vector<HexCoord> &targets = isFromStarts ? goals : starts;
    const std::shared_ptr<const Occupancy> notOwned(std::shared_ptr<const Occupancy>(), &occupancy);
    const auto makeWorker = [&](std::function<bool()> stop)
    {
        return [&, stop = std::move(stop), tree = LengthTree(notOwned, rings)](std::size_t root) mutable
        {
            tree.plant(roots[root]);
            for (std::size_t target = 0; target < targets.size(); ++target)
            {
                if (tree.growTo(targets[target], stop) == SearchStatus::Stopped)
                    return false;
                (isFromStarts ? matrix(root, target) : matrix(target, root)) = tree.length(targets[target]);
            }
            return true;
        };
    };
    WorkTeam(control).run(roots.size(), makeWorker);
    return matrix;
}

}  // namespace seahex
