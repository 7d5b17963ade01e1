#include "PictureTitle.h"

#include <algorithm>
#include <sstream>

namespace seahex
{
namespace
{

constexpr double firstBaseline = 50.0;
constexpr double firstLine = 29.0;  // to the next baseline
constexpr double nextLine = 25.0;

}  // namespace

TextStyle fittedStyle(PictureCanvas &canvas, const std::string &text, TextStyle style, double room)
{
    for (double width = canvas.textWidth(text, style); width > room; width = canvas.textWidth(text, style))
        style.size *= std::min(room / width, 0.98);
    return style;
}

void drawTitle(PictureCanvas &canvas, const std::string &title)
{
    std::istringstream lines(title);
    std::string line;
    double baseline = firstBaseline;
    for (bool first = true; std::getline(lines, line); first = false)
    {
        const TextStyle style{first ? 27.0 : 18.0, first, false, 0.0, palette::ink};
        canvas.text({canvas.units(pictureLeft), canvas.units(baseline)}, line,
                    fittedStyle(canvas, line, style, canvas.units(pictureRight - pictureLeft)));
        baseline += first ? firstLine : nextLine;
    }
}

double titleHeight(const std::string &title)
{
    if (title.empty())
        return 0.0;
    return firstBaseline + nextLine * static_cast<double>(std::count(title.begin(), title.end(), '\n'));
}

}  // namespace seahex
