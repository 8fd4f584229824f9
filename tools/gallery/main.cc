// Draws waters.jpg, dives.jpg, effects.jpg and preprocessing.jpg of the docs:
//
//   build/release/bin/draw_gallery docs/images
#include <exception>
#include <filesystem>
#include <iostream>

#include "scenarios/gallery/gallery.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: draw_gallery DIRECTORY\n";
    return 2;
  }
  try {
    const std::filesystem::path directory = argv[1];
    drydock::WriteWaters(directory / "waters.jpg");
    drydock::WriteDives(directory / "dives.jpg");
    drydock::WriteEffects(directory / "effects.jpg");
    drydock::WritePreprocessing(directory / "preprocessing.jpg");
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "draw_gallery: " << error.what() << '\n';
    return 2;
  }
}
