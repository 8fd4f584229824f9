#include "scenes/texture/weathering.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "scenes/texture/materials.h"
#include "scenes/texture/stamps.h"

namespace drydock::scenes {
namespace {

const Rgb kRustDark(58, 32, 22);
const Rgb kRustBright(142, 78, 38);
const Rgb kPrimer(168, 160, 148);
const Rgb kAlgaeDark(34, 40, 22);
const Rgb kAlgaeBright(90, 96, 52);
const Rgb kFilm(96, 88, 56);
const Rgb kSiltDark(116, 108, 86);
const Rgb kSiltBright(176, 166, 138);

/// The band of a field just inside its threshold for `fraction`.
cv::Mat1b Rim(const cv::Mat1f& field, double fraction, double width) {
  const cv::Mat1b outer = Coverage(field, fraction, 0.03);
  const cv::Mat1b inner = Coverage(field - static_cast<float>(width), fraction, 0.03);
  return outer - inner;
}

void Flake(Canvas& canvas, const Weathering& w, const cv::Mat1b& edges, const NoiseKeys& keys) {
  cv::Mat1f field = canvas.Noise(w.largest, 0.004, 0.68, keys.Key("flake"));
  if (!edges.empty()) AddMask(field, edges, w.edge_rust);
  const cv::Mat1f tone = canvas.Noise(0.08, 0.003, 0.75, keys.Key("rust tone"));
  // Chips: primer shows through, in a band round the rust and in spots of its own.
  canvas.Blend(Coverage(field, w.rust + w.primer, 0.04), tone, Rgb(132, 124, 112), kPrimer, 0.9);
  canvas.Blend(Coverage(field, w.rust, 0.05), tone, kRustDark, kRustBright, 0.95);
  canvas.Blend(Rim(field, w.rust, 0.10), Rgb(34, 20, 14), 0.75);
  cv::Mat1f spots = canvas.Noise(0.05, 0.004, 0.7, keys.Key("spots"));
  canvas.Blend(Coverage(spots, w.rust * 0.12, 0.06), tone, kRustDark, kRustBright, 0.85);
  // Where the rust is thick it scales off darkly.
  canvas.Blend(Coverage(field, w.rust * 0.35, 0.12), tone, Rgb(30, 20, 16), Rgb(84, 50, 32), 0.85);
}

void Streak(Canvas& canvas, const Weathering& w, const NoiseKeys& keys) {
  const cv::Mat1f thin = canvas.Noise(0.03, 0.005, 0.8, keys.Key("streaks"), 28.0);
  const cv::Mat1f where = canvas.Noise(0.7, 0.08, 0.6, keys.Key("streaks where"));
  canvas.Blend(Coverage(0.75F * thin + 0.65F * where, w.streaks * 0.5, 0.9), kRustDark, 0.55);
  canvas.Blend(Coverage(0.75F * thin - 0.65F * where, w.streaks * 0.35, 0.9), kSiltBright, 0.35);
}

}  // namespace

void Age(Canvas& canvas, const Weathering& w, const cv::Mat1b& edges, const NoiseKeys& keys) {
  canvas.Modulate(canvas.Noise(1.6, 0.05, 0.6, keys.Key("fading")), w.fading);
  Streak(canvas, w, keys);
  Flake(canvas, w, edges, keys);
  if (!edges.empty()) {
    cv::Mat1b grime = edges.clone();
    SoftenMask(grime, canvas.Pixels(0.012));
    canvas.Darken(grime, 0.35);
  }
  Overgrow(canvas, w, keys);
}

void Overgrow(Canvas& canvas, const Weathering& w, const NoiseKeys& keys) {
  const cv::Mat1f fine = canvas.Noise(0.02, 0.003, 0.8, keys.Key("fine"));
  cv::Mat1f film = canvas.Noise(0.9, 0.01, 0.62, keys.Key("film"));
  canvas.Blend(Coverage(film, w.film, 1.4), kFilm, 0.55);
  const cv::Mat1f algae = canvas.Noise(0.6, 0.006, 0.66, keys.Key("algae"));
  canvas.Blend(Coverage(algae, w.algae, 0.35), fine, kAlgaeDark, kAlgaeBright, 0.82);
  const cv::Mat1f silt = canvas.Noise(0.7, 0.005, 0.66, keys.Key("silt"));
  canvas.Blend(Coverage(silt, w.silt, 0.6), fine, kSiltDark, kSiltBright, w.silt_alpha);
  StampMussels(canvas, w.mussels, keys.Key("mussels"));
  canvas.Modulate(fine, w.grain);
  // Specks: what a camera close by holds on to.
  const cv::Mat1f specks = canvas.Noise(0.011, 0.005, 0.8, keys.Key("specks"));
  canvas.Blend(Coverage(specks, w.specks, 0.5), Rgb(36, 32, 26), 0.6);
  canvas.Blend(Coverage(-specks, 0.6 * w.specks, 0.5), Rgb(196, 188, 166), 0.55);
}

void PaintRust(Canvas& canvas, const NoiseKeys& keys) {
  const cv::Mat1f large = canvas.Noise(0.35, 0.004, 0.7, keys.Key("rust large"));
  const cv::Mat1f fine = canvas.Noise(0.04, 0.003, 0.8, keys.Key("rust fine"));
  canvas.Blend(Everywhere(canvas), fine, kRustDark, kRustBright);
  canvas.Blend(Coverage(large, 0.376, 0.15), fine, Rgb(34, 24, 20), Rgb(88, 56, 38), 0.9);
  canvas.Blend(Coverage(-large, 0.071, 0.1), fine, Rgb(140, 84, 44), Rgb(190, 122, 64), 0.8);
  canvas.Blend(Rim(large, 0.4, 0.09), Rgb(22, 15, 12), 0.7);
}

}  // namespace drydock::scenes
