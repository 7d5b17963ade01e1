#pragma once

#include <seahex/slices/SliceSearch.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <unordered_map>
#include <utility>
#include <vector>

namespace seahex
{

/// Of an ant colony.
struct AntSettings
{
    int ants = 20;             ///< that walk between two updates of the trail
    int iterations = 100;      ///< updates
    double evaporation = 0.1;  ///< share of the trail that is lost in an update, from 0 to 1
    double elite = 5.0;        ///< the best path so far is laid in every update as if by so many ants more
    double alpha = 1.0;        ///< weight of the trail
    double beta = 5.0;         ///< weight of the visibility
    int reach = 2;             ///< grid steps that an ant may go aside, up or down from plane to plane
    std::uint32_t seed = 1;
};

/// Ant System (Dorigo, Maniezzo and Colorni, IEEE Transactions on Systems, Man and Cybernetics B 26(1), 1996, doi
/// 10.1109/3477.484436) on slices: the baseline of [Xu], which gives no details of it.
///
/// An ant walks from plane to plane. Of the open points within reach it takes one with a probability in proportion to
/// trail^alpha visibility^beta (eq. 4 there); if the leg is not valid it draws again, and it gives up where no point
/// is left. The last leg leads to the goal however far that is. When all ants have walked, the trail loses its share,
/// each ant that arrived adds to the points of its path in inverse proportion to its F (ant-cycle), and the best so
/// far adds its own (the article's elitist strategy). As in the programs for slices that go around (after "MATLAB: 30
/// case studies of intelligent algorithms", Beihang University Press 2011) the trail lies on points rather than legs,
/// an ant goes two steps aside at most, and visibility is (1 - D) / (length of the leg + distance from there to the
/// goal). The amount laid is F_best / F, so that it does not depend on units, and a trail never falls below a
/// millionth of the first.
///
/// alpha 1 and beta 5 are the article's; its evaporation of 0.5 with no elite left F 8 % higher on hills at random
/// than the values here. The same seed gives the same path, interrupted or not. Ants prove nothing: where they find no
/// path there may be one.
class AntColonySearch : public SliceSearch
{
public:
    AntColonySearch(const SliceProblem &problem, const AntSettings &settings);
    Step work(LegJudge &judge) override;

    int iterations() const { return iteration_; }

private:
    enum class Walk
    {
        Arrived,
        Lost,
        Interrupted
    };
    struct Trail
    {
        SlicePath path;
        double total;
    };

    Walk walk(LegJudge &judge, SlicePath &path);
    LegJudge::Answer judgeLeg(LegJudge &judge, int plane, std::size_t from, std::size_t to);
    Eigen::Vector3d positionOf(int plane, std::size_t index) const;
    void gatherChoices(int plane, const Eigen::Vector3d &from);
    std::size_t draw();
    void updateTrails();
    double &trailAt(int plane, SliceCell cell)
    {
        return trail_[static_cast<std::size_t>(plane) * frame().cellCount() + frame().index(cell)];
    }

    AntSettings settings_;
    std::mt19937_64 engine_;
    std::vector<double> trail_;
    std::unordered_map<std::uint64_t, bool> legs_;         // that were judged
    std::vector<std::pair<std::size_t, double>> choices_;  // points within reach of an ant, and their odds
    std::vector<Trail> arrived_;                           // in this iteration
    double bestTotal_;
    int iteration_ = 0;
    int ant_ = 0;
};

}  // namespace seahex
