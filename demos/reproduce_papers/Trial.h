#pragma once

#include "Measured.h"
#include "common/Pairs.h"

#include <seahex/route/TurnComparison.h>

#include <optional>

namespace reproduce_papers
{

/// A path by one method, and its numbers.
struct Run
{
    Measured path;
    double expanded = 0.0;
    double searchMs = 0.0;
};

/// All methods that the claims are about, on one pair of start and goal.
struct Trial
{
    // Straight lengths, the exact bound as the guide.
    Run hex6;
    Run hex18;
    Run hex36;
    Run square8;
    Run square8OfArea;
    // The same paths' lengths by this project's guide.
    Run relaxedHex6;
    Run relaxedHex36;
    // The same after the string was pulled.
    Measured pulledHex6;
    Measured pulledHex36;
    Measured pulledSquare8;
    // [Cheng2020]'s guide, and hops.
    Run guidedHex6;
    Run guidedSquare8;
    Run stepsHex36;
    Run hoppingHex36;
    // All as [Cheng2020] has it: steps, its guide.
    Run publishedHex6;
    Run publishedHex18;
    Run publishedHex36;

    /// Ring expansion alone, from centre to centre, against a search that prices turns.
    struct Turns
    {
        seahex::MeasuredPath plain;
        seahex::MeasuredPath asShort;     ///< the fewest turns of the shortest paths
        seahex::MeasuredPath twoPercent;  ///< of those that are up to 2 % longer
    };
    Turns turnsHex6;
    Turns turnsHex36;

    /// [Wang2017] on one kind of cells.
    struct Wang
    {
        Run dijkstra;
        Run aStar;
        Run improved;
        Measured smoothed;    ///< as the text says
        Measured withMargin;  ///< as the program does
        Measured pulled;
    };
    Wang squares;
    Wang hexagons;
};

/// @return empty if one of the methods finds no path: the waters of the lattices differ
std::optional<Trial> runTrial(const Sea &sea, const demos::Pair &pair);

}  // namespace reproduce_papers
