// Where each baked table lies among the texels that shaders read: four numbers per texel, nodes in
// the order of their axes, channels of a node in consecutive texels. The host packs them
// (host/tables/texels.h), and a test holds these numbers to what it packs.
#ifndef LQ_TABLES_TEXELS_GLSL
#define LQ_TABLES_TEXELS_GLSL

// Columns of a texture that holds the texels row after row, from (0, 0) on.
const int LQ_TABLE_COLUMNS = 128;

// Nodes per axis.
const int LQ_TABLE_ALPHAS = 16;
const int LQ_TABLE_ETAS = 16;
const int LQ_T_DOWN_THIN_ETAS = 24;
const int LQ_TABLE_TAUS = 33;
const int LQ_MIRROR_ALPHAS = 24;
const int LQ_LOBE_VARIANCES = 65;

// Texels per node.
const int LQ_T_DOWN_THIN_TEXELS = 8;
const int LQ_T_DOWN_DENSE_TEXELS = 10;
const int LQ_ABSORPTION_TEXELS = 2;
const int LQ_R_UP_TEXELS = 2;
const int LQ_MULTIPLE_TEXELS = 2;

// The first texel of each array. "Thin" is for eta < 1, "dense" for eta >= 1.
const int LQ_T_DOWN_THIN_BELOW = 0;
const int LQ_T_DOWN_THIN_ABOVE = 3072;
const int LQ_T_DOWN_THIN_ABSORPTION = 6144;
const int LQ_T_DOWN_DENSE_ABOVE = 6210;
const int LQ_T_DOWN_DENSE_ABSORPTION = 8770;
const int LQ_R_UP_THIN_MAPS = 8836;
const int LQ_R_UP_THIN_ABSORPTION = 9348;
const int LQ_R_UP_DENSE_MAPS = 9414;
const int LQ_R_UP_DENSE_ABSORPTION = 9926;
const int LQ_MULTIPLE_THIN_BELOW = 9992;
const int LQ_MULTIPLE_THIN_ABOVE = 10504;
const int LQ_MULTIPLE_DENSE_ABOVE = 11016;
const int LQ_LOBE_ENERGY = 11528;
const int LQ_LOBE_ALPHA = 11552;

#endif
