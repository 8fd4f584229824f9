#include "scenarios/report/trajectory_plot.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "scenarios/report/axes.h"
#include "scenarios/report/canvas.h"

namespace drydock::report {
namespace {

constexpr double kWidth = 1200.0;
constexpr double kLeft = 66.0;     ///< Of every frame, for its labels [px].
constexpr double kRight = 24.0;    ///< Margin [px].
constexpr double kHeader = 92.0;   ///< Title and legend [px].
constexpr double kBetween = 78.0;  ///< From a frame's bottom to the next one's top [px].
constexpr double kFooter = 46.0;
constexpr double kInnerWidth = kWidth - kLeft - kRight;
constexpr double kErrorHeight = 170.0;
constexpr double kMargin = 0.06;    ///< Around the paths, as a share of their size.
constexpr double kMinLength = 0.5;  ///< Of a scale of positions [m].
constexpr double kTruthThickness = 3.0;
constexpr double kLineThickness = 1.7;
constexpr Duration kGap{kNanosecondsPerSecond};

/// A line of the plot with the colour it has in all panels.
struct Line {
  std::string name;
  const Trajectory& trajectory;
  Color color;
  double thickness;
};

using Value = std::function<std::optional<double>(const StampedPose&)>;

Value Coordinate(int axis) {
  return [axis](const StampedPose& pose) { return pose.T_WI.p()(axis); };
}

Range RangeOfAll(const std::vector<Line>& lines, const Value& value) {
  std::vector<double> values;
  for (const Line& line : lines) {
    for (const StampedPose& pose : line.trajectory) {
      if (const auto v = value(pose)) values.push_back(*v);
    }
  }
  const Range range = RangeOf(values, kMinLength);
  const double margin = kMargin * range.Length();
  return {range.low - margin, range.high + margin};
}

void DrawLine(Canvas& canvas, const Axes& axes, const Line& line, const Value& x, const Value& y) {
  std::vector<cv::Point2d> points;
  const auto flush = [&] {
    canvas.Polyline(points, line.color, line.thickness);
    points.clear();
  };
  std::optional<Time> last;
  for (const StampedPose& pose : line.trajectory) {
    const auto a = x(pose);
    const auto b = y(pose);
    if (!a || !b || (last && pose.t - *last > kGap)) flush();
    last = pose.t;
    if (a && b) points.push_back(axes.ToCanvas(*a, *b));
  }
  flush();
}

void DrawStart(Canvas& canvas, cv::Point2d at) {
  canvas.FillCircle(at, 7.0, kInk);
  canvas.FillCircle(at, 4.5, kPaper);
}

void DrawEnd(Canvas& canvas, cv::Point2d at) { canvas.FillCircle(at, 3.0, kInk); }

/// A ring where the truth begins and a dot where it ends.
void DrawEnds(Canvas& canvas, const Axes& axes, const Trajectory& truth, const Value& x,
              const Value& y) {
  if (truth.empty()) return;
  const auto at = [&](const StampedPose& pose) { return axes.ToCanvas(*x(pose), *y(pose)); };
  DrawStart(canvas, at(truth.front()));
  DrawEnd(canvas, at(truth.back()));
}

/// One projection: which coordinates go right and up.
struct View {
  std::string title;
  std::string x_label;
  int right;
  int up;
  double height;  ///< Of the frame [px].
};

double FrameHeight(const std::vector<Line>& lines, int right, int up, double low, double high) {
  const double share =
      RangeOfAll(lines, Coordinate(up)).Length() / RangeOfAll(lines, Coordinate(right)).Length();
  return std::clamp(share * kInnerWidth, low, high);
}

void DrawView(Canvas& canvas, double top, const View& view, const std::vector<Line>& lines) {
  const Value x = Coordinate(view.right);
  const Value y = Coordinate(view.up);
  const Axes axes = Axes::WithEqualScales({kLeft, top, kInnerWidth, view.height},
                                          RangeOfAll(lines, x), RangeOfAll(lines, y));
  axes.Draw(canvas, view.title, view.x_label);
  for (const Line& line : lines) DrawLine(canvas, axes, line, x, y);
  DrawEnds(canvas, axes, lines.front().trajectory, x, y);
}

void DrawErrors(Canvas& canvas, double top, const std::vector<Line>& lines) {
  const Trajectory& truth = lines.front().trajectory;
  const Time start = truth.empty() ? Time{0} : truth.front().t;
  const Value seconds = [start](const StampedPose& pose) { return (pose.t - start).Seconds(); };
  const Value error = [&truth](const StampedPose& pose) -> std::optional<double> {
    const auto there = Interpolate(truth, pose.t);
    if (!there) return std::nullopt;
    return (there->p() - pose.T_WI.p()).norm();
  };
  const std::vector<Line> estimates(lines.begin() + 1, lines.end());
  Range time{0.0, truth.empty() ? 1.0 : (truth.back().t - start).Seconds()};
  time.high = std::max(time.high, 1e-3);
  std::vector<double> errors;
  for (const Line& line : estimates) {
    for (const StampedPose& pose : line.trajectory) {
      if (const auto value = error(pose)) errors.push_back(*value);
    }
  }
  const double highest = errors.empty() ? 0.0 : *std::max_element(errors.begin(), errors.end());
  const Axes axes({kLeft, top, kInnerWidth, kErrorHeight}, time,
                  {0.0, std::max(1.1 * highest, 1e-3)});
  axes.Draw(canvas, "Distance from the truth [m]", "time [s]");
  for (const Line& line : estimates) DrawLine(canvas, axes, line, seconds, error);
}

/// Cuts a text that is wider than `width` px and puts dots in its place.
std::string Fit(std::string text, double size, double width) {
  if (Canvas::TextWidth(text, size) <= width) return text;
  while (!text.empty() && Canvas::TextWidth(text + "...", size) > width) text.pop_back();
  return text + "...";
}

void DrawHeader(Canvas& canvas, const std::string& title, const std::vector<Line>& lines) {
  canvas.Text(Fit(title, 14.0, kInnerWidth), {kLeft, 28.0}, 14.0, kInk);
  constexpr double kSample = 30.0;
  constexpr double kEnds = 130.0;  // The legend of start and end, at the right.
  const double widest = (kInnerWidth - kEnds) / static_cast<double>(lines.size()) - kSample - 30.0;
  double x = kLeft;
  for (const Line& line : lines) {
    const std::string name = Fit(line.name, 10.0, std::max(widest, 40.0));
    canvas.Line({x, 48.0}, {x + kSample, 48.0}, line.color, line.thickness);
    canvas.Text(name, {x + kSample + 8.0, 53.0}, 10.0, kInk);
    x += kSample + 8.0 + Canvas::TextWidth(name, 10.0) + 22.0;
  }
  const double right = kLeft + kInnerWidth;
  DrawStart(canvas, {right - kEnds + 12.0, 48.0});
  canvas.Text("start", {right - kEnds + 26.0, 53.0}, 10.0, kInk);
  DrawEnd(canvas, {right - 46.0, 48.0});
  canvas.Text("end", {right, 53.0}, 10.0, kInk, TextAnchor::kRight);
}

std::vector<View> ChooseViews(const std::vector<Line>& lines) {
  const double x_length = RangeOfAll(lines, Coordinate(0)).Length();
  const double y_length = RangeOfAll(lines, Coordinate(1)).Length();
  const int along = y_length > x_length ? 1 : 0;
  const std::string name = along == 0 ? "x" : "y";
  return {{"From above: y [m] over x [m]", "x [m]", 0, 1, FrameHeight(lines, 0, 1, 260.0, 640.0)},
          {"From the side: z [m] over " + name + " [m]", name + " [m]", along, 2,
           FrameHeight(lines, along, 2, 150.0, 320.0)}};
}

}  // namespace

cv::Mat DrawTrajectories(const std::string& title, const Trajectory& truth,
                         const std::vector<NamedTrajectory>& estimates) {
  std::vector<Line> lines = {{"truth", truth, Color{150, 150, 150}, kTruthThickness}};
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    lines.push_back({estimates[i].name, estimates[i].trajectory, PaletteColor(i), kLineThickness});
  }
  const std::vector<View> views = ChooseViews(lines);
  double height = kHeader + kFooter - kBetween;
  for (const View& view : views) height += view.height + kBetween;
  if (!estimates.empty()) height += kErrorHeight + kBetween;

  Canvas canvas(static_cast<int>(kWidth), static_cast<int>(height), kPaper);
  DrawHeader(canvas, title, lines);
  double top = kHeader;
  for (const View& view : views) {
    DrawView(canvas, top, view, lines);
    top += view.height + kBetween;
  }
  if (!estimates.empty()) DrawErrors(canvas, top, lines);
  return canvas.Finish();
}

}  // namespace drydock::report
