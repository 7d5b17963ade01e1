#include "Claims.h"

#include <algorithm>

namespace reproduce_papers
{
namespace
{

using Side = Claim::Side;

double turns(const Measured &measured)
{
    return measured.metrics.turns;
}

double angle(const Measured &measured)
{
    return measured.metrics.turnAngleRad;
}

double hazards(const Measured &measured)
{
    return static_cast<double>(measured.metrics.potentialHazards);
}

double shortestKnown(const Trial &t)
{
    return std::min({t.pulledHex6.lengthW, t.pulledHex36.lengthW, t.pulledSquare8.lengthW});
}

/// Shares of one are shares of nothing where there is nothing.
double ratio(double a, double b)
{
    return b == 0.0 ? (a == 0.0 ? 1.0 : 2.0) : a / b;
}

}  // namespace

const std::vector<Claim> &claims()
{
    static const std::vector<Claim> all = {
        {"hex_visits_fewer", "[Cheng2020] table 2", "hex 6 / square 8: cells expanded, equal spacing", 1.0, Side::Less,
         0.7207,
         [](const Trial &t)
         {
             return ratio(t.hex6.expanded, t.square8.expanded);
         }},
        {"hex_visits_fewer_of_area", "[Cheng2020] table 2", "the same, equal area", 1.0, Side::Less, 0.7207,
         [](const Trial &t)
         {
             return ratio(t.hex6.expanded, t.square8OfArea.expanded);
         }},
        {"hex_visits_fewer_guided", "[Cheng2020] table 2", "the same, equal spacing, both with the paper's guide", 1.0,
         Side::Less, 0.7207,
         [](const Trial &t)
         {
             return ratio(t.guidedHex6.expanded, t.guidedSquare8.expanded);
         }},
        {"hex_is_longer", "[Cheng2020] table 2", "hex 6 / square 8: length", 1.0, Side::More, 146.0 / 142.74,
         [](const Trial &t)
         {
             return ratio(t.hex6.path.lengthW, t.square8.path.lengthW);
         }},
        {"hex_turns_more", "[Cheng2020] table 2", "hex 6 - square 8: turns", 0.0, Side::More, 2.0,
         [](const Trial &t)
         {
             return turns(t.hex6.path) - turns(t.square8.path);
         }},
        {"hex_turns_wider", "[Cheng2020] table 2", "hex 6 / square 8: sum of turn angles", 1.0, Side::More,
         1620.0 / 1080.0,
         [](const Trial &t)
         {
             return ratio(angle(t.hex6.path), angle(t.square8.path));
         }},
        {"rings_2_shorten", "[Cheng2020] table 3", "hex 18 / hex 6: length", 1.0, Side::Less, 145.0 / 146.0,
         [](const Trial &t)
         {
             return ratio(t.hex18.path.lengthW, t.hex6.path.lengthW);
         }},
        {"rings_3_shorten", "[Cheng2020] table 3", "hex 36 / hex 18: length", 1.0, Side::Less, 144.0 / 145.0,
         [](const Trial &t)
         {
             return ratio(t.hex36.path.lengthW, t.hex18.path.lengthW);
         }},
        {"rings_2_turn_less", "[Cheng2020] table 3", "hex 18 - hex 6: turns", 0.0, Side::Less, -12.0,
         [](const Trial &t)
         {
             return turns(t.hex18.path) - turns(t.hex6.path);
         }},
        {"rings_3_turn_less", "[Cheng2020] table 3", "hex 36 - hex 18: turns", 0.0, Side::Less, -2.0,
         [](const Trial &t)
         {
             return turns(t.hex36.path) - turns(t.hex18.path);
         }},
        {"rings_2_straighten", "[Cheng2020] table 3", "hex 18 / hex 6: sum of turn angles", 1.0, Side::Less,
         480.0 / 1620.0,
         [](const Trial &t)
         {
             return ratio(angle(t.hex18.path), angle(t.hex6.path));
         }},
        {"rings_3_straighten", "[Cheng2020] table 3", "hex 36 / hex 18: sum of turn angles", 1.0, Side::Less,
         435.0 / 480.0,
         [](const Trial &t)
         {
             return ratio(angle(t.hex36.path), angle(t.hex18.path));
         }},
        {"published_rings_2_turn_less", "[Cheng2020] table 3", "all as published, hex 18 - hex 6: turns", 0.0,
         Side::Less, -12.0,
         [](const Trial &t)
         {
             return turns(t.publishedHex18.path) - turns(t.publishedHex6.path);
         }},
        {"published_rings_3_turn_less", "[Cheng2020] table 3", "all as published, hex 36 - hex 6: turns", 0.0,
         Side::Less, -14.0,
         [](const Trial &t)
         {
             return turns(t.publishedHex36.path) - turns(t.publishedHex6.path);
         }},
        {"published_rings_2_straighten", "[Cheng2020] table 3", "all as published, hex 18 / hex 6: sum of turn angles",
         1.0, Side::Less, 480.0 / 1620.0,
         [](const Trial &t)
         {
             return ratio(angle(t.publishedHex18.path), angle(t.publishedHex6.path));
         }},
        {"published_rings_3_straighten", "[Cheng2020] table 3", "all as published, hex 36 / hex 18: sum of turn angles",
         1.0, Side::Less, 435.0 / 480.0,
         [](const Trial &t)
         {
             return ratio(angle(t.publishedHex36.path), angle(t.publishedHex18.path));
         }},
        {"rings_take_time", "[Cheng2020] table 3", "hex 36 / hex 6: search time", 1.0, Side::More, 4.62 / 1.40,
         [](const Trial &t)
         {
             return ratio(t.hex36.searchMs, t.hex6.searchMs);
         }},
        {"hex_18_beats_square", "[Cheng2020] table 3", "hex 18 / square 8: sum of turn angles", 1.0, Side::Less,
         480.0 / 1080.0,
         [](const Trial &t)
         {
             return ratio(angle(t.hex18.path), angle(t.square8.path));
         }},
        {"guide_saves",
         "[Cheng2020] text",
         "hex 6, the paper's guide / exact distance: cells expanded",
         1.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return ratio(t.guidedHex6.expanded, t.hex6.expanded);
         }},
        {"hopping_shortens",
         "[Cheng2020] text",
         "hex 36, hopping / safe jumps: length in steps",
         1.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return ratio(t.hoppingHex36.path.stepsW, t.stepsHex36.path.stepsW);
         }},
        {"a_star_saves", "[Wang2017] table 1", "A* / Dijkstra: nodes traversed", 1.0, Side::Less, 1806.0 / 3186.0,
         [](const Trial &t)
         {
             return ratio(t.squares.aStar.expanded, t.squares.dijkstra.expanded);
         }},
        {"improved_costs", "[Wang2017] table 1", "improved A* / A*: nodes traversed", 1.0, Side::More, 2127.0 / 1806.0,
         [](const Trial &t)
         {
             return ratio(t.squares.improved.expanded, t.squares.aStar.expanded);
         }},
        {"improved_saves", "[Wang2017] table 1", "improved A* / Dijkstra: nodes traversed", 1.0, Side::Less,
         2127.0 / 3186.0,
         [](const Trial &t)
         {
             return ratio(t.squares.improved.expanded, t.squares.dijkstra.expanded);
         }},
        {"weights_avoid_hazards",
         "[Wang2017] table 1",
         "improved, not smoothed - A*: potential hazards",
         0.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return hazards(t.squares.improved.path) - hazards(t.squares.aStar.path);
         }},
        {"text_keeps_off", "[Wang2017] table 1", "improved, smoothed as text - A*: potential hazards", 0.0, Side::Less,
         -26.0,
         [](const Trial &t)
         {
             return hazards(t.squares.smoothed) - hazards(t.squares.aStar.path);
         }},
        {"margin_keeps_off", "[Wang2017] table 1", "improved, with margin - A*: potential hazards", 0.0, Side::Less,
         -26.0,
         [](const Trial &t)
         {
             return hazards(t.squares.withMargin) - hazards(t.squares.aStar.path);
         }},
        {"smoothing_drops_nodes", "[Wang2017] table 1", "improved, with margin / A*: route nodes", 1.0, Side::Less,
         11.0 / 97.0,
         [](const Trial &t)
         {
             return ratio(static_cast<double>(t.squares.withMargin.nodes),
                          static_cast<double>(t.squares.aStar.path.nodes));
         }},
        {"smoothing_turns_less", "[Wang2017] table 1", "improved, with margin - A*: turns", 0.0, Side::Less, -25.0,
         [](const Trial &t)
         {
             return turns(t.squares.withMargin) - turns(t.squares.aStar.path);
         }},
        {"smoothing_shortens", "[Wang2017] table 1", "improved, with margin / A*: length", 1.0, Side::Less,
         34.25 / 35.52,
         [](const Trial &t)
         {
             return ratio(t.squares.withMargin.lengthW, t.squares.aStar.path.lengthW);
         }},
        {"hex_weights_avoid_hazards",
         "[Wang2017] on hexagons",
         "improved, not smoothed - A*: potential hazards",
         0.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return hazards(t.hexagons.improved.path) - hazards(t.hexagons.aStar.path);
         }},
        {"hex_margin_keeps_off",
         "[Wang2017] on hexagons",
         "improved, with margin - A*: potential hazards",
         0.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return hazards(t.hexagons.withMargin) - hazards(t.hexagons.aStar.path);
         }},
        {"hex_smoothing_shortens",
         "[Wang2017] on hexagons",
         "improved, with margin / A*: length",
         1.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return ratio(t.hexagons.withMargin.lengthW, t.hexagons.aStar.path.lengthW);
         }},
        {"hex_elongation",
         "this project",
         "hex 6, raw / shortest known: length",
         1.0,
         Side::More,
         {},
         [](const Trial &t)
         {
             return ratio(t.hex6.path.lengthW, shortestKnown(t));
         }},
        {"square_elongation",
         "this project",
         "square 8, raw / shortest known: length",
         1.0,
         Side::More,
         {},
         [](const Trial &t)
         {
             return ratio(t.square8.path.lengthW, shortestKnown(t));
         }},
        {"hex_36_elongation",
         "this project",
         "hex 36, raw / shortest known: length",
         1.0,
         Side::More,
         {},
         [](const Trial &t)
         {
             return ratio(t.hex36.path.lengthW, shortestKnown(t));
         }},
        {"relaxed_saves",
         "this project",
         "hex 6, guide relaxed / exact distance: cells expanded",
         1.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return ratio(t.relaxedHex6.expanded, t.hex6.expanded);
         }},
        {"relaxed_saves_36",
         "this project",
         "hex 36, guide relaxed / exact distance: cells expanded",
         1.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return ratio(t.relaxedHex36.expanded, t.hex36.expanded);
         }},
        {"relaxed_saves_time",
         "this project",
         "hex 36, guide relaxed / exact distance: search time",
         1.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return ratio(t.relaxedHex36.searchMs, t.hex36.searchMs);
         }},
        {"relaxed_is_as_short",
         "this project",
         "hex 36, guide relaxed / exact distance: length, less 1e-9",
         1.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return ratio(t.relaxedHex36.path.lengthW, t.hex36.path.lengthW) - 1e-9;
         }},
        {"turns_found",
         "this project",
         "hex 6, turns priced, as short - ring expansion alone: turns",
         0.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return static_cast<double>(t.turnsHex6.asShort.turns - t.turnsHex6.plain.turns);
         }},
        {"turns_found_36",
         "this project",
         "hex 36, turns priced, as short - ring expansion alone: turns",
         0.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return static_cast<double>(t.turnsHex36.asShort.turns - t.turnsHex36.plain.turns);
         }},
        {"turns_found_2_percent",
         "this project",
         "hex 36, turns priced, up to 2 % longer - ring expansion alone: turns",
         0.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return static_cast<double>(t.turnsHex36.twoPercent.turns - t.turnsHex36.plain.turns);
         }},
        {"turns_take_time",
         "this project",
         "hex 36, turns priced, as short / ring expansion alone: expanded",
         1.0,
         Side::More,
         {},
         [](const Trial &t)
         {
             return ratio(static_cast<double>(t.turnsHex36.asShort.expanded),
                          static_cast<double>(t.turnsHex36.plain.expanded));
         }},
        {"pulled_alike",
         "this project",
         "hex 6 / square 8, strings pulled: length",
         1.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return ratio(t.pulledHex6.lengthW, t.pulledSquare8.lengthW);
         }},
        {"pulling_beats_rings",
         "this project",
         "hex 36, string pulled / raw: length",
         1.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return ratio(t.pulledHex36.lengthW, t.hex36.path.lengthW);
         }},
        {"pulling_shortens_more",
         "this project",
         "improved, string pulled / with margin: length",
         1.0,
         Side::Less,
         {},
         [](const Trial &t)
         {
             return ratio(t.squares.pulled.lengthW, t.squares.withMargin.lengthW);
         }},
    };
    return all;
}

}  // namespace reproduce_papers
