// Draws docs/images/gallery.jpg and preprocessing.jpg:
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
    drydock::WriteGallery(directory / "gallery.jpg");
    drydock::WritePreprocessing(directory / "preprocessing.jpg");
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "draw_gallery: " << error.what() << '\n';
    return 2;
  }
}
