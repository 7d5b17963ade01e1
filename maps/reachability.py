"""How much of a cell's water hangs together, seen coarsely and cautiously.

A picture of the cell, one pixel for each 0.0005 degree (about 50 m): a pixel that anything blocking touches is blocked.
A flood from one position then tells what can be reached by way of the four neighbours of a pixel. The picture is
coarser and blocks more than a route planner would: what hangs together here hangs together there.
"""
from osgeo import gdal, ogr, osr

PIXEL_DEG = 0.0005
REQUIRED_DEPTH_M = 1.7  # draught 1.2 m and 0.5 m under the keel

_ALWAYS_BLOCKED = ("LNDARE", "UNSARE", "SLCONS", "PILPNT", "TSEZNE", "BRIDGE", "CBLOHD",
                   "BCNLAT", "BCNCAR", "BOYLAT", "BOYCAR", "BOYISD", "BOYSPP")
_DEPTH_ATTRIBUTE = {"DEPARE": "DRVAL1", "DRGARE": "DRVAL1", "UWTROC": "VALSOU", "WRECKS": "VALSOU", "OBSTRN": "VALSOU"}
_ENTRY_PROHIBITED = "7"
_MILITARY = "9"


def blocks(feature):
    """Whether a feature closes its place to a small vessel; an unknown depth does."""
    acronym = feature.GetDefnRef().GetName()
    if acronym in _DEPTH_ATTRIBUTE:
        depth_m = feature.GetField(_DEPTH_ATTRIBUTE[acronym])
        return depth_m is None or depth_m < REQUIRED_DEPTH_M
    if acronym == "RESARE":
        return (_ENTRY_PROHIBITED in (feature.GetField("RESTRN") or [])
                or _MILITARY in (feature.GetField("CATREA") or []))
    return acronym in _ALWAYS_BLOCKED


class WaterPicture:
    """Free and blocked pixels of a window (west, east, south, north in degrees)."""

    def __init__(self, features, limits_deg):
        self._west, east, south, self._north = limits_deg
        self.columns = round((east - self._west) / PIXEL_DEG)
        self.rows = round((self._north - south) / PIXEL_DEG)
        system = osr.SpatialReference()
        system.ImportFromEPSG(4326)
        system.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        raster = gdal.GetDriverByName("MEM").Create("", self.columns, self.rows, 1, gdal.GDT_Byte)
        raster.SetSpatialRef(system)
        raster.SetGeoTransform((self._west, PIXEL_DEG, 0.0, self._north, 0.0, -PIXEL_DEG))
        vectors = ogr.GetDriverByName("Memory").CreateDataSource("")
        layer = vectors.CreateLayer("blocked", system)
        for feature in features:
            if blocks(feature):
                copy = ogr.Feature(layer.GetLayerDefn())
                copy.SetGeometry(feature.GetGeometryRef())
                layer.CreateFeature(copy)
        gdal.RasterizeLayer(raster, [1], layer, burn_values=[1], options=["ALL_TOUCHED=TRUE"])
        self._blocked = bytes(raster.ReadRaster())

    def pixel(self, longitude_deg, latitude_deg):
        """The number of the pixel that holds a position, counted row by row from the north-west corner."""
        column = int((longitude_deg - self._west) / PIXEL_DEG)
        row = int((self._north - latitude_deg) / PIXEL_DEG)
        return row * self.columns + column

    def is_free(self, pixel):
        return not self._blocked[pixel]

    def free_count(self):
        return self._blocked.count(0)

    def reached_from(self, pixel):
        """A byte for each pixel: 1 where a flood from a free pixel arrives."""
        reached = bytearray(len(self._blocked))
        reached[pixel] = 1
        waiting = [pixel]
        while waiting:
            here = waiting.pop()
            column = here % self.columns
            neighbours = [here - self.columns, here + self.columns]
            neighbours += [here - 1] if column > 0 else []
            neighbours += [here + 1] if column < self.columns - 1 else []
            for there in neighbours:
                if 0 <= there < len(reached) and not reached[there] and not self._blocked[there]:
                    reached[there] = 1
                    waiting.append(there)
        return reached
