#include "seahex/chart/Chart.h"

namespace seahex
{

GeoPoint GeoBox::centre() const
{
    return GeoPoint::fromLonLat(0.5 * (westDeg + eastDeg), 0.5 * (southDeg + northDeg));
}

bool GeoBox::contains(const GeoPoint &position) const
{
    return position.longitudeDeg() >= westDeg && position.longitudeDeg() <= eastDeg &&
           position.latitudeDeg() >= southDeg && position.latitudeDeg() <= northDeg;
}

}  // namespace seahex
