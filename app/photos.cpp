#include "app/photos.hpp"

#include "app/exit_codes.hpp"
#include "app/files.hpp"
#include "beam/trace.hpp"
#include "photos/photos.hpp"
#include "photos/textured.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <CLI/CLI.hpp>
#include <system_error>

namespace sightline::app {

namespace {

std::filesystem::path beside(std::filesystem::path output, const std::string& ending) {
  output.replace_extension();
  output += ending;
  return output;
}

/// Which polygon each pixel of each photograph shows.
std::vector<PixelOwners> owners_of(const PhotoCommand& command, std::span<const Image> images, const Scene& scene,
                                   std::span<const Camera> cameras, const ClipOptions& options) {
  const BspTree tree(scene);
  const Tracer prepared(tree);
  std::vector<PixelOwners> owners(images.size());
  tbb::task_arena arena(static_cast<int>(options.threads));
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t c) {
      Tracer tracer(prepared);
      VisibilityMap map;
      tracer.trace(cameras[c], map);
      const auto regions = c < options.regions.size() ? std::span<const TextureRegion>(options.regions[c])
                                                      : std::span<const TextureRegion>();
      owners[c] = pixel_owners(map, scene, images[c].width, images[c].height, command.guard, regions);
    });
  });
  return owners;
}

}  // namespace

void add_photo_options(CLI::App& command, PhotoCommand& options) {
  CLI::Option* photos =
      command
          .add_option("--photos", options.folder, "Photographs DIR/0000.png .. of the cameras, to texture pieces with")
          ->type_name("DIR");
  command
      .add_option("--guard", options.guard, "Pixels along silhouettes that are not used (default 1; 0: all are used)")
      ->check(CLI::Range(0, 64))
      ->needs(photos)
      ->type_name("N");
  command.add_option("--density", options.density, "Texels for each pixel along a side (default 1)")
      ->check(CLI::Range(0.01, 16.0))
      ->needs(photos)
      ->type_name("X");
  command.add_option("--page", options.page, "Longest side of a texture image (default 4096)")
      ->check(CLI::Range(64, 32767))
      ->needs(photos)
      ->type_name("N");
}

std::vector<Image> read_photos(const PhotoCommand& command, std::span<const Camera> cameras) {
  std::vector<Image> images;
  if (command.folder.empty()) return images;
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    std::string digits = std::to_string(c);
    if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
    const std::filesystem::path file = command.folder / (digits + ".png");
    images.push_back(read_png(file));
    check_aspect(images.back(), cameras[c], file.string());
  }
  return images;
}

void check_textured(const std::filesystem::path& output, const std::filesystem::path& input) {
  std::error_code error;  // where one of them does not exist they differ
  if (std::filesystem::equivalent(beside(output, ".obj"), input, error)) {
    throw UsageError("-o " + output.string() + ": with --photos, " + beside(output, ".obj").string() +
                     " is written beside it and would replace the scene");
  }
}

PhotoFigures write_textured(const PhotoCommand& command, std::vector<Image> images, const Scene& scene,
                            std::span<const Camera> cameras, const ClipOptions& options, const ClipResult& clipped,
                            const std::filesystem::path& output) {
  std::vector<PixelOwners> owners = owners_of(command, images, scene, cameras, options);
  std::vector<Photograph> photographs;
  for (std::size_t c = 0; c < images.size(); ++c) {
    photographs.emplace_back(scene, cameras[c], std::move(images[c]), std::move(owners[c]));
  }
  PhotoOptions photo_options;
  photo_options.reach = command.guard + 1;
  photo_options.density = command.density;
  photo_options.page = command.page;
  photo_options.threads = options.threads;
  const PhotoTextures textures = map_photos(scene, clipped, photographs, photo_options);

  std::vector<std::string> pages;
  for (std::size_t k = 0; k < textures.pages.size(); ++k) {
    const std::filesystem::path file = beside(output, "-" + std::to_string(k) + ".png");
    write_text(file, png(textures.pages[k]));
    pages.push_back(file.filename().string());
  }
  const std::filesystem::path materials = beside(output, ".mtl");
  write_text(materials, textured_mtl(pages));
  write_text(beside(output, ".obj"), textured_obj(scene, clipped, textures, materials.filename().string()));
  return {textures.stats, command.guard, pages.size()};
}

}  // namespace sightline::app
