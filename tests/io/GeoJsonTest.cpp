#include "seahex/io/GeoJson.h"

#include "support/AsciiWorld.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <ogrsf_frmts.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace seahex
{

namespace
{

namespace fs = std::filesystem;
using nlohmann::json;

class GeoJson : public testing::Test
{
protected:
    GeoJson() : folder_(fs::temp_directory_path() / ("seahex-geojson-" + std::to_string(std::random_device{}())))
    {
        fs::create_directory(folder_);
    }
    ~GeoJson() override { fs::remove_all(folder_); }

    std::string path(const std::string &name = "route.geojson") const { return (folder_ / name).string(); }

    std::set<std::string> files() const
    {
        std::set<std::string> names;
        for (const fs::directory_entry &entry : fs::directory_iterator(folder_))
            names.insert(entry.path().filename().string());
        return names;
    }

    static std::string textOf(const std::string &file)
    {
        std::ifstream in(file, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }

    json written(const RouteFileContent &content) const
    {
        writeGeoJson(path(), content);
        return json::parse(textOf(path()));
    }

    static std::string refusal(const std::string &file, const RouteFileContent &content)
    {
        try
        {
            writeGeoJson(file, content);
            return "";
        }
        catch (const WriteError &error)
        {
            return error.what();
        }
    }

private:
    fs::path folder_;
};

std::vector<json> ofKind(const json &collection, const std::string &kind)
{
    std::vector<json> found;
    for (const json &feature : collection.at("features"))
        if (feature.at("properties").at("kind") == kind)
            found.push_back(feature);
    return found;
}

json lonLat(const GeoPoint &p)
{
    return json::array({p.longitudeDeg(), p.latitudeDeg()});
}

json lonLats(const GeoRoute &route)
{
    json list = json::array();
    for (const GeoPoint &p : route.waypoints)
        list.push_back(lonLat(p));
    return list;
}

double signedArea(const json &ring)
{
    double twice = 0.0;
    for (std::size_t i = 1; i < ring.size(); ++i)
        twice += (ring[i - 1][0].get<double>() - ring[0][0].get<double>()) * ring[i][1].get<double>() -
                 (ring[i][0].get<double>() - ring[0][0].get<double>()) * ring[i - 1][1].get<double>();
    return twice / 2.0;
}

const GeoRoute bostonRoute{{GeoPoint::fromLatLon(42.1234567, -70.7654321), GeoPoint::fromLatLon(42.2, -70.8),
                            GeoPoint::fromLatLon(42.2, -70.7), GeoPoint::fromLatLon(42.15, -70.7)}};

RouteFileContent contentOf(const GeoRoute &route)
{
    RouteFileContent content;
    content.route = &route;
    return content;
}

}  // namespace

TEST_F(GeoJson, RouteHasItsCoordinatesNumbersAndTexts)
{
    RouteFileContent content = contentOf(bostonRoute);
    content.numbers = {
        {"length_m", 12345.678}, {"turns", 2.0}, {"min_clearance_m", std::numeric_limits<double>::infinity()}};
    content.texts = {{"planner", "HexAStar"}, {"chart", "Bay \"of\" Fundy \u00e9\\"}};
    const json file = written(content);

    EXPECT_EQ(file.at("type"), "FeatureCollection");
    EXPECT_EQ(file.count("crs"), 0U);  // RFC 7946 knows WGS-84 only
    ASSERT_EQ(ofKind(file, "route").size(), 1U);
    const json route = ofKind(file, "route").front();
    EXPECT_EQ(route.at("geometry").at("type"), "LineString");
    EXPECT_EQ(route.at("geometry").at("coordinates"), lonLats(bostonRoute));
    EXPECT_EQ(route.at("properties"), json({{"kind", "route"},
                                            {"length_m", 12345.678},
                                            {"turns", 2.0},
                                            {"min_clearance_m", nullptr},
                                            {"planner", "HexAStar"},
                                            {"chart", "Bay \"of\" Fundy \u00e9\\"}}));
    EXPECT_EQ(files(), std::set<std::string>{"route.geojson"});
}

TEST_F(GeoJson, WaypointsHaveIndexCourseAndLength)
{
    const std::vector<json> waypoints = ofKind(written(contentOf(bostonRoute)), "waypoint");
    ASSERT_EQ(waypoints.size(), bostonRoute.waypoints.size());
    for (std::size_t i = 0; i < waypoints.size(); ++i)
    {
        EXPECT_EQ(waypoints[i].at("geometry").at("type"), "Point");
        EXPECT_EQ(waypoints[i].at("geometry").at("coordinates"), lonLat(bostonRoute.waypoints[i]));
        EXPECT_EQ(waypoints[i].at("properties").at("index"), i + 1);
    }
    const json eastward = waypoints[1].at("properties");
    EXPECT_NEAR(eastward.at("course_deg").get<double>(), 90.0, 0.001);
    EXPECT_NEAR(eastward.at("leg_length_m").get<double>(), 8258.6, 5.0);  // 0.1 degrees along the parallel of 42.2
    const json southward = waypoints[2].at("properties");
    EXPECT_NEAR(southward.at("course_deg").get<double>(), 180.0, 0.001);
    EXPECT_NEAR(southward.at("leg_length_m").get<double>(), 5553.8, 2.0);  // 3 minutes of latitude
    EXPECT_EQ(waypoints[3].at("properties"), json({{"kind", "waypoint"}, {"index", 4}}));
}

TEST_F(GeoJson, LegsAddUpToTheRoute)
{
    double sum = 0.0;
    for (const json &waypoint : ofKind(written(contentOf(bostonRoute)), "waypoint"))
        sum += waypoint.at("properties").value("leg_length_m", 0.0);
    EXPECT_NEAR(sum, rhumbLengthM(bostonRoute), 0.001 * 3);
}

TEST_F(GeoJson, RoundsToSevenDecimals)
{
    const GeoRoute route{{GeoPoint::fromLatLon(42.123456789, 289.87654321), GeoPoint::fromLatLon(42.2, -70.0)}};
    const json file = written(contentOf(route));
    const json expected = json::array({-70.1234568, 42.1234568});
    EXPECT_EQ(ofKind(file, "route").front().at("geometry").at("coordinates").at(0), expected);
    EXPECT_EQ(ofKind(file, "waypoint").front().at("geometry").at("coordinates"), expected);
}

TEST_F(GeoJson, ReadsBackThroughGdal)
{
    const test::AsciiWorld world(R"(
         . # .
        . . #
    )",
                                 100.0);
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(42.2, -70.8));
    const GeoRoute raw{{bostonRoute.waypoints.front(), bostonRoute.waypoints.back()}};
    RouteFileContent content = contentOf(bostonRoute);
    content.rawPath = &raw;
    content.blocked = &world.occupancy();
    content.projection = &projection;
    writeGeoJson(path(), content);

    GDALAllRegister();
    const std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(path().c_str(), GDAL_OF_VECTOR));
    ASSERT_NE(dataset, nullptr);
    OGRLayer *layer = dataset->GetLayer(0);
    std::map<std::string, int> count;
    for (const auto &feature : *layer)
    {
        const std::string kind = feature->GetFieldAsString("kind");
        ++count[kind];
        const OGRGeometry *geometry = feature->GetGeometryRef();
        ASSERT_NE(geometry, nullptr);
        EXPECT_TRUE(geometry->IsValid());
        if (kind != "route" && kind != "raw_path")
            continue;
        const std::vector<GeoPoint> &expected = (kind == "route" ? bostonRoute : raw).waypoints;
        const OGRLineString *line = geometry->toLineString();
        ASSERT_EQ(line->getNumPoints(), static_cast<int>(expected.size()));
        for (int i = 0; i < line->getNumPoints(); ++i)
        {
            EXPECT_EQ(line->getX(i), expected[static_cast<std::size_t>(i)].longitudeDeg());
            EXPECT_EQ(line->getY(i), expected[static_cast<std::size_t>(i)].latitudeDeg());
        }
    }
    EXPECT_EQ(count, (std::map<std::string, int>{{"route", 1}, {"waypoint", 4}, {"raw_path", 1}, {"blocked_cell", 2}}));
}

TEST_F(GeoJson, BlockedCellsAreTheCellsOfTheRectangle)
{
    const test::AsciiWorld world(R"(
         . # . .
        # . . .
         . . . #
    )",
                                 50.0, Point(-80.0, 60.0));
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(-33.9, 151.2));
    RouteFileContent content;
    content.blocked = &world.occupancy();
    content.projection = &projection;
    const json file = written(content);

    std::set<HexCoord> found;
    for (const json &feature : ofKind(file, "blocked_cell"))
    {
        const json &properties = feature.at("properties");
        EXPECT_EQ(properties.size(), 4U) << properties;
        const HexCoord cell{properties.at("q"), properties.at("s")};
        EXPECT_EQ(properties.at("r"), cell.r());
        EXPECT_TRUE(found.insert(cell).second) << properties;

        ASSERT_EQ(feature.at("geometry").at("type"), "Polygon");
        ASSERT_EQ(feature.at("geometry").at("coordinates").size(), 1U);
        const json &ring = feature.at("geometry").at("coordinates").at(0);
        ASSERT_EQ(ring.size(), 7U);
        EXPECT_EQ(ring.front(), ring.back());
        EXPECT_GT(signedArea(ring), 0.0) << "RFC 7946 wants outer rings counter-clockwise";
        for (const json &corner : ring)
        {
            const Point image = projection.forward(GeoPoint::fromLonLat(corner.at(0), corner.at(1)));
            EXPECT_NEAR((image - world.lattice().centre(cell)).norm(), world.lattice().side(), 0.02);
        }
    }
    EXPECT_EQ(found, (std::set<HexCoord>{toCube({1, 0}), toCube({0, 1}), toCube({3, 2})}));
    EXPECT_EQ(file.at("features").size(), 3U) << "no route, no waypoints";
}

TEST_F(GeoJson, BlockedSquaresAreNamedByColumnAndRow)
{
    const SquareLattice lattice(Point(-80.0, 60.0), 50.0, 4, 3);
    const std::set<OffsetCoord> blocked{{1, 0}, {0, 1}, {3, 2}};
    const CellLayout layout(4, 3);
    std::vector<std::uint64_t> words(layout.wordCount(), ~std::uint64_t{0});
    for (std::int64_t row = 0; row < 3; ++row)
        for (std::int64_t column = 0; column < 4; ++column)
            if (const CellIndex i = layout.index(OffsetCoord{column, row}); blocked.count({column, row}) == 0)
                words[i >> 6] &= ~(std::uint64_t{1} << (i & 63));
    const SquareOccupancy occupancy(lattice, layout, std::move(words));
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(-33.9, 151.2));
    RouteFileContent content;
    content.blocked = &occupancy;
    content.projection = &projection;

    std::set<OffsetCoord> found;
    for (const json &feature : ofKind(written(content), "blocked_cell"))
    {
        const json &properties = feature.at("properties");
        EXPECT_EQ(properties.size(), 3U) << properties;
        const OffsetCoord cell{properties.at("column"), properties.at("row")};
        EXPECT_TRUE(found.insert(cell).second) << properties;
        const json &ring = feature.at("geometry").at("coordinates").at(0);
        ASSERT_EQ(ring.size(), 5U);
        EXPECT_GT(signedArea(ring), 0.0) << "RFC 7946 wants outer rings counter-clockwise";
        const Point middle(-80.0 + 50.0 * (0.5 + static_cast<double>(cell.column)),
                           60.0 - 50.0 * (0.5 + static_cast<double>(cell.row)));
        for (const json &corner : ring)
        {
            const Point image = projection.forward(GeoPoint::fromLonLat(corner.at(0), corner.at(1)));
            EXPECT_NEAR(std::abs(image.x() - middle.x()), 25.0, 0.02);
            EXPECT_NEAR(std::abs(image.y() - middle.y()), 25.0, 0.02);
        }
    }
    EXPECT_EQ(found, blocked);
}

TEST_F(GeoJson, LinesAcrossTheAntimeridianAreCut)
{
    const GeoRoute route{{GeoPoint::fromLatLon(10.0, 179.5), GeoPoint::fromLatLon(11.0, -179.5),
                          GeoPoint::fromLatLon(12.0, 179.5), GeoPoint::fromLatLon(12.0, 179.25)}};
    const json geometry = ofKind(written(contentOf(route)), "route").front().at("geometry");
    EXPECT_EQ(geometry.at("type"), "MultiLineString");
    EXPECT_EQ(geometry.at("coordinates"), json::parse(R"([[[179.5, 10.0], [180.0, 10.5]],
                                                          [[-180.0, 10.5], [-179.5, 11.0], [-180.0, 11.5]],
                                                          [[180.0, 11.5], [179.5, 12.0], [179.25, 12.0]]])"));
}

TEST_F(GeoJson, LinesThatEndOnTheAntimeridianAreNotCut)
{
    const auto coordinates = [this](const std::vector<GeoPoint> &waypoints)
    {
        const GeoRoute route{waypoints};
        const json geometry = ofKind(written(contentOf(route)), "route").front().at("geometry");
        EXPECT_EQ(geometry.at("type"), "LineString");
        return geometry.at("coordinates");
    };
    const GeoPoint border = GeoPoint::fromLatLon(10.0, 180.0);
    EXPECT_EQ(coordinates({border, GeoPoint::fromLatLon(10.0, 179.0)}), json::parse("[[180.0, 10.0], [179.0, 10.0]]"));
    EXPECT_EQ(coordinates({border, GeoPoint::fromLatLon(10.0, -179.0)}),
              json::parse("[[-180.0, 10.0], [-179.0, 10.0]]"));
    EXPECT_EQ(coordinates({GeoPoint::fromLatLon(10.0, 179.0), border}), json::parse("[[179.0, 10.0], [180.0, 10.0]]"));
    EXPECT_EQ(coordinates({GeoPoint::fromLatLon(9.0, -150.0), GeoPoint::fromLatLon(9.0, 0.0),
                           GeoPoint::fromLatLon(9.0, 150.0)}),
              json::parse("[[-150.0, 9.0], [0.0, 9.0], [150.0, 9.0]]"));
}

TEST_F(GeoJson, CellsAcrossTheAntimeridianAreCut)
{
    const test::AsciiWorld world(R"(
         # # #
        # # #
    )",
                                 1000.0, Point(-1700.0, 800.0));
    for (const double centre : {180.0, -180.0})
    {
        const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(60.0, centre));
        RouteFileContent content;
        content.blocked = &world.occupancy();
        content.projection = &projection;
        const std::vector<json> cells = ofKind(written(content), "blocked_cell");
        ASSERT_EQ(cells.size(), 6U);
        std::map<std::string, int> types;
        double area = 0.0;
        for (const json &cell : cells)
        {
            const json &geometry = cell.at("geometry");
            ++types[geometry.at("type")];
            const json polygons = geometry.at("type") == "Polygon" ? json::array({geometry.at("coordinates")})
                                                                   : geometry.at("coordinates");
            for (const json &polygon : polygons)
            {
                EXPECT_LT(std::abs(signedArea(polygon.at(0))), 0.001)
                    << "a cell spans 0.02 x 0.01 degrees: " << polygon;
                area += std::abs(signedArea(polygon.at(0)));
                for (const json &corner : polygon.at(0))
                    EXPECT_LE(std::abs(corner.at(0).get<double>()), 180.0);
            }
        }
        EXPECT_GT(types["MultiPolygon"], 0);
        EXPECT_GT(types["Polygon"], 0);
        const double cellM2 = 1.5 * world.lattice().side() * world.lattice().pitch();
        EXPECT_NEAR(area, 6.0 * cellM2 / (111412.0 * 55800.0), 0.002 * area);
    }
}

TEST_F(GeoJson, TwoEqualWaypointsAreALine)
{
    const GeoRoute route{{GeoPoint::fromLatLon(10.0, 20.0), GeoPoint::fromLatLon(10.0, 20.0)}};
    const json file = written(contentOf(route));
    EXPECT_EQ(ofKind(file, "route").front().at("geometry").at("coordinates"),
              json::parse("[[20.0, 10.0], [20.0, 10.0]]"));
    EXPECT_EQ(ofKind(file, "waypoint").front().at("properties"),
              json({{"kind", "waypoint"}, {"index", 1}, {"leg_length_m", 0.0}}));
}

TEST_F(GeoJson, RefusesWhatCanNotBeAFile)
{
    const Projection projection = Projection::plateCarree();
    const test::AsciiWorld beyondThePole("# .", 1.0, Point(0.0, 91.0));
    RouteFileContent content = contentOf(bostonRoute);
    content.numbers = {{"kind", 1.0}};
    EXPECT_NE(refusal(path(), content).find("\"kind\""), std::string::npos);
    content.numbers = {{"length", 1.0}};
    content.texts = {{"length", "long"}};
    EXPECT_NE(refusal(path(), content).find("\"length\""), std::string::npos);

    const GeoRoute one{{bostonRoute.waypoints.front()}};
    EXPECT_NE(refusal(path(), contentOf(one)).find("1 waypoints"), std::string::npos);

    content = {};
    content.blocked = &beyondThePole.occupancy();
    EXPECT_NE(refusal(path(), content).find("projection"), std::string::npos);
    content.projection = &projection;
    EXPECT_NE(refusal(path(), content).find("pole"), std::string::npos);
    EXPECT_EQ(files(), std::set<std::string>{}) << "nothing remains of a refused file";
}

TEST_F(GeoJson, NamesTheFileThatCanNotBeWritten)
{
    const RouteFileContent content = contentOf(bostonRoute);
    const std::string missing = path("no-folder/route.geojson");
    EXPECT_EQ(refusal(missing, content), "can't write " + missing + ": No such file or directory");

    std::ofstream(path("file")) << "text";
    const std::string inFile = path("file/route.geojson");
    EXPECT_EQ(refusal(inFile, content), "can't write " + inFile + ": Not a directory");

    fs::create_directories(path("folder/inner"));
    EXPECT_EQ(refusal(path("folder"), content), "can't write " + path("folder") + ": Is a directory");
    EXPECT_EQ(files(), (std::set<std::string>{"file", "folder"}));
}

TEST_F(GeoJson, ReplacesAFileOnlyByAWholeOne)
{
    std::ofstream(path()) << "before";
    const GeoRoute one{{bostonRoute.waypoints.front()}};
    EXPECT_NE(refusal(path(), contentOf(one)), "");
    EXPECT_EQ(textOf(path()), "before");

    // a disk that runs full, as seen by this process: no file may grow beyond 2000 bytes
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit small{2000, limit.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    GeoRoute longRoute;
    for (int i = 0; i < 100; ++i)
        longRoute.waypoints.push_back(GeoPoint::fromLatLon(10.0, 0.1 * i));
    const std::string message = refusal(path(), contentOf(longRoute));
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, handler);

    EXPECT_NE(message, "");
    EXPECT_EQ(textOf(path()), "before");
    EXPECT_EQ(files(), std::set<std::string>{"route.geojson"});

    EXPECT_EQ(written(contentOf(longRoute)).at("features").size(), 101U);
}

TEST_F(GeoJson, DriverMessagesAreNotPrinted)
{
    testing::internal::CaptureStderr();
    written(contentOf(bostonRoute));
    refusal(path("no-folder/route.geojson"), contentOf(bostonRoute));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace seahex
