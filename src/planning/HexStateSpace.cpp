#include "seahex/planning/HexStateSpace.h"

#include "planning/HexStateProjection.h"
#include "planning/HexStateSampler.h"

#include <ompl/util/Exception.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <ostream>

namespace ob = ompl::base;

namespace seahex
{
namespace
{

HexStateSpace::StateType *cast(ob::State *state)
{
    return state->as<HexStateSpace::StateType>();
}

HexCoord cellOf(const ob::State *state)
{
    return state->as<HexStateSpace::StateType>()->cell();
}

__extension__ using Wide = __int128;

constexpr int fractionBits = 53;
constexpr std::int64_t whole = std::int64_t{1} << fractionBits;

/// t in units of 2^-53, such that those of t and of 1 - t make a whole, however 1 - t was rounded.
std::int64_t fractionOf(double t)
{
    if (!(t > 0.0))
        return 0;
    return t < 1.0 ? whole - static_cast<std::int64_t>(std::ldexp(1.0 - t, fractionBits)) : whole;
}

/// The cell with the centre nearest to the point between two centres.
HexCoord cellBetween(HexCoord a, HexCoord b, std::int64_t fraction, const HexLattice &lattice)
{
    // The point's cube coordinates are corner + (alpha, beta) / whole, 0 <= alpha, beta < whole, so the four centres
    // about it are candidates. With |(q, s)|^2 = q^2 + q s + s^2 their squared distances differ by what is linear in
    // alpha and beta.
    const Wide q = Wide(a.q) * whole + (Wide(b.q) - a.q) * fraction;
    const Wide s = Wide(a.s) * whole + (Wide(b.s) - a.s) * fraction;
    const HexCoord corner{static_cast<std::int64_t>(q >> fractionBits), static_cast<std::int64_t>(s >> fractionBits)};
    const auto alpha = static_cast<std::int64_t>(q - Wide(corner.q) * whole);
    const auto beta = static_cast<std::int64_t>(s - Wide(corner.s) * whole);
    const struct
    {
        HexCoord cell;
        std::int64_t farther;
    } candidates[4] = {{corner, 0},
                       {corner + HexCoord{1, 0}, whole - 2 * alpha - beta},
                       {corner + HexCoord{0, 1}, whole - alpha - 2 * beta},
                       {corner + HexCoord{1, 1}, 3 * (whole - alpha - beta)}};
    const auto *nearest = candidates;
    for (const auto &candidate : candidates)
        if (candidate.farther < nearest->farther ||
            (candidate.farther == nearest->farther && lattice.contains(candidate.cell) &&
             !lattice.contains(nearest->cell)))
            nearest = &candidate;
    return nearest->cell;
}

/// The bits of a number as integers of a signature.
void append(std::vector<int> &signature, std::int64_t number)
{
    signature.push_back(static_cast<int>(static_cast<std::int32_t>(number & 0xffffffff)));
    signature.push_back(static_cast<int>(static_cast<std::int32_t>(number >> 32)));
}

void append(std::vector<int> &signature, double number)
{
    const double positiveZero = number + 0.0;
    std::int64_t bits = 0;
    std::memcpy(&bits, &positiveZero, sizeof bits);
    append(signature, bits);
}

}  // namespace

HexStateSpace::HexStateSpace(const HexLattice &lattice)
    : lattice_(lattice), unit_(std::ldexp(1.0, std::ilogb(lattice.pitch()) - 32)),
      unitsPerPitch_(static_cast<std::int64_t>(lattice.pitch() * (1.0 - 0x1p-30) / unit_))
{
    const Box box = lattice.bounds();
    if (!(std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff()) <= std::ldexp(lattice.pitch(), 40)))
        throw ompl::Exception("seahex", "the lattice's coordinates exceed 2^40 pitches");
    setName("Hex" + getName());

    // Rows of different parity are half a cell wider together, which may be worth more than a row.
    const HexCoord northEast = toCube({lattice.columns() - 1, 0});
    const HexCoord southWest = toCube({0, lattice.rows() - 1});
    const HexCoord aboveIt = toCube({0, std::max<std::int64_t>(lattice.rows() - 2, 0)});
    const double step = norm({1, 0});
    extent_ = std::max({norm(southWest - northEast), norm(aboveIt - northEast), lattice.cellCount() == 1 ? step : 0.0});
    longestValidSegmentFraction_ = step / extent_;
}

double HexStateSpace::norm(HexCoord difference) const
{
    const auto q = static_cast<double>(difference.q);
    const auto s = static_cast<double>(difference.s);
    const double squared = q * q + q * s + s * s;
    const double units = std::ceil(static_cast<double>(unitsPerPitch_) * std::sqrt(squared));
    if (!(units < 0x1p52))
        return units * unit_;
    // Two roundings above make it wrong by one at most; the least whole number not below the root is wanted.
    const Wide target = Wide(unitsPerPitch_) * unitsPerPitch_ * static_cast<std::int64_t>(squared);
    auto root = static_cast<Wide>(units);
    while (root * root < target)
        ++root;
    while (root > 0 && (root - 1) * (root - 1) >= target)
        --root;
    return static_cast<double>(root) * unit_;
}

double HexStateSpace::getMeasure() const
{
    return static_cast<double>(lattice_.cellCount()) * 1.5 * lattice_.side() * lattice_.pitch();
}

void HexStateSpace::enforceBounds(ob::State *state) const
{
    const OffsetCoord o = toOffset(cellOf(state));
    cast(state)->setCell(toCube({std::clamp<std::int64_t>(o.column, 0, lattice_.columns() - 1),
                                 std::clamp<std::int64_t>(o.row, 0, lattice_.rows() - 1)}));
}

bool HexStateSpace::satisfiesBounds(const ob::State *state) const
{
    return lattice_.contains(cellOf(state));
}

void HexStateSpace::copyState(ob::State *destination, const ob::State *source) const
{
    cast(destination)->setCell(cellOf(source));
}

bool HexStateSpace::equalStates(const ob::State *state1, const ob::State *state2) const
{
    return cellOf(state1) == cellOf(state2);
}

double HexStateSpace::distance(const ob::State *state1, const ob::State *state2) const
{
    return norm(cellOf(state2) - cellOf(state1));
}

void HexStateSpace::interpolate(const ob::State *from, const ob::State *to, double t, ob::State *state) const
{
    cast(state)->setCell(cellBetween(cellOf(from), cellOf(to), fractionOf(t), lattice_));
}

unsigned int HexStateSpace::validSegmentCount(const ob::State *state1, const ob::State *state2) const
{
    const double count = static_cast<double>(hexDistance(cellOf(state1), cellOf(state2))) *
                         static_cast<double>(longestValidSegmentCountFactor_);
    constexpr double most = std::numeric_limits<int>::max();
    return static_cast<unsigned int>(std::clamp(count, 1.0, most));
}

ob::StateSamplerPtr HexStateSpace::allocDefaultStateSampler() const
{
    return std::make_shared<HexStateSampler>(this);
}

ob::State *HexStateSpace::allocState() const
{
    return new StateType();
}

void HexStateSpace::freeState(ob::State *state) const
{
    delete cast(state);
}

unsigned int HexStateSpace::getSerializationLength() const
{
    return sizeof(HexCoord);
}

void HexStateSpace::serialize(void *serialization, const ob::State *state) const
{
    const HexCoord cell = cellOf(state);
    std::memcpy(serialization, &cell, sizeof cell);
}

void HexStateSpace::deserialize(ob::State *state, const void *serialization) const
{
    HexCoord cell;
    std::memcpy(&cell, serialization, sizeof cell);
    cast(state)->setCell(cell);
}

void HexStateSpace::computeSignature(std::vector<int> &signature) const
{
    ob::StateSpace::computeSignature(signature);
    append(signature, lattice_.columns());
    append(signature, lattice_.rows());
    append(signature, lattice_.pitch());
    append(signature, lattice_.northWest().x());
    append(signature, lattice_.northWest().y());
    signature.front() = static_cast<int>(signature.size()) - 1;
}

void HexStateSpace::copyToReals(std::vector<double> &reals, const ob::State *source) const
{
    const Point p = lattice_.centre(cellOf(source));
    reals = {p.x(), p.y()};
}

void HexStateSpace::copyFromReals(ob::State *destination, const std::vector<double> &reals) const
{
    if (reals.size() != 2)
        throw ompl::Exception(getName(), "a position is two reals, not " + std::to_string(reals.size()));
    cast(destination)->setCell(lattice_.cellAt({reals[0], reals[1]}));
}

void HexStateSpace::registerProjections()
{
    registerDefaultProjection(std::make_shared<HexStateProjection>(this));
}

void HexStateSpace::printState(const ob::State *state, std::ostream &out) const
{
    const OffsetCoord offset = toOffset(cellOf(state));
    const Point p = lattice_.centre(cellOf(state));
    out << "HexState [column " << offset.column << ", row " << offset.row << ", centre " << p.x() << ' ' << p.y()
        << "]\n";
}

void HexStateSpace::printSettings(std::ostream &out) const
{
    out << "Hexagonal lattice state space '" << getName() << "' of " << lattice_.columns() << " x " << lattice_.rows()
        << " cells, pitch " << lattice_.pitch() << ", north-west corner " << lattice_.northWest().x() << ' '
        << lattice_.northWest().y() << '\n';
    printProjections(out);
}

void HexStateSpace::sanityChecks() const
{
    sanityChecks(std::numeric_limits<double>::epsilon(), std::numeric_limits<float>::epsilon(),
                 STATESPACE_DISTANCE_DIFFERENT_STATES | STATESPACE_DISTANCE_SYMMETRIC | STATESPACE_DISTANCE_BOUND |
                     STATESPACE_RESPECT_BOUNDS | STATESPACE_ENFORCE_BOUNDS_NO_OP | STATESPACE_SERIALIZATION);
}

}  // namespace seahex
