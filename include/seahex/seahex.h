#pragma once

/// @file Everything that the README's programs need: chart to occupancy to OMPL problem to route, seabed to dive.

#include <seahex/chart/CableCrossing.h>
#include <seahex/chart/ChartArena.h>
#include <seahex/chart/ChartBathymetry.h>
#include <seahex/chart/ChartError.h>
#include <seahex/chart/ChartReader.h>
#include <seahex/chart/WrittenRouteCheck.h>
#include <seahex/io/BathymetryReader.h>
#include <seahex/io/GeoJson.h>
#include <seahex/io/GeoRoute.h>
#include <seahex/io/Picture.h>
#include <seahex/io/PositionParser.h>
#include <seahex/planning/DiveSetup.h>
#include <seahex/planning/HexAStar.h>
#include <seahex/planning/LatticeLengthObjective.h>
#include <seahex/planning/OccupancyMotionValidator.h>
#include <seahex/planning/OccupancyValidityChecker.h>
#include <seahex/planning/RouteFromPath.h>
#include <seahex/planning/Setup.h>
#include <seahex/planning/SquareAStar.h>
#include <seahex/route/RouteMetrics.h>
#include <seahex/route/RouteSmoother.h>
