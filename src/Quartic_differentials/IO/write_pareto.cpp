// Copyright (c) 2026 The CGAL Quartic Differentials authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quartic_differentials/IO/write_pareto.h>
#include <CGAL/Quartic_differentials/internal/Text_writer.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace CGAL {
namespace Quartic_differentials {

namespace {

using internal::Text_writer;

const double left = 70, right = 620, panel_height = 220, gap = 60, top = 40;   // of the picture, pixels

double rounded(double x) { return std::round(10 * x) / 10; }

// A diagram of positive values over counts, both with their axes.
class Panel
{
public:
  Panel(Text_writer& out, double y, std::pair<int, int> counts, std::pair<double, double> values)
    : m_out(out), m_y(y), m_counts(counts), m_values(values) {}

  double x(double count) const
  { return rounded(left + (right - left) * (count - m_counts.first) / std::max(m_counts.second - m_counts.first, 1)); }
  double y(double value) const
  {
    const double range = std::log(m_values.second / m_values.first);
    return rounded(m_y + panel_height * (1 - std::log(value / m_values.first) / std::max(range, 1e-9)));
  }

  void axes(const char* title)
  {
    m_out << "<text x=\"" << left << "\" y=\"" << m_y - 12 << "\" class=\"title\">" << title << "</text>\n";
    const int step = std::max(2, 2 * static_cast<int>(std::ceil((m_counts.second - m_counts.first) / 24.0)));
    for (int n = m_counts.first; n <= m_counts.second; n += step) {
      line(x(n), m_y, x(n), m_y + panel_height, "grid");
      text(x(n), m_y + panel_height + 16, "middle", n);
    }
    for (int exponent = static_cast<int>(std::floor(std::log10(m_values.first))); exponent < 9; ++exponent)
      for (int digit : {1, 2, 5}) {
        const double value = digit * std::pow(10.0, exponent);
        if (value < m_values.first || value > m_values.second) continue;
        line(left, y(value), right, y(value), "grid");
        text(left - 8, y(value) + 4, "end", std::round(value * 1e6) / 1e6);
      }
  }
  void line(double x1, double y1, double x2, double y2, const char* style)
  {
    m_out << "<line x1=\"" << x1 << "\" y1=\"" << y1 << "\" x2=\"" << x2 << "\" y2=\"" << y2 << "\" class=\"" << style
          << "\"/>\n";
  }
  template <class Value>
  void curve(const std::vector<Pareto_point>& points, int chosen, Value value)
  {
    m_out << "<polyline class=\"curve\" points=\"";
    for (const Pareto_point& p : points) m_out << x(p.count) << ',' << y(value(p)) << ' ';
    m_out << "\"/>\n";
    for (const Pareto_point& p : points)
      m_out << "<circle cx=\"" << x(p.count) << "\" cy=\"" << y(value(p)) << "\" r=\"" << (p.count == chosen ? 6 : 3)
            << "\" class=\"" << (p.count == chosen ? "chosen" : "point") << "\"/>\n";
  }

private:
  template <class Number>
  void text(double x, double y, const char* anchor, Number n)
  {
    m_out << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\">" << n << "</text>\n";
  }

  Text_writer&              m_out;
  double                    m_y;
  std::pair<int, int>       m_counts;
  std::pair<double, double> m_values;
};

template <class Value>
std::pair<double, double> range(const std::vector<Pareto_point>& points, Value value)
{
  std::pair<double, double> r(value(points.front()), value(points.front()));
  for (const Pareto_point& p : points) r = {std::min(r.first, value(p)), std::max(r.second, value(p))};
  return {0.9 * r.first, 1.1 * r.second};
}

} // namespace

void write_pareto_csv(std::ostream& stream, const std::vector<Pareto_point>& points)
{
  Text_writer out(stream);
  out << "count,distortion,area_scale_99_to_1_percent\n";
  for (const Pareto_point& p : points) out << p.count << ',' << p.distortion << ',' << p.area_scale_ratio << '\n';
  out.finish();
}

void write_pareto_svg(std::ostream& stream, const std::vector<Pareto_point>& points, int chosen, double wanted)
{
  const auto distortion = [](const Pareto_point& p) { return p.distortion; };
  const auto ratio = [](const Pareto_point& p) { return p.area_scale_ratio; };
  const std::pair<int, int> counts(points.front().count, points.back().count);
  std::pair<double, double> distortions = range(points, distortion);
  distortions = {std::min(distortions.first, 0.9 * wanted), std::max(distortions.second, 1.1 * wanted)};

  Text_writer out(stream);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 650 600\" width=\"650\" height=\"600\">\n"
         "<style>text{font:12px sans-serif}.title{font-weight:bold}.grid{stroke:#ddd}.curve{fill:none;stroke:#268}"
         ".point{fill:#268}.chosen{fill:#c40}.wanted{stroke:#c40;stroke-dasharray:6 4}</style>\n"
         "<rect width=\"650\" height=\"600\" fill=\"#fff\"/>\n";
  Panel upper(out, top, counts, distortions);
  upper.axes("area distortion (mean square of the log scale of lengths)");
  upper.line(left, upper.y(wanted), right, upper.y(wanted), "wanted");
  upper.curve(points, chosen, distortion);
  Panel lower(out, top + panel_height + gap, counts, range(points, ratio));
  lower.axes("area scale, 99% / 1% quantile");
  lower.curve(points, chosen, ratio);
  out << "<text x=\"" << (left + right) / 2 << "\" y=\"" << top + 2 * panel_height + gap + 40
      << "\" text-anchor=\"middle\">number of singularities</text>\n</svg>\n";
  out.finish();
}

} } // namespace CGAL::Quartic_differentials
