// Draws docs/images/gallery.jpg:
//
//   build/release/bin/draw_gallery docs/images/gallery.jpg
#include <exception>
#include <iostream>

#include "scenarios/gallery/gallery.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: draw_gallery PICTURE.jpg\n";
    return 2;
  }
  try {
    drydock::WriteGallery(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "draw_gallery: " << error.what() << '\n';
    return 2;
  }
}
