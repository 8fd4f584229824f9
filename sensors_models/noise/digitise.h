// The end of every digital sensor: limited range, limited resolution.
#pragma once

namespace drydock {

/// What a converter says of `value`: clipped to [-range, range], then rounded to the nearest whole
/// number of steps of `resolution` (halves away from zero), and never beyond the last whole step
/// within the range. All in the same unit; a range or resolution of 0 is none.
double Digitise(double value, double range, double resolution);

}  // namespace drydock
