// SPDX-License-Identifier: BSD-3-Clause
// stb_image, to read what was drawn.
#pragma once

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wpragmas"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop
