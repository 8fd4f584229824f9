// Small things drawn one by one: mussels, pebbles, shells, leaves, twigs, rivets.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes/texture/canvas.h"
#include "sensors_models/base/random_stream.h"

namespace drydock::scenes {

/// Mussels and barnacles in clusters, on the average `density` [1/m^2].
void StampMussels(Canvas& canvas, double density, std::uint64_t key);

/// One pebble with a dark foot; radius [m].
void DrawPebble(Canvas& canvas, double x, double y, double radius, RandomStream& random);
/// Half a bright shell; length [m].
void DrawShell(Canvas& canvas, double x, double y, double length, RandomStream& random);
/// A dead leaf with its rib; length [m].
void DrawLeaf(Canvas& canvas, double x, double y, double length, RandomStream& random);
/// A crooked twig; length [m].
void DrawTwig(Canvas& canvas, double x, double y, double length, RandomStream& random);
/// A rivet's or a screw's head; also white on `edges`, where rust starts.
void DrawRivet(Canvas& canvas, cv::Mat1b& edges, double x, double y, double radius);

/// A filled ellipse of half axes a and b [m], a turned from x towards y by `angle` [rad].
void FillEllipse(Canvas& canvas, double x, double y, double a, double b, double angle,
                 const Rgb& color);
/// A filled polygon or a line, corners [m].
void FillPolygon(Canvas& canvas, const std::vector<cv::Point2d>& corners, const Rgb& color);
void DrawLine(Canvas& canvas, cv::Point2d from, cv::Point2d to, double width, const Rgb& color);
void DrawLine(const Canvas& canvas, cv::Mat1b& mask, cv::Point2d from, cv::Point2d to,
              double width);
void FillRectangle(Canvas& canvas, cv::Point2d low, cv::Point2d high, const Rgb& color);

/// Block letters `height` [m] tall, centred on (x, y), as wide as they come; `weight` is the
/// strokes' width as a fraction of the height. `squeeze` < 1 makes them narrower.
void DrawText(Canvas& canvas, const std::string& text, double x, double y, double height,
              double weight, const Rgb& color, double squeeze = 1.0);

}  // namespace drydock::scenes
