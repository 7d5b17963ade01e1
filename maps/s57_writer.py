"""Writes a cell through GDAL's S-57 driver, spatial records and all.

GDAL writes the records that it is given and no more: the nodes, edges and references come from `topology`, and the
counts in the header (DSSI) are taken from the very lists that are written.
"""
import os
from dataclasses import dataclass

from osgeo import gdal, ogr

from grid import COMF, Window, to_degrees
from topology import (CONNECTED_NODE, EDGE, FORWARD, ISOLATED_NODE, LINE, NOT_RELEVANT, POINT, ChainNodeNetwork,
                      ChartObject, Reference)

SOMF = 10
NO_AGENCY = 65000  # not the number of any producer of charts
BEGIN_NODE, END_NODE = 1, 2  # TOPI
GROUP_ONE, GROUP_TWO = 1, 2  # GRUP


class CellWriteError(RuntimeError):
    """The S-57 driver does not know a class or an attribute, or a text can't be stored."""


@dataclass(frozen=True)
class CellHeader:
    """What the header of a cell says apart from its counts."""

    scale: int
    intended_use: int
    date: str
    comment: str
    edition: int = 1
    update: int = 0
    vertical_datum: int = 17  # mean high water springs
    sounding_datum: int = 23  # lowest astronomical tide


@dataclass
class CellSummary:
    """What was written."""

    features: int
    isolated_nodes: int
    connected_nodes: int
    edges: int
    bytes: int


def write_cell(path, header: CellHeader, window: Window, objects):
    """Writes a cell; an existing file is replaced. Coastlines and depth contours are added along the areas' edges."""
    spatial = [item for item in objects if item.primitive != POINT]
    points = [item for item in objects if item.primitive == POINT]
    network = ChainNodeNetwork(window, spatial)
    features = list(zip(spatial, network.references)) + boundary_lines(network)
    features += [(item, [Reference(ISOLATED_NODE, record_id)]) for record_id, item in enumerate(points, 1)]

    if os.path.exists(path):
        os.remove(path)
    options = _creation_options(header, features, len(points), network)
    dataset = gdal.GetDriverByName("S57").Create(path, 0, 0, 0, gdal.GDT_Unknown, options)
    for record_id, item in enumerate(points, 1):
        _write_primitive(dataset, "IsolatedNode", ISOLATED_NODE, record_id, _isolated_node_geometry(item))
    for point, record_id in network.nodes.items():
        _write_primitive(dataset, "ConnectedNode", CONNECTED_NODE, record_id, _point(point))
    for record_id, points_of_edge in enumerate(network.edges, 1):
        _write_edge(dataset, record_id, points_of_edge, network.nodes)
    for record_id, (item, references) in enumerate(features, 1):
        _write_feature(dataset, record_id, item, references)
    del dataset  # GDAL finishes the file when the dataset goes
    return CellSummary(len(features), len(points), len(network.nodes), len(network.edges), os.path.getsize(path))


def boundary_lines(network):
    """Coastlines where land meets water and contours where depth areas of different depth meet, one per edge."""
    lines = []
    for record_id, users in enumerate(network.users, 1):
        sides = [network.objects[place] for place in users if network.objects[place].is_group_one()]
        acronyms = sorted(side.acronym for side in sides)
        if len(sides) != 2:
            continue
        if acronyms.count("LNDARE") == 1:
            line = ChartObject("COALNE", {}, LINE, [])
        elif acronyms == ["DEPARE", "DEPARE"] and sides[0].attributes != sides[1].attributes:
            contour = max(side.attributes["DRVAL1"] for side in sides)
            line = ChartObject("DEPCNT", {"VALDCO": contour}, LINE, [])
        else:
            continue
        lines.append((line, [Reference(EDGE, record_id, FORWARD)]))
    return sorted(lines, key=lambda entry: entry[0].acronym)


def _creation_options(header, features, isolated_nodes, network):
    meta = sum(item.is_meta() for item, _ in features)
    values = {
        "EXPP": 1, "INTU": header.intended_use, "EDTN": header.edition, "UPDN": header.update, "UADT": header.date,
        "ISDT": header.date, "STED": "03.1", "AGEN": NO_AGENCY, "COMT": header.comment, "AALL": 0, "NALL": 0,
        "NOMR": meta, "NOGR": len(features) - meta, "NOLR": 0, "NOIN": isolated_nodes, "NOCN": len(network.nodes),
        "NOED": len(network.edges), "HDAT": 2, "VDAT": header.vertical_datum, "SDAT": header.sounding_datum,
        "CSCL": header.scale, "COMF": COMF, "SOMF": SOMF,
    }
    return [f"S57_{name}={value}" for name, value in values.items()]


def _point(point):
    geometry = ogr.Geometry(ogr.wkbPoint)
    geometry.AddPoint_2D(to_degrees(point[0]), to_degrees(point[1]))
    return geometry


def _isolated_node_geometry(item):
    if item.acronym != "SOUNDG":
        return _point(item.geometry[0])
    soundings = ogr.Geometry(ogr.wkbMultiPoint25D)
    for x, y, depth_m in item.geometry:
        sounding = ogr.Geometry(ogr.wkbPoint25D)
        sounding.AddPoint(to_degrees(x), to_degrees(y), depth_m)
        soundings.AddGeometry(sounding)
    return soundings


def _write_primitive(dataset, layer_name, record_name, record_id, geometry, fields=None):
    layer = dataset.GetLayerByName(layer_name)
    record = ogr.Feature(layer.GetLayerDefn())
    for name, value in {"RCNM": record_name, "RCID": record_id, **(fields or {})}.items():
        record.SetField(name, value)
    record.SetGeometry(geometry)
    layer.CreateFeature(record)


def _write_edge(dataset, record_id, points, nodes):
    """The record of an edge names its end nodes and stores only the points between them."""
    line = ogr.Geometry(ogr.wkbLineString)
    for x, y in points[1:-1]:
        line.AddPoint_2D(to_degrees(x), to_degrees(y))
    fields = {}
    for place, (point, topology) in enumerate(((points[0], BEGIN_NODE), (points[-1], END_NODE))):
        entry = {"NAME_RCNM": CONNECTED_NODE, "NAME_RCID": nodes[point], "ORNT": NOT_RELEVANT, "USAG": NOT_RELEVANT,
                 "TOPI": topology, "MASK": NOT_RELEVANT}
        fields.update({f"{name}_{place}": value for name, value in entry.items()})
    _write_primitive(dataset, "Edge", EDGE, record_id, line, fields)


def _write_feature(dataset, record_id, item, references):
    layer = dataset.GetLayerByName(item.acronym)
    if layer is None:
        raise CellWriteError(f"GDAL's S-57 driver knows no class {item.acronym}")
    feature = ogr.Feature(layer.GetLayerDefn())
    key = {"RCID": record_id, "PRIM": item.primitive, "GRUP": GROUP_ONE if item.is_group_one() else GROUP_TWO,
           "AGEN": NO_AGENCY, "FIDN": record_id, "FIDS": 1}
    for name, value in key.items():
        feature.SetField(name, value)
    for name, value in item.attributes.items():
        index = feature.GetFieldIndex(name)
        if index < 0:
            raise CellWriteError(f"GDAL's S-57 driver knows no attribute {name} of the class {item.acronym}")
        if isinstance(value, str) and not value.isascii():
            raise CellWriteError(f"{item.acronym} {name}: {value!r} is not ASCII, the only text of lexical level 0")
        if isinstance(value, (list, tuple)):
            feature.SetFieldStringList(index, [str(entry) for entry in value])
        else:
            feature.SetField(index, value)
    columns = {"NAME_RCNM": "record_name", "NAME_RCID": "record_id", "ORNT": "orientation", "USAG": "usage",
               "MASK": "mask"}
    for name, attribute in columns.items():
        values = [getattr(reference, attribute) for reference in references]
        feature.SetFieldIntegerList(feature.GetFieldIndex(name), values)
    layer.CreateFeature(feature)
