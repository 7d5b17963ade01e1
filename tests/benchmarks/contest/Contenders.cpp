#include "contest/BoostAStar.h"
#include "contest/ChainSearch.h"
#include "contest/Contender.h"
#include "contest/JumpPoints.h"
#include "contest/LatticeSearch.h"
#include "contest/TextbookAStar.h"

#include <stdexcept>

namespace seahex::contest
{
namespace
{

constexpr std::int64_t tenMillion = 10'000'000;
constexpr std::int64_t billion = 1'000'000'000;

/// Whatever its constructor takes beside the occupancy.
template <class Search, class... Settings>
std::function<std::unique_ptr<Contender>(const HexOccupancy &)> maker(Settings... settings)
{
    return [=](const HexOccupancy &occupancy)
    {
        return std::make_unique<Search>(occupancy, settings...);
    };
}

}  // namespace

const std::vector<ContenderKind> &contenders()
{
    static const std::vector<ContenderKind> all = {
        {"textbook_1", Side::Peer, 1, tenMillion, maker<TextbookAStar>(1)},
        {"textbook_3", Side::Peer, 3, tenMillion, maker<TextbookAStar>(3)},
        {"boost_1", Side::Peer, 1, tenMillion, maker<BoostAStar>()},
        {"astar_1", Side::Ours, 1, billion, maker<LatticeSearch>(1, Guidance::Distance)},
        {"astar_2", Side::Ours, 2, billion, maker<LatticeSearch>(2, Guidance::Distance)},
        {"astar_3", Side::Ours, 3, billion, maker<LatticeSearch>(3, Guidance::Distance)},
        {"relaxed_1", Side::Ours, 1, billion, maker<LatticeSearch>(1, Guidance::Relaxed)},
        {"relaxed_3", Side::Ours, 3, billion, maker<LatticeSearch>(3, Guidance::Relaxed)},
        {"jps_1", Side::Ours, 1, billion, maker<JumpPoints>()},
        {"length_1", Side::Ours, 1, billion, maker<ChainSearch>(1)},
        {"length_2", Side::Ours, 2, billion, maker<ChainSearch>(2)},
        {"length_3", Side::Ours, 3, billion, maker<ChainSearch>(3)},
    };
    return all;
}

const ContenderKind &contenderNamed(const std::string &name)
{
    for (const ContenderKind &kind : contenders())
        if (kind.name == name)
            return kind;
    throw std::runtime_error("no contender is called " + name);
}

}  // namespace seahex::contest
