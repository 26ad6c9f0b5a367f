// A table as a picture, for eyes and image tools.
#pragma once

#include "image/image.h"
#include "tables/table.h"

namespace lacquer::bake {

// Every channel of every array as a grey tile, from the top: rows run along the first axis, columns
// along the second. Numbers are the table's own.
Image picture_of(const Table& table);

}  // namespace lacquer::bake
