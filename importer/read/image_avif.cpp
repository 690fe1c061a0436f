// SPDX-License-Identifier: MIT
#include "importer/read/image_avif.h"

#include <avif/avif.h>

#ifdef SINEW_AVIF_LIBRARY
#include <dlfcn.h>
#endif

#include <algorithm>
#include <cstring>
#include <memory>

namespace sinew {
namespace {

/// The functions of libavif that are called. The library and its encoders load 26 libraries, which takes 4 ms of each
/// program start. So if SINEW_AVIF_LIBRARY names the library, it is loaded with the first AVIF image; otherwise it is
/// linked.
struct Avif {
  decltype(&avifPeekCompatibleFileType) peek_type;
  decltype(&avifDecoderCreate) create;
  decltype(&avifDecoderDestroy) destroy;
  decltype(&avifDecoderSetSource) set_source;
  decltype(&avifDecoderSetIOMemory) set_memory;
  decltype(&avifDecoderParse) parse;
  decltype(&avifDecoderNextImage) next_image;
  decltype(&avifRGBImageSetDefaults) set_defaults;
  decltype(&avifImageYUVToRGB) to_rgb;
};

#ifdef SINEW_AVIF_LIBRARY
template <class Function>
bool find(void* library, const char* name, Function& function) {
  function = library == nullptr ? nullptr : reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

/// The loaded library.     out   null if it is not installed
const Avif* avif() {
  static const std::unique_ptr<Avif> loaded = [] {
    auto out = std::make_unique<Avif>();
    void* library = dlopen(SINEW_AVIF_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    const bool complete =
        find(library, "avifPeekCompatibleFileType", out->peek_type) &&
        find(library, "avifDecoderCreate", out->create) && find(library, "avifDecoderDestroy", out->destroy) &&
        find(library, "avifDecoderSetSource", out->set_source) &&
        find(library, "avifDecoderSetIOMemory", out->set_memory) && find(library, "avifDecoderParse", out->parse) &&
        find(library, "avifDecoderNextImage", out->next_image) &&
        find(library, "avifRGBImageSetDefaults", out->set_defaults) && find(library, "avifImageYUVToRGB", out->to_rgb);
    return complete ? std::move(out) : nullptr;
  }();
  return loaded.get();
}
#else
const Avif* avif() {
  static constexpr Avif kLinked{avifPeekCompatibleFileType, avifDecoderCreate,       avifDecoderDestroy,
                                avifDecoderSetSource,       avifDecoderSetIOMemory,  avifDecoderParse,
                                avifDecoderNextImage,       avifRGBImageSetDefaults, avifImageYUVToRGB};
  return &kLinked;
}
#endif

/// True if the file begins with a box of this name, as AVIF files do. Only such files load the library.
bool has_file_type_box(std::span<const std::byte> encoded) {
  return encoded.size() >= 12 && std::memcmp(encoded.data() + 4, "ftyp", 4) == 0;
}

void destroy(avifDecoder* decoder) { avif()->destroy(decoder); }

using Decoder = std::unique_ptr<avifDecoder, void (*)(avifDecoder*)>;

/// Opens a decoder and reads the header; null on error.    in   most_pixels  limit for any image in the file
Decoder open(std::span<const std::byte> encoded, std::uint64_t most_pixels) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(encoded.data());
  const avifROData head{bytes, encoded.size()};
  if (!has_file_type_box(encoded) || avif() == nullptr || avif()->peek_type(&head) == AVIF_FALSE)
    return {nullptr, destroy};
  Decoder decoder(avif()->create(), destroy);
  if (!decoder) return decoder;
  decoder->maxThreads = 1;
  decoder->ignoreExif = decoder->ignoreXMP = AVIF_TRUE;
  decoder->strictFlags = AVIF_STRICT_DISABLED;  // accept files whose encoder omitted required boxes
  decoder->imageSizeLimit =
      static_cast<std::uint32_t>(std::min<std::uint64_t>(most_pixels, AVIF_DEFAULT_IMAGE_SIZE_LIMIT));
  const bool is_open = avif()->set_source(decoder.get(), AVIF_DECODER_SOURCE_PRIMARY_ITEM) == AVIF_RESULT_OK &&
                       avif()->set_memory(decoder.get(), bytes, encoded.size()) == AVIF_RESULT_OK &&
                       avif()->parse(decoder.get()) == AVIF_RESULT_OK;
  if (!is_open) decoder.reset();
  return decoder;
}

}  // namespace

std::optional<ImageHeader> probe_avif(std::span<const std::byte> encoded) {
  const Decoder decoder = open(encoded, AVIF_DEFAULT_IMAGE_SIZE_LIMIT);
  if (!decoder) return std::nullopt;
  return ImageHeader{decoder->image->width, decoder->image->height, "image/avif"};
}

tl::expected<std::vector<std::uint8_t>, std::string> decode_avif(std::span<const std::byte> encoded,
                                                                 const ImageHeader& size) {
  const auto damaged = tl::make_unexpected(std::string("its AVIF data are damaged"));
  const Decoder decoder = open(encoded, size.pixels());
  if (!decoder || avif()->next_image(decoder.get()) != AVIF_RESULT_OK) return damaged;
  const avifImage& image = *decoder->image;
  if (image.width != size.width || image.height != size.height) return damaged;
  std::vector<std::uint8_t> rgba(4 * size.pixels());
  avifRGBImage out;
  avif()->set_defaults(&out, &image);
  out.format = AVIF_RGB_FORMAT_RGBA;
  out.depth = 8;
  out.pixels = rgba.data();
  out.rowBytes = 4 * size.width;
  if (avif()->to_rgb(&image, &out) != AVIF_RESULT_OK) return damaged;
  return rgba;
}

}  // namespace sinew
