#include "EdgeDensifier.h"

#include "seahex/geometry/SegmentDistance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace seahex
{
namespace
{

constexpr double EARTH_RADIUS_M = 6.37e6;
constexpr double RADIANS_PER_DEGREE = 0.017453292519943295;
constexpr double LEAST_TOLERANCE_M = 1e-3;

/// The largest deviation between two quarter points exceeds theirs by a few per cent; this leaves it room.
constexpr double SAMPLE_SHARE = 0.8;

/// Longer pieces are bisected unseen, so that no wave of the curve can pass between its samples.
constexpr double LONGEST_PIECE_M = 100e3;

constexpr int SAMPLES = 3;
constexpr int MOST_BISECTIONS = 30;

// Where the bound on curvature below is known to hold.
constexpr double BOUNDED_LATITUDE_DEG = 80.0;
constexpr double BOUNDED_LONGITUDE_DEG = 20.0;

Point middle(const Point &a, const Point &b)
{
    return 0.5 * (a + b);
}

bool isBefore(const Point &a, const Point &b)
{
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

}  // namespace

/// An edge that may bend, from its smaller end to its larger one.
struct EdgeDensifier::Edge
{
    std::size_t path;
    std::size_t end;  ///< index of its last point on the path
    bool reversed;    ///< the path runs from the larger end to the smaller one
    Point geoA, geoB;
    Point a, b;
    std::vector<std::pair<double, Point>> corners;  ///< share of the edge, image
};

/// A part of an edge that is still to be looked at.
struct EdgeDensifier::Piece
{
    Edge *edge;
    double from, to;  ///< shares of the edge
    Point geoA, geoB;
    Point a, b;
};

EdgeDensifier::EdgeDensifier(ProjectPoints project, double toleranceM, double centreLongitudeDeg)
    : project_(std::move(project)), toleranceM_(std::max(LEAST_TOLERANCE_M, toleranceM)),
      centreLongitudeDeg_(centreLongitudeDeg)
{
}

/// Most edges of a chart are too short to bend. A line straight in longitude and latitude curves on the sphere by at
/// most 2 tan(latitude) / R, and a transverse Mercator adds at most (offset from its meridian) / R^2; within 80 degrees
/// of latitude and 20 of longitude, 4 (1 + tan(latitude)) / R lies well above the sum. A curve of length s and
/// curvature k departs from its chord by k s^2 / 8.
bool EdgeDensifier::needsLook(const Point &geoA, const Point &geoB, const Point &a, const Point &b) const
{
    const double latitudeDeg = std::max(std::abs(geoA.y()), std::abs(geoB.y()));
    const double offsetDeg =
        std::max(std::abs(geoA.x() - centreLongitudeDeg_), std::abs(geoB.x() - centreLongitudeDeg_));
    if (!(latitudeDeg < BOUNDED_LATITUDE_DEG && offsetDeg < BOUNDED_LONGITUDE_DEG))
        return geoA != geoB;
    const double curvature = 4.0 * (1.0 + std::tan(latitudeDeg * RADIANS_PER_DEGREE)) / EARTH_RADIUS_M;
    return curvature * (b - a).squaredNorm() / 8.0 > SAMPLE_SHARE * toleranceM_;
}

bool EdgeDensifier::isStraightEnough(const Piece &piece, const Point *samples) const
{
    if ((piece.b - piece.a).norm() > LONGEST_PIECE_M)
        return false;
    return std::all_of(samples, samples + SAMPLES,
                       [&](const Point &sample)
                       { return distanceToSegment(sample, piece.a, piece.b) <= SAMPLE_SHARE * toleranceM_; });
}

/// Bisects level by level, all pieces of a level in one call of the projection.
void EdgeDensifier::bend(std::vector<Edge> &edges) const
{
    std::vector<Piece> pieces;
    pieces.reserve(edges.size());
    for (Edge &edge : edges)
        pieces.push_back({&edge, 0.0, 1.0, edge.geoA, edge.geoB, edge.a, edge.b});

    for (int level = 0; level < MOST_BISECTIONS && !pieces.empty(); ++level)
    {
        std::vector<Point> samples;
        samples.reserve(SAMPLES * pieces.size());
        for (const Piece &piece : pieces)
        {
            const Point half = middle(piece.geoA, piece.geoB);
            samples.insert(samples.end(), {middle(piece.geoA, half), half, middle(half, piece.geoB)});
        }
        project_(samples);

        std::vector<Piece> halves;
        for (std::size_t i = 0; i < pieces.size(); ++i)
        {
            const Piece &piece = pieces[i];
            if (isStraightEnough(piece, &samples[SAMPLES * i]))
                continue;
            const Point geoHalf = middle(piece.geoA, piece.geoB);
            const Point half = samples[SAMPLES * i + 1];
            const double share = 0.5 * (piece.from + piece.to);
            piece.edge->corners.emplace_back(share, half);
            halves.push_back({piece.edge, piece.from, share, piece.geoA, geoHalf, piece.a, half});
            halves.push_back({piece.edge, share, piece.to, geoHalf, piece.geoB, half, piece.b});
        }
        pieces = std::move(halves);
    }

    for (Edge &edge : edges)
        std::sort(edge.corners.begin(), edge.corners.end(),
                  [](const auto &left, const auto &right) { return left.first < right.first; });
}

std::vector<std::vector<Point>> EdgeDensifier::project(const std::vector<std::vector<Point>> &paths) const
{
    std::vector<Point> all;
    for (const std::vector<Point> &path : paths)
        all.insert(all.end(), path.begin(), path.end());
    project_(all);

    std::vector<Edge> edges;
    std::size_t base = 0;
    for (std::size_t path = 0; path < paths.size(); base += paths[path++].size())
    {
        const std::vector<Point> &geo = paths[path];
        for (std::size_t i = 1; i < geo.size(); ++i)
        {
            const Point &a = all[base + i - 1];
            const Point &b = all[base + i];
            if (!needsLook(geo[i - 1], geo[i], a, b))
                continue;
            if (isBefore(geo[i], geo[i - 1]))
                edges.push_back({path, i, true, geo[i], geo[i - 1], b, a, {}});
            else
                edges.push_back({path, i, false, geo[i - 1], geo[i], a, b, {}});
        }
    }
    bend(edges);

    std::vector<std::vector<Point>> images(paths.size());
    auto edge = edges.cbegin();
    base = 0;
    for (std::size_t path = 0; path < paths.size(); base += paths[path++].size())
    {
        std::vector<Point> &image = images[path];
        image.reserve(paths[path].size());
        for (std::size_t i = 0; i < paths[path].size(); ++i)
        {
            if (edge != edges.cend() && edge->path == path && edge->end == i)
            {
                const auto add = [&image](const auto &corner)
                {
                    image.push_back(corner.second);
                };
                if (edge->reversed)
                    std::for_each(edge->corners.crbegin(), edge->corners.crend(), add);
                else
                    std::for_each(edge->corners.cbegin(), edge->corners.cend(), add);
                ++edge;
            }
            image.push_back(all[base + i]);
        }
    }
    return images;
}

}  // namespace seahex
