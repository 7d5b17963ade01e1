#include "CellGrid.h"

#include <algorithm>

namespace seahex
{

namespace
{

constexpr double lineWidth = 0.45;
constexpr double lineOpacity = 0.16;
constexpr double leastPitch = 6.0;  // units of type

class CellGrid
{
public:
    CellGrid(PictureCanvas &canvas, const Lattice &lattice, const CellWindow &window)
        : canvas_(canvas), lattice_(lattice), firstColumn_(std::max<std::int64_t>(window.firstColumn, 0)),
          lastColumn_(std::min(window.lastColumn, lattice.columns())),
          firstRow_(std::max<std::int64_t>(window.firstRow, 0)), lastRow_(std::min(window.lastRow, lattice.rows()))
    {
    }

    void drawSquares()
    {
        for (std::int64_t row = firstRow_; row <= lastRow_; ++row)
            addLine(northWestOf(firstColumn_, row), northWestOf(lastColumn_, row));
        for (std::int64_t column = firstColumn_; column <= lastColumn_; ++column)
            addLine(northWestOf(column, firstRow_), northWestOf(column, lastRow_));
        stroke();
    }

    void drawHexagons()
    {
        addZigzags();
        stroke();
        addUprights();
        // Along one meridian of the lattice the upright edges are as long as a side and two sides apart.
        const double sidePx = lattice_.halfHeight() * canvas_.frame().pxPerUnitY;
        const double dashes[] = {sidePx, 2.0 * sidePx};
        cairo_set_line_cap(canvas_.cairo(), CAIRO_LINE_CAP_BUTT);
        cairo_set_dash(canvas_.cairo(), dashes, 2, 0.0);
        stroke();
    }

private:
    CellCorner northWestOf(std::int64_t column, std::int64_t row) const
    {
        return cornersOf(lattice_, {column, row}).front();
    }

    void addLine(CellCorner from, CellCorner to)
    {
        const Point a = toPage(canvas_.frame(), lattice_, from);
        const Point b = toPage(canvas_.frame(), lattice_, to);
        cairo_move_to(canvas_.cairo(), a.x(), a.y());
        cairo_line_to(canvas_.cairo(), b.x(), b.y());
    }

    void stroke() { canvas_.stroke(palette::ink, lineWidth, lineOpacity); }

    // The line between each two rows.
    void addZigzags()
    {
        for (std::int64_t row = firstRow_; row <= lastRow_; ++row)
        {
            cairo_new_sub_path(canvas_.cairo());
            for (std::int64_t column = firstColumn_; column <= lastColumn_; ++column)
            {
                const CellCorners corners = cornersOf(lattice_, {column, row});
                for (const CellCorner corner : {corners[5], corners[0]})
                {
                    const Point page = toPage(canvas_.frame(), lattice_, corner);
                    cairo_line_to(canvas_.cairo(), page.x(), page.y());
                }
            }
        }
    }

    // Lines along the western edges of every second row, to be dashed.
    void addUprights()
    {
        const std::int64_t lastRow = std::min(lastRow_, lattice_.rows() - 1);
        for (std::int64_t row = firstRow_; row <= std::min(firstRow_ + 1, lastRow); ++row)
            for (std::int64_t column = firstColumn_; column <= lastColumn_; ++column)
            {
                const std::int64_t end = lastRow - (lastRow - row) % 2;
                addLine(cornersOf(lattice_, {column, row})[5], cornersOf(lattice_, {column, end})[4]);
            }
    }

    PictureCanvas &canvas_;
    const Lattice &lattice_;
    std::int64_t firstColumn_;
    std::int64_t lastColumn_;  ///< one beyond the lattice, if in view: its western edge is the last cell's eastern one
    std::int64_t firstRow_;
    std::int64_t lastRow_;  ///< likewise
};

}  // namespace

void drawCellGrid(PictureCanvas &canvas, const Lattice &lattice, const CellWindow &window)
{
    if (lattice.pitch() * canvas.frame().pxPerUnitX < canvas.units(leastPitch))
        return;
    cairo_save(canvas.cairo());  // the dashes and the ends of lines are the grid's own
    CellGrid grid(canvas, lattice, window);
    if (lattice.squares() != nullptr)
        grid.drawSquares();
    else
        grid.drawHexagons();
    cairo_restore(canvas.cairo());
}

}  // namespace seahex
